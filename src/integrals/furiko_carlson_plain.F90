! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Carlson's forms by plain duplication, one at a time or many; what is out of the ordinary in words.
!> Internal.
module furiko_carlson_plain_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32, ip => int32
   use furiko_bits_sp, only : infinity
   use furiko_duplication_plain_sp, only : lanes, width, plain_rf, plain_rc, plain_rd, plain_rfd, plain_rj
   use furiko_carlson_words_sp, only : &
      rf_of_words => rf, rc_of_words => rc, rd_of_words => rd, &
      rj_of_words => rj, rg_of_words => rg
   implicit none
   private
   include 'furiko_carlson_plain.inc'
   include 'furiko_rc_series_sp.inc'
   include 'furiko_rc_wide_sp.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_carlson_plain_sp


module furiko_carlson_plain_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity
   use furiko_duplication_plain_dp, only : lanes, width, plain_rf, plain_rc, plain_rd, plain_rfd, plain_rj
   use furiko_carlson_words_dp, only : &
      rf_of_words => rf, rc_of_words => rc, rd_of_words => rd, &
      rj_of_words => rj, rg_of_words => rg
   implicit none
   private
   include 'furiko_carlson_plain.inc'
   include 'furiko_rc_series_dp.inc'
   include 'furiko_rc_wide_dp.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
end module furiko_carlson_plain_dp


#ifdef FURIKO_REAL128
module furiko_carlson_plain_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128, ip => int64
   use furiko_bits_qp, only : bits_of, head
   use furiko_carlson_words_qp, only : &
      rf_of_words => rf, rc_of_words => rc, rd_of_words => rd, &
      rj_of_words => rj, rg_of_words => rg
   implicit none
   private
   public :: rf, rc, rd, rj, rg
   real(wp), parameter :: small = 2.0_wp**(-maxexponent(1.0_wp)/4)
   real(wp), parameter :: large = 2.0_wp**(maxexponent(1.0_wp)/4)
   real(wp), parameter :: far = 16.0_wp
contains
   include 'furiko_carlson_one.inc'
   include 'furiko_rc_series_qp.inc'
   include 'furiko_rc_wide_qp.inc'
end module furiko_carlson_plain_qp
#endif
! rooms: 3480292787
