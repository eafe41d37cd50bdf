! SPDX-License-Identifier: MIT

!> The period of the pendulum, in each kind of real; the text is in furiko_period.inc.
module furiko_period_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_complete_sp, only : ellipk_alpha
   implicit none
   private
   include 'furiko_period.inc'
end module furiko_period_sp


module furiko_period_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_complete_dp, only : ellipk_alpha
   implicit none
   private
   include 'furiko_period.inc'
end module furiko_period_dp


#ifdef __GFC_REAL_16__
module furiko_period_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_complete_qp, only : ellipk_alpha
   implicit none
   private
   include 'furiko_period.inc'
end module furiko_period_qp
#endif


module furiko_period
   use furiko_period_sp, only : period_ratio
   use furiko_period_dp, only : period_ratio
#ifdef __GFC_REAL_16__
   use furiko_period_qp, only : period_ratio
#endif
   implicit none
   private
   public :: period_ratio
end module furiko_period
