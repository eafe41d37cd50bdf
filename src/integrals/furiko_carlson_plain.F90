! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Carlson's forms of many arguments by plain duplication, lanes out of the ordinary in words.
!> Internal.
module furiko_carlson_plain_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_bits_sp, only : infinity
   use furiko_duplication_sp, only : lanes
   use furiko_duplication_plain_sp, only : plain_rf, plain_rc, plain_rd, plain_rj
   use furiko_carlson_words_sp, only : &
      rf_words => rf_batch, rc_words => rc_batch, rd_words => rd_batch, &
      rj_words => rj_batch
   implicit none
   private
   include 'furiko_carlson_plain.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_is_nan.inc'
end module furiko_carlson_plain_sp


module furiko_carlson_plain_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity
   use furiko_duplication_dp, only : lanes
   use furiko_duplication_plain_dp, only : plain_rf, plain_rc, plain_rd, plain_rj
   use furiko_carlson_words_dp, only : &
      rf_words => rf_batch, rc_words => rc_batch, rd_words => rd_batch, &
      rj_words => rj_batch
   implicit none
   private
   include 'furiko_carlson_plain.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_is_nan.inc'
end module furiko_carlson_plain_dp
! rooms: 2649024817
