! SPDX-License-Identifier: MIT

module furiko_symplectic_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   implicit none
   private
   include 'furiko_symplectic_weights.inc'
   include 'furiko_symplectic.inc'
end module furiko_symplectic_sp


module furiko_symplectic_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   include 'furiko_symplectic_weights.inc'
   include 'furiko_symplectic.inc'
end module furiko_symplectic_dp


#ifdef __GFC_REAL_16__
module furiko_symplectic_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'furiko_symplectic_weights.inc'
   include 'furiko_symplectic.inc'
end module furiko_symplectic_qp
#endif


!> Symplectic steps for any system x'' = a(x), in each kind of real.
module furiko_symplectic
   use furiko_symplectic_sp, only : verlet, forest_ruth
   use furiko_symplectic_dp, only : verlet, forest_ruth
#ifdef __GFC_REAL_16__
   use furiko_symplectic_qp, only : verlet, forest_ruth
#endif
   implicit none
   private
   public :: verlet, forest_ruth
end module furiko_symplectic
