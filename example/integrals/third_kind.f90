! SPDX-License-Identifier: MIT

!> The third kind: a principal value, and an array at once.
program third_kind
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellippi_k, ellippiinc_m
   implicit none

   ! GSL's Pcomp(k=0.5, n=-0.3), a Cauchy principal value, and three n
   print '(f14.11)', ellippi_k(0.3_wp, 0.5_wp)   ! => 2.02779244581
   print '(f14.11)', ellippi_k(2.0_wp, 0.5_wp)   ! => -0.12072088641
   print '(3f9.5)', ellippiinc_m([-1.0_wp, 0.0_wp, 0.9_wp], 1.0_wp, 0.5_wp)   ! => 0.86689 1.08322 1.60205
end program third_kind
