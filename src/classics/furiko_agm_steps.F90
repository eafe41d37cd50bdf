! SPDX-License-Identifier: MIT

module furiko_agm_steps_sp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only : wp => real32
   implicit none
   private
   include 'furiko_agm_steps.inc'
end module furiko_agm_steps_sp


module furiko_agm_steps_dp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   include 'furiko_agm_steps.inc'
end module furiko_agm_steps_dp


#ifdef __GFC_REAL_16__
module furiko_agm_steps_qp
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'furiko_agm_steps.inc'
end module furiko_agm_steps_qp
#endif


!> The arithmetic-geometric mean step by step, on its way to K and E.
module furiko_agm_steps
   use furiko_agm_steps_sp, only : agm_steps_k, agm_steps_m, agm_steps_mc
   use furiko_agm_steps_dp, only : agm_steps_k, agm_steps_m, agm_steps_mc
#ifdef __GFC_REAL_16__
   use furiko_agm_steps_qp, only : agm_steps_k, agm_steps_m, agm_steps_mc
#endif
   implicit none
   private
   public :: agm_steps_k, agm_steps_m, agm_steps_mc
end module furiko_agm_steps
