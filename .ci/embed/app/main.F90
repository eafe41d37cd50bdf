! SPDX-License-Identifier: MIT

!> A program of somebody else's that uses furiko in each kind of real, scalars and arrays.
program main
   use, intrinsic :: iso_fortran_env, only : real32, real64, real128
   use furiko, only : agm, ellipe_mc, ellipk_k, ellipk_m, ellipke_k, period_ratio
   implicit none
   real(real64) :: k, e

   call ellipke_k(0.5_real64, k, e)
   print '(2f20.15)', k, e
   print '(3f20.15)', ellipk_m([0.25_real64, 0.5_real64, -1.0_real64])
   print '(3f11.7)', ellipk_k(0.5_real32), ellipe_mc(1e-30_real32), period_ratio(1.0_real32)
#ifdef __GFC_REAL_16__
   print '(2f38.33)', ellipk_m(0.25_real128), agm(1.0_real128, 2.0_real128)
#else
   if (real128 > 0) stop
#endif
end program main
