! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

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


#ifdef FURIKO_REAL128
module furiko_symplectic_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'furiko_symplectic_weights.inc'
   include 'furiko_symplectic.inc'
end module furiko_symplectic_qp
#endif


!> Symplectic steps for any system x'' = a(x), in each kind of real.
! allow(C121)
module furiko_symplectic
   use furiko_symplectic_sp
   use furiko_symplectic_dp
#ifdef FURIKO_REAL128
   use furiko_symplectic_qp
#endif
   implicit none
   public
end module furiko_symplectic
! rooms: 363501362
