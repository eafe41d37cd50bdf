! SPDX-License-Identifier: MIT

!> A nonlinear spring, x'' = -x - x**3, let go at 1: x = cn(sqrt(2) t | 1/4), and its period.
program glaisher
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipk_m, jacobi_cn_m
   implicit none

   print '(3f15.12)', jacobi_cn_m(sqrt(2.0_wp)*[0.5_wp, 1.0_wp, 100.0_wp], 0.25_wp)
   ! => 0.768801895376 0.233691791143 0.983587492137
   print '(f15.12)', 4*ellipk_m(0.25_wp)/sqrt(2.0_wp)   ! => 4.768022029102
end program glaisher
