! SPDX-License-Identifier: MIT

!> All that Fortran 77 calls: for fpm, which leaves out of a library the modules that no program uses. Fortran
!> finds nothing here.

module furiko_f77
   use furiko_f77_carlson, only :
   use furiko_f77_complete, only :
   use furiko_f77_incomplete, only :
   use furiko_f77_jacobi, only :
   use furiko_f77_modulus, only :
   use furiko_f77_motion, only :
   use furiko_f77_nome, only :
   use furiko_f77_period, only :
   use furiko_f77_selftest, only :
   use furiko_f77_steps, only :
   implicit none
   private
end module furiko_f77
