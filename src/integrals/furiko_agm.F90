! SPDX-License-Identifier: MIT

!> The arithmetic-geometric mean, in each kind of real; the text is in furiko_agm.inc.
module furiko_agm_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_quiet_nan, ieee_value
   implicit none
   private
   include 'furiko_agm.inc'
end module furiko_agm_sp


module furiko_agm_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_quiet_nan, ieee_value
   implicit none
   private
   include 'furiko_agm.inc'
end module furiko_agm_dp


#ifdef __GFC_REAL_16__
module furiko_agm_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_quiet_nan, ieee_value
   implicit none
   private
   include 'furiko_agm.inc'
end module furiko_agm_qp
#endif


module furiko_agm
   use furiko_agm_sp, only : agm
   use furiko_agm_dp, only : agm
#ifdef __GFC_REAL_16__
   use furiko_agm_qp, only : agm
#endif
   implicit none
   private
   public :: agm
end module furiko_agm
