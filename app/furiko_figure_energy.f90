! SPDX-License-Identifier: MIT

!> How the energy drifts, at equal work: Runge-Kutta loses it, the symplectic methods do not.
module furiko_figure_energy
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : pendulum_forest_ruth, pendulum_rk4, pendulum_verlet, period_ratio
   use furiko_figure, only : amplitude, figure, to_text
   implicit none
   private
   public :: energy_figure


   !> Sines in a swing, the same for every method; divisible by 4, 3 and 1
   integer, parameter :: sines_per_swing = 96
   character(len=*), parameter :: names(*) = [character(len=16) :: 'Runge-Kutta', 'Stoermer-Verlet', &
      'Forest-Ruth']
   character(len=*), parameter :: titles(*) = [character(len=20) :: 'Runge–Kutta 4', 'Störmer–Verlet', &
      'Forest–Ruth']
   character(len=*), parameter :: looks(*) = [character(len=48) :: 'lines lw 2.5 lc rgb "#000000"', &
      'lines lw 2 dt (12, 4) lc rgb "#D55E00"', 'lines lw 2 dt (4, 3) lc rgb "#0072B2"']
   !> Sines in a step of each method
   integer, parameter :: sines_per_step(*) = [4, 1, 3]
   !> Decades of swings, and in each the looks at the energy that are a point of a curve
   integer, parameter :: decades = 5
   integer, parameter :: looks_per_decade = 8


contains


   subroutine energy_figure(amplitude_, self)
      type(amplitude), intent(in) :: amplitude_
      type(figure), intent(out) :: self
      real(wp), allocatable :: drifts(:)
      integer, allocatable :: swings(:)
      integer :: i

      swings = [(nint(10.0_wp**(real(i, wp)/looks_per_decade)), i=0, decades*looks_per_decade)]
      swings = pack(swings, swings > [0, swings(:size(swings) - 1)])
      allocate(drifts(size(swings)))
      call self%begin('swings', 'relative_energy_error')
      do i = 1, size(names)
         call follow(i, amplitude_%radians, swings, drifts)
         call self%add(trim(names(i)), real(swings, wp), drifts)
         call self%draw(trim(looks(i)))
         call self%say('set label "' // trim(titles(i)) // ', ' // &
            to_text(sines_per_swing/sines_per_step(i)) // ' steps each" at graph 1.015, first ' // &
            to_text(drifts(size(drifts))) // ' left')
      end do

      call self%say('set rmargin 27')
      call self%say('set xlabel "swings of ' // amplitude_%label // '  (' // &
         to_text(sines_per_swing) // ' sines in each)"')
      call self%say('set ylabel "energy error  |Δ<E>| / <E>"')
      call self%say('set logscale xy')
      call self%say('set format "10^{%T}"')
      call self%say('set xrange [1:1e5]')
      call self%say('unset mxtics')
      call self%say('unset mytics')
      call self%plot()
   end subroutine energy_figure


   !> The largest errors within each of some swings, from rest at the amplitude; energies from rest
   !> at the bottom, l = g = 1.
   subroutine follow(method, amplitude_, swings, drifts)
      integer, intent(in) :: method
      real(wp), intent(in) :: amplitude_
      !> Which swings, in rising order
      integer, intent(in) :: swings(:)
      real(wp), intent(out) :: drifts(:)
      real(wp) :: angle, energy, h, rate
      integer :: done, i, j, per_swing

      energy = 2*sin(amplitude_/2)**2
      per_swing = sines_per_swing/sines_per_step(method)
      h = 2*acos(-1.0_wp)*period_ratio(amplitude_)/per_swing
      angle = amplitude_
      rate = 0.0_wp
      done = 0
      drifts = 0.0_wp
      do i = 1, size(swings)
         call advance(method, h, (swings(i) - 1 - done)*per_swing, angle, rate)
         do j = 1, per_swing
            call advance(method, h, 1, angle, rate)
            drifts(i) = max(drifts(i), abs((rate**2/2 + 2*sin(angle/2)**2)/energy - 1))
         end do
         done = swings(i)
      end do
   end subroutine follow


   subroutine advance(method, h, steps, angle, rate)
      integer, intent(in) :: method
      real(wp), intent(in) :: h
      integer, intent(in) :: steps
      real(wp), intent(inout) :: angle
      real(wp), intent(inout) :: rate

      select case (method)
      case (1)
         call pendulum_rk4(1.0_wp, h, steps, angle, rate)
      case (2)
         call pendulum_verlet(1.0_wp, h, steps, angle, rate)
      case default
         call pendulum_forest_ruth(1.0_wp, h, steps, angle, rate)
      end select
   end subroutine advance

end module furiko_figure_energy
