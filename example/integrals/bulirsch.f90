! SPDX-License-Identifier: MIT

!> One call for a combination: 3 K + 2 E of k = 0.6 by cel; and J of a small n, which Pi - K has lost.
program bulirsch
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : bulirsch_cel, ellipe_k, ellipj_k, ellipk_k, ellippi_k
   implicit none
   real(wp), parameter :: k = 0.6_wp, kc = 0.8_wp, n = 1e-9_wp

   print '(2f18.14)', bulirsch_cel(kc, 1.0_wp, 5.0_wp, 3 + 2*kc**2), 3*ellipk_k(k) + 2*ellipe_k(k)
   ! => 8.08842819764471 8.08842819764471
   print '(f18.15)', ellipj_k(n, k)                    ! => 0.924084468670223
   print '(f11.8)', (ellippi_k(n, k) - ellipk_k(k))/n  ! => 0.92408436
end program bulirsch
