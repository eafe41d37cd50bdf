! SPDX-License-Identifier: MIT

!> Quotients of theta functions for blocks of lanes: the kernel of the Jacobi functions. Internal.
module furiko_quotients_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, int32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_finite, ieee_is_nan
   use furiko_half_pi_sp, only : half_pi
   implicit none
   private
   include 'furiko_quotients.inc'
   include '../arithmetic/furiko_head_sp.inc'
   include '../arithmetic/furiko_power_of_two_sp.inc'
end module furiko_quotients_sp


module furiko_quotients_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, int64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_finite, ieee_is_nan
   use furiko_half_pi_dp, only : half_pi
   implicit none
   private
   include 'furiko_quotients.inc'
   include '../arithmetic/furiko_head_dp.inc'
   include '../arithmetic/furiko_power_of_two_dp.inc'
end module furiko_quotients_dp


#ifdef __GFC_REAL_16__
module furiko_quotients_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128, int32, int64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_finite, ieee_is_nan
   use furiko_half_pi_qp, only : half_pi
   implicit none
   private
   include 'furiko_quotients.inc'
   include '../arithmetic/furiko_head_qp.inc'
   include '../arithmetic/furiko_power_of_two_qp.inc'
end module furiko_quotients_qp
#endif
