! SPDX-License-Identifier: MIT

!> The period ratio of the printed table: the amplitude in degrees, 30 digits, every compiler.
module furiko_period_degrees
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_word_arithmetic_dp, only : words, sin, mean_with_one, operator(-), operator(*), operator(/), &
      pi_words
   implicit none
   private
   public :: period_ratio_degrees


contains


   !> T/T_h of a pendulum as [[period_ratio]], for an amplitude in degrees, 0 <= amplitude < 180.
   !>
   !> In degrees the gap to the top, 180 - amplitude, is exact, and kc = cos(amplitude/2) is the
   !> sine of half of it: all 30 digits hold at any distance from 180.
   elemental function period_ratio_degrees(amplitude) result(ratio)
      !> Largest angle from the vertical, degrees
      type(words), intent(in) :: amplitude
      !> T/T_h
      type(words) :: ratio
      type(words) :: mean

      call mean_with_one(sin((180.0_wp - amplitude)*pi_words/360.0_wp), mean)
      ratio = 1.0_wp/mean
   end function period_ratio_degrees

end module furiko_period_degrees
