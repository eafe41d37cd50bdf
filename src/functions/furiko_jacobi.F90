! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> The Jacobi elliptic functions, in each kind of real; the text is in furiko_jacobi.inc.
module furiko_jacobi_dp
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_bits_dp, only : infinity, is_nan
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_half_pi_dp, only : half_pi
   use furiko_modulus_dp, only : modulus, modulus_from_k, modulus_from_m, modulus_from_mc, steep, unscaled
   use furiko_quotients_many_dp, only : lanes, quotients_many
   use furiko_quotients_one_dp, only : quotients_one
   implicit none
   private
   ! For real32, and Jacobi's epsilon
   public :: amplitude, evaluate, split_amplitude
   real(wp), parameter :: pi(2) = 2*[half_pi(1), half_pi(2) + half_pi(3)]
   include 'furiko_jacobi.inc'
   include 'furiko_jacobi_blocks.inc'
   include 'furiko_jacobi_one.inc'
end module furiko_jacobi_dp


module furiko_jacobi_sp
   use, intrinsic :: iso_fortran_env, only : real64, wp => real32
   use furiko_bits_sp, only : infinity, is_nan
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_jacobi_dp, only : double_amplitude => amplitude, double_evaluate => evaluate
   use furiko_modulus_sp, only : modulus, modulus_from_k, modulus_from_m, modulus_from_mc, steep, unscaled
   use furiko_quotients_many_sp, only : lanes, quotients_many
   implicit none
   private
   include 'furiko_jacobi.inc'
   include 'furiko_jacobi_blocks.inc'
   include 'furiko_jacobi_by_real64.inc'
end module furiko_jacobi_sp


#ifdef FURIKO_REAL128
module furiko_jacobi_qp
   use, intrinsic :: iso_fortran_env, only : int64, wp => real128
   use furiko_bits_qp, only : infinity, is_nan
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_half_pi_qp, only : half_pi
   use furiko_modulus_qp, only : modulus, modulus_from_k, modulus_from_m, modulus_from_mc, steep, unscaled
   use furiko_quotients_one_qp, only : quotients_one
   implicit none
   private
   real(wp), parameter :: pi(2) = 2*[half_pi(1), half_pi(2) + half_pi(3)]
   include 'furiko_jacobi.inc'
   include 'furiko_jacobi_loop.inc'
   include 'furiko_jacobi_one.inc'
end module furiko_jacobi_qp
#endif


!> The Jacobi elliptic functions of any real u and m, in real32, real64 and real128
!>
!> The form of the argument is in the name: modulus `_k`, parameter `_m` = k^2, complementary
!> parameter `_mc` = 1 - m.
! allow(C121)
module furiko_jacobi
   use furiko_jacobi_sp
   use furiko_jacobi_dp
#ifdef FURIKO_REAL128
   use furiko_jacobi_qp
#endif
   implicit none
   public
   private :: amplitude, evaluate, split_amplitude
end module furiko_jacobi
! rooms: 3215874652
