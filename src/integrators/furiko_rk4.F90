! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_rk4_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   implicit none
   private
   include 'furiko_rk4.inc'
end module furiko_rk4_sp


module furiko_rk4_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   include 'furiko_rk4.inc'
end module furiko_rk4_dp


#ifdef FURIKO_REAL128
module furiko_rk4_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'furiko_rk4.inc'
end module furiko_rk4_qp
#endif


!> Classical Runge-Kutta steps for any system of equations, in each kind of real.
! allow(C121)
module furiko_rk4
   use furiko_rk4_sp
   use furiko_rk4_dp
#ifdef FURIKO_REAL128
   use furiko_rk4_qp
#endif
   implicit none
   public
end module furiko_rk4
! rooms: 213951175
