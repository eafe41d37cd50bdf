! SPDX-License-Identifier: MIT

!> How much of each harmonic there is in a swing, against its amplitude.
module furiko_figure_spectrum
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : motion, pendulum
   use furiko_figure, only : amplitude, black, blue, column, figure, green, orange, purple, ramp, to_text
   implicit none
   private
   public :: spectrum_figure


   real(wp), parameter :: degree = acos(-1.0_wp)/180
   real(wp), parameter :: least = 1e-6_wp


contains


   !> θ = Σ aₙ sin(2πnτ/T), n odd
   subroutine spectrum_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      integer, parameter :: orders(*) = [1, 3, 5, 7, 9], pens(*) = [black, blue, orange, green, purple]
      type(pendulum) :: body
      type(motion) :: path
      real(wp) :: coefficient(180), largest(180)
      integer :: i, j

      associate (unused => amplitudes)
      end associate
      largest = [ramp(1.0_wp, 179.0_wp, 178), 179.9_wp]
      call self%begin([column('amplitude_deg', 'amplitude in degrees'), &
         column('coefficient_deg', 'coefficient of sin(2 pi n t/T) in degrees')], &
         'Fourier coefficients of the angle against the amplitude, for n = 1, 3, 5, 7 and 9; the even ' // &
         'ones are 0. Below 90 degrees the third is less than 2 percent of the first, so that a swing ' // &
         'is nearly a sine. Next to 180 degrees all of them count.')
      call self%panel('amplitude <θ>_0  (degrees)', 'coefficient <a_n>  (degrees)', [0.0_wp, 180.0_wp], &
         [least, 300.0_wp], log='y')
      call self%say('set xtics 30; set ytics 10 format "10^{%T}"; unset mytics')
      do i = 1, size(orders)
         do j = 1, size(largest)
            path = body%swinging(largest(j)*degree)
            coefficient(j) = path%harmonic(orders(i))/degree
         end do
         call self%add('n = ' // to_text(orders(i)), pack(largest, coefficient > least/10), &
            pack(coefficient, coefficient > least/10))
         call self%draw(pens(i), '<n> = ' // to_text(orders(i)))
      end do
      call self%plot()
   end subroutine spectrum_figure

end module furiko_figure_spectrum
