! SPDX-License-Identifier: MIT

!> `furiko rk4`: the pendulum by a step-by-step integrator, beside its exact motion.
module furiko_cli_rk4
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : motion, pendulum, pendulum_forest_ruth, pendulum_rk4, pendulum_verlet, rk4
   use furiko_cli_arguments, only : argument_reader, value_of
   use furiko_cli_pendulum, only : amplitude_of, angle_at_start, rate_at_start, read_pendulum_option
   use furiko_cli_quantity, only : integer_of, number_of, pure_number
   use furiko_cli_sheet, only : begin_sheet, sheet
   use furiko_cli_terminal, only : finish, put, refuse
   use furiko_double_word, only : double_word
   use furiko_pendulum_rates_dp, only : driven_pendulum_rates
   implicit none
   private
   public :: rk4_command


   character(len=*), parameter :: command = 'furiko rk4'
   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: help = &
      'furiko rk4 [--amplitude A | --angle A --rate R] [--method M] [--steps N] [--periods P]' // nl // &
      '           [--every N] [--linear C] [--quadratic C] [--drive F --drive-frequency W]' // nl // &
      '           [--length L] [--gravity G] [--format F]' // nl // nl // &
      'The pendulum step by step: time in periods of the exact motion, angle and rate, how far the angle' // &
      nl // 'is from the exact one, and how much of the energy (over 2 omega^2) is lost.' // &
      nl // nl // &
      '  --amplitude A      through the bottom at the time 0, swinging out to A (1rad)' // nl // &
      '  --angle A --rate R any start; R in rad/s (0)' // nl // &
      '  --method M         rk4, verlet or forest-ruth (rk4)' // nl // &
      '  --steps N          steps a period (100)' // nl // &
      '  --periods P        how many periods (10)' // nl // &
      '  --every N          a row after every N steps (as many as make a period)' // nl // &
      '  --linear C         friction C times the rate, 1/s (0; rk4 only)' // nl // &
      '  --quadratic C      friction C times the rate squared (0; rk4 only)' // nl // &
      '  --drive F          drive F cos(W t), rad/s^2 (0; rk4 only)' // nl // &
      '  --drive-frequency W  rad/s (0)' // nl // &
      '  --length L         metres, or as 25cm (1)' // nl // &
      '  --gravity G        m/s^2 (9.80665)' // nl // &
      '  --format F         text, csv or json (text)' // nl // nl // &
      'With friction or drive the exact motion is the one without. Example:' // nl // nl // &
      '  furiko rk4 --amplitude 1rad --method forest-ruth --steps 50 --periods 1000 --every 5000'


   !> What the command line asks for
   type :: request
      type(pendulum) :: body
      logical :: by_amplitude = .true.
      type(double_word) :: angle = double_word(1.0_wp)
      real(wp) :: rate = 0.0_wp
      character(len=:), allocatable :: method
      integer :: steps = 100
      integer :: periods = 10
      integer :: every = 0
      !> Friction, drive and its frequency, as for the rates
      real(wp) :: forces(4) = 0.0_wp
      character(len=:), allocatable :: form
   end type request


