! SPDX-License-Identifier: MIT

!> For Fortran 77: Carlson's integrals.
! allow(C121)
module furiko_f77_carlson
   use furiko_carlson
   implicit none
   public
end module furiko_f77_carlson


include 'furiko_f77_carlson.inc'
include 'furiko_f77_carlson_real.inc'
! rooms: 3492051790
