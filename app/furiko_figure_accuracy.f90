! SPDX-License-Identifier: MIT

!> The error of K next to 180 degrees, by k, by m and by mc: why there is an mc.
module furiko_figure_accuracy
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipk_k, ellipk_m, ellipk_mc
   use furiko_figure, only : amplitude, black, blue, column, figure, orange
   use furiko_period_degrees, only : period_ratio_degrees
   use furiko_word_arithmetic_dp, only : words, pi_words, operator(-), operator(*), operator(/)
   implicit none
   private
   public :: accuracy_figure


   !> Decades of the distance from the top in degrees, from 10 down to 1e-12
   integer, parameter :: decades = 13
   integer, parameter :: bins_per_decade = 8
   !> Amplitudes in each bin, of which the worst is shown
   integer, parameter :: per_bin = 40


contains


   subroutine accuracy_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      character(len=*), parameter :: names(*) = [character(len=7) :: 'K by k', 'K by m', 'K by mc']
      character(len=*), parameter :: labels(*) = [character(len=64) :: '<K> by <k> = sin(<θ>_0/2)', &
         '<K> by <m> = sin^2(<θ>_0/2)', '<K> by <m>_c = cos^2(<θ>_0/2): half an ulp up to the top']
      integer, parameter :: pens(*) = [orange, blue, black]
      real(wp) :: distance(decades*bins_per_decade), errors(3, decades*bins_per_decade)
      integer :: i

      associate (unused => amplitudes)
      end associate
      do i = 1, size(distance)
         distance(i) = 10.0_wp**(1.0_wp - (i - 0.5_wp)/bins_per_decade)
         errors(:, i) = worst(1.0_wp - (i - 1.0_wp)/bins_per_decade)
      end do
      call self%begin([column('degrees_below_180', '180 degrees less the amplitude'), &
         column('error_ulp', 'largest of 40 errors of K in units in the last place')], &
         'Error of K against the distance of the amplitude from 180 degrees. Asked for by k or by m, K ' // &
         'loses two digits for each decade of the distance, and is infinite from a millionth of a ' // &
         'degree on, where k and m round to 1. Asked for by mc, its error stays at half a unit in the ' // &
         'last place.')
      call self%panel('180° − <θ>_0  (degrees)', 'error of <K>  (units in the last place)', &
         [10.0_wp, 1e-12_wp], &
         [0.1_wp, 1e16_wp], log='xy')
      call self%say('set format "10^{%T}"; set xtics (1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12); ' // &
         'set ytics 1, 100, 1e16; unset mxtics; unset mytics')
      do i = 1, size(names)
         call self%add(trim(names(i)), pack(distance, errors(i, :) <= huge(errors)), &
            pack(errors(i, :), errors(i, :) <= huge(errors)))
         call self%draw(pens(i), trim(labels(i)))
      end do
      call self%note('<k> and <m> round to 1: <K> = ∞', 1e-6_wp, 1e14_wp, 'left')
      call self%plot()
   end subroutine accuracy_figure


   !> The largest errors in ulp of K by k, m and mc, over one bin that begins at 10**power degrees
   !> from the top.
   function worst(power) result(errors)
      real(wp), intent(in) :: power
      real(wp) :: errors(3)
      type(words) :: angle, k
      real(wp) :: distance
      integer :: i

      errors = 0.0_wp
      do i = 1, per_bin
         distance = 10.0_wp**(power - (i - 0.5_wp)/(per_bin*bins_per_decade))
         angle = distance*pi_words/360.0_wp
         k = period_ratio_degrees(180.0_wp - words(distance))*pi_words/2.0_wp
         errors = max(errors, abs([ellipk_k(cos(angle%hi)), ellipk_m(1 - sin(angle%hi)**2), &
            ellipk_mc(sin(angle%hi)**2)] - k%hi - k%lo)/spacing(k%hi))
      end do
   end function worst

end module furiko_figure_accuracy
