! SPDX-License-Identifier: MIT

!> Gauss's constant 1/M(1, sqrt(2)), in single and double precision.
program gauss
   use, intrinsic :: iso_fortran_env, only : real32, real64
   use furiko, only : agm
   implicit none

   print '(f9.7)', 1/agm(1.0_real32, sqrt(2.0_real32))     ! => 0.8346268
   print '(f18.16)', 1/agm(1.0_real64, sqrt(2.0_real64))   ! => 0.8346268416740731
end program gauss
