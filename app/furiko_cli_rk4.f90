! SPDX-License-Identifier: MIT

!> `furiko rk4`: the pendulum by a step-by-step integrator, beside its exact motion.
module furiko_cli_rk4
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : motion, pendulum, pendulum_forest_ruth, pendulum_rk4, pendulum_verlet, rk4
   use furiko_cli_io, only : finish
   use furiko_cli_options, only : command, command_line, option, word
   use furiko_cli_pendulum, only : gravity_option, length_option, motion_of, pendulum_of, start_options
   use furiko_cli_quantity, only : no_unit, number_of, whole_of
   use furiko_cli_sheet, only : begin_sheet, column, format_option, places, powers, sheet
   use furiko_pendulum_rates_dp, only : driven_pendulum_rates
   use furiko_word_arithmetic_dp, only : words
   implicit none
   private
   public :: rk4_usage


   !> A way to step
   type :: integrator
      character(len=11) :: method
      real(wp) :: omega2
      !> Length of a step, and how many make a row
      real(wp) :: h
      integer :: every
      !> Friction, drive and its frequency, as for the rates
      real(wp) :: forces(4)
   end type integrator


contains


   function rk4_usage() result(usage)
      type(command) :: usage

      usage = command('rk4', 'step by step: Runge-Kutta, Stoermer-Verlet, Forest-Ruth', '', 0, &
         'The pendulum step by step from a start (without one, --amplitude 1rad): time in periods of ' // &
         'the exact motion, angle and rate, how far the angle is from the exact one, and by how much ' // &
         'the energy (rate^2/2 - (g/l) cos(angle), that is, over m l^2) has changed.', &
         'With friction or drive, which go with --method rk4 only, the exact motion is the one without.', &
         'furiko rk4 --method forest-ruth --steps 50 --periods 1000 --every 5000', options=[ &
         start_options, &
         option('--method', 'rk4|verlet|forest-ruth', 'rk4', 'the integrator'), &
         option('--steps', 'N', '100', 'steps a period'), &
         option('--periods', 'P', '10', 'how many periods'), &
         option('--every', 'N', '', 'a row after every N steps (default: as many as make a period)'), &
         option('--linear', 'C', '0', 'friction C times the rate, 1/s'), &
         option('--quadratic', 'C', '0', 'friction C times the rate squared'), &
         option('--drive', 'F', '0', 'drive F cos(W t), rad/s^2'), &
         option('--drive-frequency', 'W', '0', 'of the drive, rad/s'), &
         length_option, gravity_option, format_option], run=rk4_command)
   end function rk4_usage


   subroutine rk4_command(line)
      type(command_line), intent(in) :: line
      type(integrator) :: stepper
      type(motion) :: path
      type(pendulum) :: body
      type(sheet) :: page
      real(wp) :: energy, period, t, y(2)
      integer(int64) :: i, rows

      body = pendulum_of(line)
      path = body%swinging(1.0_wp)
      if (line%given('--amplitude') .or. line%given('--release') .or. line%given('--angle') .or. &
         line%given('--rate')) path = motion_of(line, body)
      period = path%period()
      if (.not. period <= huge(period)) call line%reject('on the separatrix there is no period')
      call read_stepper(line, body, period, stepper, rows)
      y = [path%angle(0.0_wp), path%rate(0.0_wp)]
      energy = energy_of(y, stepper%omega2)
      page = begin_sheet(line, [column('periods', places, 4, width=12), column('angle_rad', places, 12), &
         column('rate_rad_s', places, 12), column('angle_error_rad', powers, 3, head='error_rad'), &
         column('energy_error_s_2', powers, 3)], rows=rows + 1)
      do i = 0, rows
         if (i > 0) call advance(stepper, real(i - 1, wp)*stepper%every*stepper%h, y)
         t = real(i, wp)*(stepper%every*stepper%h)
         if (.not. all(abs(y) <= huge(y))) call line%reject('angle and rate have run away beyond all numbers')
         call page%row([t/period, y, y(1) - path%angle(t), &
            2*stepper%omega2*(energy_of(y, stepper%omega2) - energy)])
      end do
      call page%end()
      call finish()
   end subroutine rk4_command


   !> The method, its steps and forces; rows beside the first
   subroutine read_stepper(line, body, period, stepper, rows)
      type(command_line), intent(in) :: line
      type(pendulum), intent(in) :: body
      real(wp), intent(in) :: period
      type(integrator), intent(out) :: stepper
      integer(int64), intent(out) :: rows
      ! the largest round number that a default integer holds
      integer, parameter :: most = 1000000000
      character(len=17), parameter :: forces(4) = [character(len=17) :: '--linear', '--quadratic', &
         '--drive', '--drive-frequency']
      type(words) :: force
      type(word) :: method
      integer :: i, steps

      method = line%value('--method')
      stepper%method = method%text
      stepper%omega2 = body%gravity/body%length
      steps = whole_of(line%value('--steps'), 1, most)
      stepper%h = period/steps
      stepper%every = steps
      if (line%given('--every')) stepper%every = whole_of(line%value('--every'), 1, most)
      rows = int(steps, int64)*whole_of(line%value('--periods'), 1, most)/stepper%every
      do i = 1, 4
         force = number_of(line%value(trim(forces(i))), no_unit)
         stepper%forces(i) = force%hi
      end do
      if (method%text /= 'rk4' .and. any(abs(stepper%forces) > 0.0_wp)) then
         call line%reject('friction and drive go with --method rk4 only')
      end if
   end subroutine read_stepper


   !> The steps of a row, from the time t on
   subroutine advance(self, t, y)
      type(integrator), intent(in) :: self
      real(wp), intent(in) :: t
      real(wp), intent(inout) :: y(2)

      select case (self%method)
      case ('verlet')
         call pendulum_verlet(self%omega2, self%h, self%every, y(1), y(2))
      case ('forest-ruth')
         call pendulum_forest_ruth(self%omega2, self%h, self%every, y(1), y(2))
      case default
         if (any(abs(self%forces) > 0.0_wp)) then
            call rk4(driven_pendulum_rates, [self%omega2, self%forces], t, self%h, self%every, y)
         else
            call pendulum_rk4(self%omega2, self%h, self%every, y(1), y(2))
         end if
      end select
   end subroutine advance


   !> k^2 = sin^2(theta/2) + (rate/(2 omega))^2: 0 at rest, 1 on the separatrix
   pure function energy_of(y, omega2) result(energy)
      real(wp), intent(in) :: y(2)
      real(wp), intent(in) :: omega2
      real(wp) :: energy

      energy = sin(0.5_wp*y(1))**2 + y(2)**2/(4*omega2)
   end function energy_of

end module furiko_cli_rk4
