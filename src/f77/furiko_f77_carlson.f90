! SPDX-License-Identifier: MIT

!> For Fortran 77: Carlson's integrals, Bulirsch's cel.
! allow(C121)
module furiko_f77_carlson
   use furiko_carlson
   use furiko_cel
   implicit none
   public
end module furiko_f77_carlson


include 'furiko_f77_carlson.inc'
include 'furiko_f77_carlson_real.inc'
! rooms: 1261720640