contains


   subroutine rk4_command(arguments)
      type(argument_reader), intent(inout) :: arguments
      type(request) :: wish
      character(len=:), allocatable :: option
      logical :: known

      wish%method = 'rk4'
      wish%form = 'text'
      do while (.not. arguments%done())
         option = arguments%word()
         call arguments%advance()
         select case (option)
         case ('-h', '--help')
            call put(help)
            call finish()
            return
         case ('--format')
            wish%form = value_of(command, option, arguments)
         case ('--method')
            wish%method = value_of(command, option, arguments)
            if (all(wish%method /= [character(len=11) :: 'rk4', 'verlet', 'forest-ruth'])) then
               call reject("--method '" // wish%method // "' is none of rk4, verlet, forest-ruth")
            end if
         case ('--amplitude', '--angle', '--rate')
            call read_start(option, value_of(command, option, arguments), wish)
         case ('--steps', '--periods', '--every')
            call read_count(option, value_of(command, option, arguments), wish)
         case ('--linear', '--quadratic', '--drive', '--drive-frequency')
            call read_force(option, value_of(command, option, arguments), wish)
         case default
            call read_pendulum_option(command, option, arguments, wish%body, known)
            if (.not. known) call reject("unknown word '" // option // "'; see furiko rk4 --help")
         end select
      end do
      if (wish%method /= 'rk4' .and. any(abs(wish%forces) > 0.0_wp)) then
         call reject('friction and drive go with --method rk4 only')
      end if
      if (wish%every == 0) wish%every = wish%steps
      call print_steps(wish)
   end subroutine rk4_command


   subroutine read_start(option, word, wish)
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      type(request), intent(inout) :: wish

      wish%by_amplitude = option == '--amplitude'
      select case (option)
      case ('--amplitude')
         wish%angle = amplitude_of(command, option, word)
      case ('--angle')
         wish%angle = angle_at_start(command, option, word)
      case default
         wish%rate = rate_at_start(command, option, word)
      end select
   end subroutine read_start


   subroutine read_count(option, word, wish)
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      type(request), intent(inout) :: wish
      integer :: count

      count = integer_of(command // ': ' // option, word, 1, 1000000000)
      select case (option)
      case ('--steps')
         wish%steps = count
      case ('--periods')
         wish%periods = count
      case default
         wish%every = count
      end select
   end subroutine read_count


   subroutine read_force(option, word, wish)
      character(len=*), intent(in) :: option
      character(len=*), intent(in) :: word
      type(request), intent(inout) :: wish
      real(wp) :: force

      force = number_of(command // ': ' // option, word, pure_number(:0))
      select case (option)
      case ('--linear')
         wish%forces(1) = force
      case ('--quadratic')
         wish%forces(2) = force
      case ('--drive')
         wish%forces(3) = force
      case default
         wish%forces(4) = force
      end select
   end subroutine read_force


   subroutine print_steps(wish)
      type(request), intent(in) :: wish
      type(motion) :: path
      type(sheet) :: page
      real(wp) :: energy, h, omega2, period, t, y(2)
      integer(int64) :: i, rows

      if (wish%by_amplitude) then
         path = wish%body%swinging(wish%angle%hi, wish%angle%lo)
      else
         path = wish%body%started(wish%angle%hi, wish%rate, wish%angle%lo)
      end if
      period = path%period()
      if (.not. period <= huge(period)) call reject('on the separatrix there is no period')
      omega2 = wish%body%gravity/wish%body%length
      h = period/wish%steps
      rows = int(wish%steps, int64)*wish%periods/wish%every
      y = [path%angle(0.0_wp), path%rate(0.0_wp)]
      energy = energy_of(y, omega2)
      page = begin_sheet(command, wish%form, [character(len=16) :: 'periods', 'angle_rad', &
         'rate_rad_s', 'angle_error_rad', 'energy_error'], [character(len=8) :: 'f14.4', 'f20.12', &
         'f20.12', 'es16.4e3', 'es16.4e3'])
      do i = 0, rows
         if (i > 0) call advance(wish, omega2, h, real(i - 1, wp)*wish%every*h, y)
         t = real(i, wp)*(wish%every*h)
         call page%row([t/period, y, y(1) - path%angle(t), energy_of(y, omega2) - energy])
      end do
      call page%end()
      call finish()
   end subroutine print_steps


   !> `every` steps from the time t on
   subroutine advance(wish, omega2, h, t, y)
      type(request), intent(in) :: wish
      real(wp), intent(in) :: omega2
      real(wp), intent(in) :: h
      real(wp), intent(in) :: t
      real(wp), intent(inout) :: y(2)

      select case (wish%method)
      case ('verlet')
         call pendulum_verlet(omega2, h, wish%every, y(1), y(2))
      case ('forest-ruth')
         call pendulum_forest_ruth(omega2, h, wish%every, y(1), y(2))
      case default
         if (any(abs(wish%forces) > 0.0_wp)) then
            call rk4(driven_pendulum_rates, [omega2, wish%forces], t, h, wish%every, y)
         else
            call pendulum_rk4(omega2, h, wish%every, y(1), y(2))
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


   subroutine reject(message)
      character(len=*), intent(in) :: message

      call refuse(command // ': ' // message)
   end subroutine reject

end module furiko_cli_rk4
