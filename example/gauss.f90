! SPDX-License-Identifier: MIT

!> Gauss's constant 1/M(1, sqrt(2)), in every kind of real.
program gauss
   use, intrinsic :: iso_fortran_env, only : real32, real64, real128
   use furiko, only : agm
   implicit none

   print '(f9.7)', 1/agm(1.0_real32, sqrt(2.0_real32))     ! => 0.8346269
   print '(f18.16)', 1/agm(1.0_real64, sqrt(2.0_real64))   ! => 0.8346268416740731
   print '(f35.33)', 1/agm(1.0_real128, sqrt(2.0_real128)) ! => 0.834626841674073186281429734799047
end program gauss
