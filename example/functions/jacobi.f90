! SPDX-License-Identifier: MIT

!> sn, cn, dn and the amplitude next to the separatrix, where 1 - m has to be said itself.
program jacobi
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : jacobi_am_mc, jacobi_m, jacobi_mc
   implicit none
   real(wp) :: sn, cn, dn

   call jacobi_m(1.0_wp, 0.5_wp, sn, cn, dn)
   print '(3f11.8)', sn, cn, dn                        ! => 0.80300182 0.59597657 0.82316100
   call jacobi_mc(100.0_wp, 1e-30_wp, sn, cn, dn)
   print '(3es17.9)', sn, cn, dn                       ! => -1.000000000E+00 -1.190424102E-12 1.190424522E-12
   print '(f18.15)', jacobi_am_mc(100.0_wp, 1e-30_wp)  ! => 4.712388980383500
end program jacobi
