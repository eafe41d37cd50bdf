! SPDX-License-Identifier: MIT

!> Carlson's forms of many arguments by plain duplication, lanes out of the ordinary in words.
!> Internal.
module furiko_carlson_plain_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, int32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan
   use furiko_duplication_sp, only : lanes
   use furiko_duplication_plain_sp, only : plain_rf, plain_rc, plain_rd, plain_rj
   use furiko_carlson_words_sp, only : &
      rf_words => rf_batch, rc_words => rc_batch, rd_words => rd_batch, &
      rj_words => rj_batch
   implicit none
   private
   include 'furiko_carlson_plain.inc'
   include '../arithmetic/furiko_head_sp.inc'
end module furiko_carlson_plain_sp


module furiko_carlson_plain_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, int64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan
   use furiko_duplication_dp, only : lanes
   use furiko_duplication_plain_dp, only : plain_rf, plain_rc, plain_rd, plain_rj
   use furiko_carlson_words_dp, only : &
      rf_words => rf_batch, rc_words => rc_batch, rd_words => rd_batch, &
      rj_words => rj_batch
   implicit none
   private
   include 'furiko_carlson_plain.inc'
   include '../arithmetic/furiko_head_dp.inc'
end module furiko_carlson_plain_dp
