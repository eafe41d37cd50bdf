! SPDX-License-Identifier: MIT

!> The error of K next to 180 degrees, by k, by m and by mc: why there is an mc.
module furiko_figure_accuracy
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipk_k, ellipk_m, ellipk_mc
   use furiko_figure, only : figure
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


   subroutine accuracy_figure(self)
      type(figure), intent(out) :: self
      character(len=*), parameter :: names(*) = [character(len=7) :: 'K by k', 'K by m', 'K by mc']
      character(len=*), parameter :: looks(*) = [character(len=48) :: &
         'lines lw 2 dt (12, 4) lc rgb "#D55E00"', 'lines lw 2 dt (3, 3) lc rgb "#0072B2"', &
         'lines lw 3 lc rgb "#000000"']
      real(wp) :: distance(decades*bins_per_decade), errors(3, decades*bins_per_decade)
      integer :: i

      do i = 1, size(distance)
         distance(i) = 10.0_wp**(1.0_wp - (i - 0.5_wp)/bins_per_decade)
         errors(:, i) = worst(1.0_wp - (i - 1.0_wp)/bins_per_decade)
      end do
      call self%begin('degrees_below_180', 'error_ulp')
      do i = 1, size(names)
         call self%add(trim(names(i)), pack(distance, errors(i, :) <= huge(errors)), &
            pack(errors(i, :), errors(i, :) <= huge(errors)))
         call self%draw(trim(looks(i)))
      end do

      call self%say('set xlabel "180° − <θ>_0  (degrees)"')
      call self%say('set ylabel "error of <K>  (ulp)"')
      call self%say('set logscale xy')
      call self%say('set xrange [10:1e-12]')
      call self%say('set yrange [0.1:1e16]')
      call self%say('set format "10^{%T}"')
      call self%say('set xtics (1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)')
      call self%say('set ytics 1, 100, 1e16')
      call self%say('unset mxtics')
      call self%say('unset mytics')
      call self%say('set label "<K> by <k> = sin(<θ>_0/2)" at 0.8e-2, 1e8 right')
      call self%say('set label "<K> by <m> = sin^2(<θ>_0/2)" at 0.4e-2, 3e5 left')
      call self%say('set label "from here on <k> and <m> round to 1: <K> = ∞" at 1e-6, 1e14 left')
      call self%say('set label "<K> by <m>_c = cos^2(<θ>_0/2): 0.5 ulp up to the top" ' // &
         'at 1e-7, 4 center')
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
