! SPDX-License-Identifier: MIT

!> How the energy drifts, at equal work: Runge-Kutta loses it, the symplectic methods do not.
module furiko_figure_energy
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : pendulum_forest_ruth, pendulum_rk4, pendulum_verlet, period_ratio
   use furiko_figure, only : amplitude, black, blue, column, figure, orange, to_text
   implicit none
   private
   public :: energy_figure


   !> Sines in a swing, the same for every method; divisible by 4, 3 and 1
   integer, parameter :: sines_per_swing = 96
   character(len=*), parameter :: names(*) = [character(len=16) :: 'Runge-Kutta', 'Stoermer-Verlet', &
      'Forest-Ruth']
   character(len=*), parameter :: titles(*) = [character(len=20) :: 'Runge–Kutta 4', 'Störmer–Verlet', &
      'Forest–Ruth']
   integer, parameter :: pens(*) = [black, orange, blue]
   !> Sines in a step of each method
   integer, parameter :: sines_per_step(*) = [4, 1, 3]
   !> Decades of swings, and in each the looks at the energy that are a point of a curve
   integer, parameter :: decades = 5
   integer, parameter :: looks_per_decade = 8


contains


   subroutine energy_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      real(wp), allocatable :: drifts(:)
      integer, allocatable :: swings(:)
      integer :: i

      allocate(swings(decades*looks_per_decade + 1))
      swings = [(nint(10.0_wp**(real(i, wp)/looks_per_decade)), i=0, decades*looks_per_decade)]
      swings = pack(swings, swings > [0, swings(:size(swings) - 1)])
      allocate(drifts(size(swings)))
      call self%begin([column('swings', 'number of the swing'), column('relative_energy_error', &
         'largest relative error of the energy within it')], &
         'Relative error of the energy during a hundred thousand swings of ' // amplitudes(1)%label // &
         ' by three integrators that evaluate the sine equally often. That of the Runge-Kutta method ' // &
         'grows with every swing until no energy is left; those of the two symplectic methods stay as ' // &
         'they are.')
      call self%panel('number of swings to ' // amplitudes(1)%label, 'relative error of the energy', &
         [1.0_wp, 1e5_wp], [1e-5_wp, 1.5_wp], log='xy', cell=[1, 1, 1, 1])
      call self%say('set xtics 10 format "10^{%T}"; set ytics 10 format "10^{%T}"; unset mxtics; unset ' // &
         'mytics')
      call self%caption(to_text(sines_per_swing) // ' sines a swing for each method')
      do i = 1, size(names)
         call follow(i, amplitudes(1)%radians, swings, drifts)
         call self%add(trim(names(i)), real(swings, wp), drifts)
         call self%draw(pens(i), trim(titles(i)) // ', ' // to_text(sines_per_swing/sines_per_step(i)) // &
            ' steps a swing')
      end do
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
