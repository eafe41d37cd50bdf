! SPDX-License-Identifier: MIT

!> For Fortran 77: a pendulum's period, its inverses, an ellipse's perimeter.
! allow(C121)
module furiko_f77_period
   use furiko_ellipse
   use furiko_inverse_period
   use furiko_period
   implicit none
   public
end module furiko_f77_period


include 'furiko_f77_period.inc'
include 'furiko_f77_period_real.inc'
! rooms: 3579022051
