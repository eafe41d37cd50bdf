! SPDX-License-Identifier: MIT

!> The period ratio of the printed table: the amplitude in degrees, 30 digits, every compiler.
module furiko_period_degrees
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_double_word, only : double_word, double_word_pi, sqrt, sin, &
      operator(+), operator(-), operator(*), operator(/)
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
      type(double_word), intent(in) :: amplitude
      !> T/T_h
      type(double_word) :: ratio
      real(wp), parameter :: tolerance = epsilon(1.0_wp)
      ! the exponent of the ratio, at most 2**11, halves (11 steps); then its digits double to 53 (6)
      integer, parameter :: most_steps = 20
      type(double_word) :: a, b, geometric
      integer :: step

      a = double_word(1.0_wp)
      b = sin((double_word(180.0_wp) - amplitude)*double_word_pi/double_word(360.0_wp))
      do step = 1, most_steps
         if (a%hi - b%hi <= tolerance*a%hi) exit
         geometric = sqrt(a*b)
         a = (a + b)/double_word(2.0_wp)
         b = geometric
      end do
      ratio = double_word(2.0_wp)/(a + b)
   end function period_ratio_degrees

end module furiko_period_degrees
