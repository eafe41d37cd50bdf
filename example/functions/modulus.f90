! SPDX-License-Identifier: MIT

!> A pendulum let go at 179.9 degrees, five times in its first half period: one modulus, many u.
program one_modulus
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : modulus, modulus_from_amplitude
   implicit none
   real(wp), parameter :: degree = acos(-1.0_wp)/180
   real(wp), dimension(5) :: u, sn, cn, dn
   type(modulus) :: p

   p = modulus_from_amplitude(179.9_wp*degree)
   u = p%quarter_period()*[1.0_wp, 1.25_wp, 1.5_wp, 1.75_wp, 2.0_wp]
   call p%jacobi(u, sn, cn, dn)
   print '(5f9.4)', 2*asin(p%k()*sn)/degree   ! => 179.9000 179.5825 176.6144 152.2824 0.0000
   print '(f18.15)', p%quarter_period()       ! => 8.430255141254294
end program one_modulus
