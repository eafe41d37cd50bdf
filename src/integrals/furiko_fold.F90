! SPDX-License-Identifier: MIT

!> Reduction of an angle by multiples of pi with its sine and cosine in words. Internal.
module furiko_fold_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, int32, int64
   use furiko_duplication_sp, only : lanes
   use furiko_half_pi_sp, only : half_pi
   implicit none
   private
   include 'furiko_fold.inc'
   include '../arithmetic/furiko_head_sp.inc'
end module furiko_fold_sp


module furiko_fold_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, int64
   use furiko_duplication_dp, only : lanes
   use furiko_half_pi_dp, only : half_pi
   implicit none
   private
   include 'furiko_fold.inc'
   include '../arithmetic/furiko_head_dp.inc'
end module furiko_fold_dp


#ifdef __GFC_REAL_16__
module furiko_fold_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128, int32, int64
   use furiko_duplication_qp, only : lanes
   use furiko_half_pi_qp, only : half_pi
   implicit none
   private
   include 'furiko_fold.inc'
   include '../arithmetic/furiko_head_qp.inc'
end module furiko_fold_qp
#endif
