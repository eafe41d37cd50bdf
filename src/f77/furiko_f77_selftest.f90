! SPDX-License-Identifier: MIT

!> For Fortran 77: does this build compute right?
module furiko_f77_selftest
   use furiko_known_values, only : furiko_selftest
   implicit none
   public
end module furiko_f77_selftest


include 'furiko_f77_selftest.inc'
! rooms: 2974182164
