! SPDX-License-Identifier: MIT

!> For Fortran 77: F, E, D, Pi, J, the inverse of E, and S.
! allow(C121)
module furiko_f77_incomplete
   use furiko_ellipj
   use furiko_ellips
   use furiko_incomplete
   use furiko_second_inverse
   use furiko_third_kind
   implicit none
   public
end module furiko_f77_incomplete


include 'furiko_f77_incomplete.inc'
include 'furiko_f77_incomplete_real.inc'
! rooms: 1771991253
