! SPDX-License-Identifier: MIT

!> sn, cn, dn and the amplitude next to the separatrix, where 1 - m has to be said itself.
program jacobi
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : jacobi_am_mc, jacobi_m, jacobi_mc
   implicit none
   real(wp) :: sn, cn, dn

   call jacobi_m(1.0_wp, 0.5_wp, sn, cn, dn)
   print '(3f18.15)', sn, cn, dn                ! => 0.803001824895644 0.595976567672141 0.823161001631596
   call jacobi_mc(100.0_wp, 1e-30_wp, sn, cn, dn)
   print '(3es23.15)', sn, cn, dn               ! => -1.000000000000000E+00 -1.190424102317516E-12 1.190424522335819E-12
   print '(f18.15)', jacobi_am_mc(100.0_wp, 1e-30_wp)  ! => 4.712388980383500
end program jacobi
