! SPDX-License-Identifier: MIT

!> For Fortran 77: the arithmetic-geometric mean, the complete integrals K, E, B, D.
! allow(C121)
module furiko_f77_complete
   use furiko_agm
   use furiko_complete
   implicit none
   public
end module furiko_f77_complete


include 'furiko_f77_complete.inc'
include 'furiko_f77_complete_real.inc'
! rooms: 4123459550
