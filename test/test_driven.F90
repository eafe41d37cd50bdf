! SPDX-License-Identifier: MIT

!> Driven, damped pendulums. The reference values were computed in 80-bit reals: Newton's method on the
!> strobe map with variational equations, by Taylor's method (heyoka 7.13.2), the last correction below
!> 1e-16; the long runs as said at each. What takes long is done in full only where this is compiled with
!> optimisation.
module test_driven
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan, ieee_value, ieee_quiet_nan
   use furiko, only : driven_amplitude, driven_attractors, driven_basins, driven_block, &
      driven_cascade, driven_cycle, driven_doubling, driven_exponents, driven_get, driven_is_near, &
      driven_least_rate, driven_left, driven_locking, driven_orbit, driven_order8, driven_pendulum, &
      driven_periods, driven_ran, driven_round, driven_return_torque, driven_rk4, driven_scheme, &
      driven_section, driven_set, driven_state, driven_steps, driven_uncertainty, driven_winding, &
      rk4
   use furiko_pendulum_rates_dp, only : driven_pendulum_rates
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   public :: collect_driven


#ifdef __OPTIMIZE__
   logical, parameter :: quick = .false.
#else
   logical, parameter :: quick = .true.
#endif
   real(wp), parameter :: pi = acos(-1.0_wp)

   !> A stable cycle: constants, periods and turns, its lowest point, the larger multiplier
   type :: known_cycle
      real(wp) :: damping, amplitude, frequency
      integer :: periods, turns
      real(wp) :: angle, rate, multiplier
   end type known_cycle

   type(known_cycle), parameter :: cycles(17) = [ &
      known_cycle(0.5_wp, 0.5_wp, 2/3.0_wp, &
         1, 0, 0.7105369988451944_wp, 0.3251184758238248_wp, 0.094780224842_wp), &
      known_cycle(0.5_wp, 0.9_wp, 2/3.0_wp, &
         1, 0, -0.5602283290650750_wp, 1.9335855133168071_wp, 0.094780224842_wp), &
      known_cycle(0.5_wp, 1.06_wp, 2/3.0_wp, &
         1, 0, -0.2465622651385916_wp, 1.9656436110254003_wp, 0.774097681222_wp), &
      known_cycle(0.5_wp, 1.073_wp, 2/3.0_wp, &
         2, 0, -0.3606178993680746_wp, 2.0008484457936546_wp, 0.008983291021_wp), &
      known_cycle(0.5_wp, 1.077_wp, 2/3.0_wp, &
         2, 0, -0.4049960286897573_wp, 2.0097399190552359_wp, 0.618768109861_wp), &
      known_cycle(0.5_wp, 1.077_wp, 2/3.0_wp, &
         3, 0, 0.5894651736139868_wp, 1.8678946579691358_wp, 0.416312761096_wp), &
      known_cycle(0.5_wp, 1.081_wp, 2/3.0_wp, &
         4, 0, -0.5050322258058407_wp, 2.0201653540097946_wp, 0.180485005342_wp), &
      known_cycle(0.5_wp, 1.0825_wp, 2/3.0_wp, &
         8, 0, -0.5460814748938234_wp, 2.0219232891628209_wp, 0.366645026446_wp), &
      known_cycle(0.5_wp, 1.35_wp, 2/3.0_wp, &
         1, -1, -0.0481465379786833_wp, 0.7626485806572769_wp, 0.094780224842_wp), &
      known_cycle(0.5_wp, 1.4_wp, 2/3.0_wp, &
         1, -1, -0.0722781452333297_wp, 0.9342791354117899_wp, 0.654596709729_wp), &
      known_cycle(0.5_wp, 1.45_wp, 2/3.0_wp, &
         2, -2, -0.0622105455025889_wp, 1.2244082249839484_wp, 0.452563375551_wp), &
      known_cycle(0.5_wp, 1.47_wp, 2/3.0_wp, &
         4, -4, -0.0642840657752635_wp, 1.3106546998097578_wp, 0.398908594154_wp), &
      known_cycle(0.1_wp, 2.1_wp, 1.0_wp, &
         1, 1, -1.0596935895343126_wp, 1.7582778754501927_wp, 0.730402691049_wp), &
      known_cycle(0.1_wp, 2.1_wp, 1.0_wp, &
         1, -1, -0.9977892434069384_wp, -0.8852984930911205_wp, 0.730402691049_wp), &
      known_cycle(0.2_wp, 1.66_wp, 1.0_wp, &
         1, 0, -2.4076612989213434_wp, 0.6773267669422969_wp, 0.533488091091_wp), &
      known_cycle(0.2_wp, 1.66_wp, 1.0_wp, &
         2, 2, -0.6099144618316626_wp, 1.6774638960008383_wp, 0.532040744088_wp), &
      known_cycle(0.2_wp, 1.66_wp, 1.0_wp, &
         2, -2, -0.7218814956933061_wp, -0.4620947428163678_wp, 0.532040744088_wp)]


contains


   subroutine collect_driven(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('orders', test_orders), &
         new_unittest('as-rk4', test_as_rk4), &
         new_unittest('tangents', test_tangents), &
         new_unittest('neighbours-do-not-matter', test_neighbours), &
         new_unittest('leaving', test_leaving), &
         new_unittest('parts-of-periods', test_parts), &
         new_unittest('symmetry', test_symmetry), &
         new_unittest('constants-by-number', test_constants), &
         new_unittest('cycles', test_cycles), &
         new_unittest('no-cycle', test_no_cycle), &
         new_unittest('symmetry-lost', test_symmetry_lost), &
         new_unittest('cascade', test_cascade), &
         new_unittest('rotating-cascade', test_rotating_cascade), &
         new_unittest('orbit-and-section', test_section), &
         new_unittest('exponents-of-cycles', test_exponents_of_cycles), &
         new_unittest('exponents-of-chaos', test_exponents_of_chaos), &
         new_unittest('return-torque', test_return_torque), &
         new_unittest('least-rate', test_least_rate), &
         new_unittest('locked-steps', test_locked_steps), &
         new_unittest('winding', test_winding), &
         new_unittest('attractors', test_attractors), &
         new_unittest('robust-basins', test_robust_basins), &
         new_unittest('early-arrivals', test_early_arrivals), &
         new_unittest('uncertainty', test_uncertainty)]
   end subroutine collect_driven


   !> Taylor's line of parameters
   elemental function taylor(amplitude) result(pendulum)
      real(wp), intent(in) :: amplitude
      type(driven_pendulum) :: pendulum

      pendulum = driven_pendulum(damping=0.5_wp, amplitude=amplitude, frequency=2/3.0_wp)
   end function taylor


   !> Cell centres of a square grid, angle in [-pi, pi]
   pure function grid(n, low, high) result(state)
      integer, intent(in) :: n
      real(wp), intent(in) :: low
      real(wp), intent(in) :: high
      type(driven_state) :: state(n*n)
      integer :: i, j

      do j = 1, n
         do i = 1, n
            state(i + (j - 1)*n)%angle = pi*((2*i - 1.0_wp)/n - 1.0_wp)
            state(i + (j - 1)*n)%rate = low + (high - low)*((j - 0.5_wp)/n)
         end do
      end do
   end function grid


   !> One member, some periods
   subroutine run_one(scheme, pendulum, state, periods)
      type(driven_scheme), intent(in) :: scheme
      type(driven_pendulum), intent(in) :: pendulum
      type(driven_state), intent(inout) :: state
      integer, intent(in) :: periods
      type(driven_state) :: one(1)

      one = state
      call driven_periods(scheme, [pendulum], one, periods)
      state = one(1)
   end subroutine run_one


   !> Four times as many steps: 1/65536 of the error, and 1/256
   subroutine test_orders(error)
      type(error_type), allocatable, intent(out) :: error
      type(driven_pendulum), parameter :: pendulum = driven_pendulum(damping=0.3_wp, quadratic=0.2_wp, &
         torque=0.1_wp, amplitude=0.8_wp, frequency=0.7_wp, phase=0.4_wp)
      integer, parameter :: steps(3) = [12, 24, 48]
      type(driven_state) :: exact, state
      real(wp) :: d8(3), d4(3)
      integer :: i

      ! No turn of the rate within the period: |rate| rate has a jump in its second derivative there.
      exact = driven_state(0.3_wp, 2.5_wp)
      call run_one(driven_order8(1000), taylor(0.6_wp), exact, 1)
      do i = 1, 3
         state = driven_state(0.3_wp, 2.5_wp)
         call run_one(driven_order8(steps(i)), taylor(0.6_wp), state, 1)
         d8(i) = hypot(state%angle - exact%angle, state%rate - exact%rate)
         state = driven_state(0.3_wp, 2.5_wp)
         call run_one(driven_rk4(10*steps(i)), taylor(0.6_wp), state, 1)
         d4(i) = hypot(state%angle - exact%angle, state%rate - exact%rate)
      end do
      call check(error, abs(log(d8(1)/d8(3))/log(4.0_wp) - 8) < 0.5_wp, 'order 8')
      if (allocated(error)) return
      call check(error, abs(log(d4(1)/d4(3))/log(4.0_wp) - 4) < 0.25_wp, 'order 4')
      if (allocated(error)) return
      ! All constants: both methods agree
      exact = driven_state(0.3_wp, 0.5_wp)
      call run_one(driven_order8(1000), pendulum, exact, 1)
      state = driven_state(0.3_wp, 0.5_wp)
      call run_one(driven_rk4(4000), pendulum, state, 1)
      call check(error, hypot(state%angle - exact%angle, state%rate - exact%rate) < 1.0e-10_wp, &
         'all constants')
   end subroutine test_orders


   !> The same steps as those of the general Runge-Kutta method
   subroutine test_as_rk4(error)
      type(error_type), allocatable, intent(out) :: error
      integer, parameter :: steps = 64
      type(driven_state) :: state
      real(wp) :: y(2)

      state = driven_state(0.3_wp, 0.5_wp)
      y = [state%angle, state%rate]
      call run_one(driven_rk4(steps), driven_pendulum(damping=0.3_wp, quadratic=0.2_wp, amplitude=0.8_wp, &
         frequency=0.7_wp), state, 1)
      call rk4(driven_pendulum_rates, [1.0_wp, 0.3_wp, 0.2_wp, 0.8_wp, 0.7_wp], 0.0_wp, &
         2*pi/(0.7_wp*steps), steps, y)
      call check(error, hypot(state%angle + 2*pi*state%turns - y(1), state%rate - y(2)) < 2.0e-14_wp)
      if (allocated(error)) return
      state = driven_state(0.3_wp, 0.5_wp)
      y = [state%angle, state%rate]
      call run_one(driven_rk4(steps), driven_pendulum(damping=0.3_wp, torque=0.2_wp, amplitude=0.8_wp, &
         frequency=0.7_wp, phase=0.6_wp), state, 1)
      call rk4(tilted_rates, [0.3_wp, 0.2_wp, 0.8_wp, 0.7_wp, 0.6_wp], 0.0_wp, 2*pi/(0.7_wp*steps), steps, y)
      call check(error, hypot(state%angle + 2*pi*state%turns - y(1), state%rate - y(2)) < 2.0e-14_wp, &
         'torque and phase')
   end subroutine test_as_rk4


   !> The tangent map against differences, and its determinant; one vector alone as both together
   subroutine test_tangents(error)
      type(error_type), allocatable, intent(out) :: error
      type(driven_pendulum), parameter :: pendulum = driven_pendulum(damping=0.3_wp, quadratic=0.2_wp, &
         torque=0.1_wp, amplitude=1.2_wp, frequency=0.7_wp, phase=0.4_wp)
      real(wp), parameter :: d = 1.0e-5_wp
      type(driven_scheme) :: scheme
      type(driven_state) :: state(5)
      real(wp) :: columns(2, 2, 5), single(2, 1, 5), differences(2, 2)
      integer :: i

      do i = 1, 2
         state = driven_state(0.3_wp, 0.5_wp)
         state%angle = state%angle + d*[0, 1, -1, 0, 0]
         state%rate = state%rate + d*[0, 0, 0, 1, -1]
         columns = spread(reshape([1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 2]), 3, 5)
         single = columns(:, :1, :)
         scheme = fine_scheme(i)
         call driven_periods(scheme, spread(pendulum, 1, 5), state, 1, columns)
         differences(1, :) = (state(2:4:2)%angle - state(3:5:2)%angle)/(2*d)
         differences(2, :) = (state(2:4:2)%rate - state(3:5:2)%rate)/(2*d)
         call check(error, maxval(abs(columns(:, :, 1) - differences)) < 1.0e-8_wp, 'differences')
         if (allocated(error)) return
         state = driven_state(0.3_wp, 0.5_wp)
         call driven_periods(scheme, spread(pendulum, 1, 5), state, 1, single)
         call check(error, all(abs(single(:, 1, 1) - columns(:, 1, 1)) <= 0.0_wp), 'one vector')
         if (allocated(error)) return
         columns = spread(reshape([1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 2]), 3, 5)
         state = driven_state(0.3_wp, 0.5_wp)
         call driven_periods(scheme, spread(taylor(1.2_wp), 1, 5), state, 1, columns)
         call check(error, abs(columns(1, 1, 1)*columns(2, 2, 1) - columns(1, 2, 1)*columns(2, 1, 1) &
            - exp(-1.5_wp*pi)) < 1.0e-12_wp, 'determinant')
         if (allocated(error)) return
      end do
   end subroutine test_tangents


   !> Either method, in steps as fine as rounding
   pure function fine_scheme(i) result(scheme)
      integer, intent(in) :: i
      type(driven_scheme) :: scheme

      if (i == 1) then
         scheme = driven_order8(128)
      else
         scheme = driven_rk4(4000)
      end if
   end function fine_scheme


   !> The same bits alone, in another place, and beside members that are none
   subroutine test_neighbours(error)
      type(error_type), allocatable, intent(out) :: error
      integer, parameter :: n = 3*driven_block/2
      type(driven_pendulum) :: pendulum(n)
      type(driven_state) :: state(n), one(1)
      integer :: i

      pendulum = taylor([(1.0_wp + 0.005_wp*i, i=1, n)])
      state = driven_state(0.2_wp, 0.1_wp)
      pendulum(3)%damping = ieee_value(1.0_wp, ieee_quiet_nan)
      state(5)%angle = 1.0e30_wp
      pendulum(8)%quadratic = -1.0_wp
      state(8)%rate = 3.0_wp
      call driven_periods(driven_order8(24), pendulum, state, 20)
      do i = 1, n, 7
         one = driven_state(0.2_wp, 0.1_wp)
         if (i == 8) one%rate = 3.0_wp
         call driven_periods(driven_order8(24), pendulum(i:i), one, 20)
         call check(error, one(1)%status == state(i)%status .and. one(1)%turns == state(i)%turns)
         if (allocated(error)) return
         if (one(1)%status /= driven_ran) cycle
         call check(error, abs(one(1)%angle - state(i)%angle) + abs(one(1)%rate - state(i)%rate) <= 0.0_wp)
         if (allocated(error)) return
      end do
      call check(error, count(state%status == driven_left) == 3 .and. all(state([3, 5, &
         8])%status == driven_left))
   end subroutine test_neighbours


   !> What a member that cannot go says, and that it stays so
   subroutine test_leaving(error)
      type(error_type), allocatable, intent(out) :: error
      type(driven_state) :: state(4)
      type(driven_pendulum) :: pendulum(4)

      pendulum = taylor(1.0_wp)
      pendulum(1)%frequency = 0.0_wp
      pendulum(2)%damping = -30.0_wp
      pendulum(3)%phase = 3.0e6_wp
      state = driven_state(0.1_wp, 0.1_wp)
      state(4)%status = driven_left
      call driven_periods(driven_rk4(64), pendulum, state, 3)
      call check(error, all(state%status == driven_left))
      if (allocated(error)) return
      call check(error, all(ieee_is_nan(state%angle)) .and. all(ieee_is_nan(state%rate)))
      if (allocated(error)) return
      pendulum = taylor(1.0_wp)
      state(2)%angle = 0.0_wp
      state(2)%rate = 0.0_wp
      call driven_periods(driven_rk4(64), pendulum, state, 1)
      call check(error, all(ieee_is_nan(state%angle)), 'who has left does not come back')
      if (allocated(error)) return
      state = driven_state(0.1_wp, 0.1_wp)
      call driven_periods(driven_rk4(64), pendulum, state, 0)
      call driven_steps(driven_rk4(64), pendulum, state, 5, -1)
      call check(error, all(abs(state%angle - 0.1_wp) <= 0.0_wp), 'no step was to be made')
   end subroutine test_leaving


   !> A period in parts ends where it ends at once, and turns are counted: 40 of a pendulum pushed hard
   subroutine test_parts(error)
      type(error_type), allocatable, intent(out) :: error
      type(driven_pendulum), parameter :: pendulum(1) = [driven_pendulum(damping=0.5_wp, torque=20.0_wp, &
         amplitude=1.0_wp, frequency=1.0_wp)]
      type(driven_scheme) :: scheme
      type(driven_state) :: whole(1), parts(1)
      real(wp) :: y(2)

      scheme = driven_order8(400)
      whole = driven_state(0.0_wp, 0.0_wp)
      parts = whole
      y = 0.0_wp
      call driven_steps(scheme, pendulum, whole, 0, 400)
      call driven_steps(scheme, pendulum, parts, 0, 137)
      call driven_steps(scheme, pendulum, parts, 400 + 137, 263)
      call check(error, whole(1)%turns == parts(1)%turns)
      if (allocated(error)) return
      call check(error, hypot(whole(1)%angle - parts(1)%angle, whole(1)%rate - parts(1)%rate) < 1.0e-11_wp)
      if (allocated(error)) return
      call driven_steps(scheme, pendulum, whole, 400, 100)
      parts = driven_state(0.0_wp, 0.0_wp)
      call driven_steps(scheme, pendulum, parts, 0, 500)
      call check(error, hypot(whole(1)%angle - parts(1)%angle, whole(1)%rate - parts(1)%rate) <= 0.0_wp, &
         'beyond the period')
      if (allocated(error)) return
      whole = driven_state(0.0_wp, 0.0_wp)
      call driven_steps(scheme, pendulum, whole, 0, 400)
      call rk4(tilted_rates, [0.5_wp, 20.0_wp, 1.0_wp, 1.0_wp, 0.0_wp], 0.0_wp, 2*pi/20000, 20000, y)
      call check(error, abs(whole(1)%angle) <= pi .and. whole(1)%turns == nint(y(1)/(2*pi), int64))
      if (allocated(error)) return
      call check(error, abs(whole(1)%angle + 2*pi*whole(1)%turns - y(1)) < 1.0e-9_wp)
   end subroutine test_parts


   !> theta'' = -p(1) theta' - sin(theta) + p(2) + p(3) cos(p(4) t + p(5))
   pure subroutine tilted_rates(t, y, parameters, rate)
      real(wp), intent(in) :: t
      real(wp), intent(in) :: y(:)
      real(wp), intent(in) :: parameters(:)
      real(wp), intent(out) :: rate(:)

      associate (p => parameters)
         rate(1) = y(2)
         rate(2) = -p(1)*y(2) - sin(y(1)) + p(2) + p(3)*cos(p(4)*t + p(5))
      end associate
   end subroutine tilted_rates


   !> (angle, rate) to (-angle, -rate), the drive half a turn on
   subroutine test_symmetry(error)
      type(error_type), allocatable, intent(out) :: error
      type(driven_pendulum) :: pendulum(2)
      type(driven_state) :: state(2)

      pendulum = taylor(1.2_wp)
      pendulum(2)%phase = pi
      state = [driven_state(0.4_wp, -0.3_wp), driven_state(-0.4_wp, 0.3_wp)]
      call driven_periods(driven_order8(64), pendulum, state, 2)
      call check(error, abs(state(1)%angle + state(2)%angle) < 1.0e-13_wp .and. &
         abs(state(1)%rate + state(2)%rate) < 1.0e-13_wp .and. state(1)%turns == -state(2)%turns)
   end subroutine test_symmetry


   !> The constants by number; and which states are near each other, upright too
   subroutine test_constants(error)
      type(error_type), allocatable, intent(out) :: error
      type(driven_state), parameter :: upright = driven_state(3.1_wp, 1.0_wp)
      type(driven_pendulum) :: pendulum
      integer :: i

      call check(error, driven_is_near(upright, driven_state(-3.1_wp, 1.0_wp), 0.1_wp) .and. .not. &
         driven_is_near(upright, driven_state(-3.1_wp, 1.05_wp), 0.1_wp))
      if (allocated(error)) return

      do i = 1, 6
         call driven_set(pendulum, i, 10.0_wp*i)
      end do
      call check(error, all(abs([pendulum%damping, pendulum%quadratic, pendulum%torque, pendulum%amplitude, &
         pendulum%frequency, pendulum%phase] - 10.0_wp*[1, 2, 3, 4, 5, 6]) <= 0.0_wp))
      if (allocated(error)) return
      call check(error, all(abs(driven_get(pendulum, [1, 2, 3, 4, 5, 6]) - 10.0_wp*[1, 2, 3, 4, 5, &
         6]) <= 0.0_wp))
      if (allocated(error)) return
      call check(error, ieee_is_nan(driven_get(pendulum, 7)))
   end subroutine test_constants


   !> The points of a known cycle, from its lowest one
   subroutine points_of(known, pendulum, points)
      type(known_cycle), intent(in) :: known
      type(driven_pendulum), intent(out) :: pendulum
      type(driven_state), allocatable, intent(out) :: points(:)
      integer :: i

      pendulum = driven_pendulum(damping=known%damping, amplitude=known%amplitude, frequency=known%frequency)
      allocate(points(known%periods))
      points(1) = driven_state(known%angle, known%rate)
      do i = 2, known%periods
         points(i) = points(i - 1)
         call run_one(driven_order8(96), pendulum, points(i), 1)
      end do
   end subroutine points_of


   !> Seventeen cycles: found again from a guess that is off, with multipliers, their product, and turns
   subroutine test_cycles(error)
      type(error_type), allocatable, intent(out) :: error
      type(driven_pendulum) :: pendulum
      type(driven_state), allocatable :: points(:)
      type(driven_scheme) :: scheme
      type(driven_round) :: round
      integer :: i
      logical :: found

      scheme = driven_order8(160)
      do i = 1, size(cycles)
         call points_of(cycles(i), pendulum, points)
         points%angle = points%angle + 1.0e-4_wp
         call driven_cycle(scheme, pendulum, points, round, found)
         call check(error, found)
         if (allocated(error)) return
         call check(error, max(abs(points(1)%angle - cycles(i)%angle), &
            abs(points(1)%rate - cycles(i)%rate)) < 2.0e-13_wp)
         if (allocated(error)) return
         call check(error, abs(abs(round%multipliers(1)) - cycles(i)%multiplier) < 3.0e-11_wp)
         if (allocated(error)) return
         call check(error, abs(product(round%multipliers)*exp(2*pi*cycles(i)%damping*cycles(i)%periods &
            /cycles(i)%frequency) - 1) < 1.0e-10_wp)
         if (allocated(error)) return
         call check(error, round%turns == cycles(i)%turns)
         if (allocated(error)) return
      end do
   end subroutine test_cycles


   !> Where there is no cycle next to the guess, it is not found; a member that leaves is none
   subroutine test_no_cycle(error)
      type(error_type), allocatable, intent(out) :: error
      type(driven_state) :: points(1)
      type(driven_round) :: round
      logical :: found

      points = driven_state(0.0_wp, 0.0_wp)
      ! Beyond the torque of 1 and far from any resonance, the pendulum turns faster than the drive.
      call driven_cycle(driven_order8(64), driven_pendulum(damping=0.1_wp, torque=1.3_wp, &
         frequency=1.0_wp), points, &
         round, found)
      call check(error, .not. found)
      if (allocated(error)) return
      points%rate = ieee_value(1.0_wp, ieee_quiet_nan)
      call driven_cycle(driven_order8(64), taylor(0.5_wp), points, round, found)
      call check(error, .not. found)
   end subroutine test_no_cycle


   subroutine test_symmetry_lost(error)
      type(error_type), allocatable, intent(out) :: error
      type(driven_pendulum) :: pendulum
      type(driven_state) :: points(1)
      type(driven_round) :: round
      logical :: found

      pendulum = taylor(0.9_wp)
      points = driven_state(-0.56_wp, 1.93_wp)
      call driven_doubling(driven_order8(128), pendulum, driven_amplitude, 0.02_wp, points, round, found, &
         half=.true.)
      call check(error, found)
      if (allocated(error)) return
      call check(error, abs(pendulum%amplitude - 1.0043194774264679_wp) < 1.0e-12_wp)
      if (allocated(error)) return
      call check(error, abs(points(1)%angle + 1.0719543148780_wp) < 2.0e-12_wp .and. &
         abs(points(1)%rate - 1.8972317332806_wp) < 2.0e-12_wp)
   end subroutine test_symmetry_lost


   !> Taylor's cascade: periods 1, 2, 4, ... 128
   subroutine test_cascade(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: known(8) = [1.066372862455207_wp, 1.079313905903716_wp, 1.082084384294223_wp, &
         1.082678352704016_wp, 1.082805591155019_wp, 1.082832843255940_wp, 1.082838679887154_wp, &
            1.082839929917962_wp]
      real(wp), parameter :: ratios(6) = [4.67105_wp, 4.66435_wp, 4.66815_wp, 4.66894_wp, 4.669149_wp, &
         4.669190_wp]
      real(wp), parameter :: last_digit(6) = [6.0e-6_wp, 6.0e-6_wp, 6.0e-6_wp, 6.0e-6_wp, 2.0e-6_wp, &
         4.0e-6_wp]
      real(wp), parameter :: feigenbaum = 4.669201609_wp
      real(wp) :: thresholds(merge(3, 8, quick)), gaps(size(thresholds) - 1)
      integer :: found, n

      n = size(thresholds)
      call driven_cascade(driven_order8(128), taylor(1.06_wp), driven_amplitude, 0.002_wp, &
         [driven_state(-0.25_wp, 1.97_wp)], thresholds, found)
      call check(error, found, n)
      if (allocated(error)) return
      call check(error, all(abs(thresholds/known(:n) - 1) < 1.0e-12_wp))
      if (allocated(error) .or. quick) return
      gaps = thresholds(2:) - thresholds(:n - 1)
      call check(error, all(abs(gaps(:n - 2)/gaps(2:) - ratios(:n - 2)) < last_digit(:n - 2)))
      if (allocated(error)) return
      call check(error, abs(thresholds(n) + gaps(n - 1)/(feigenbaum - 1) - 1.08284027060_wp) < 1.0e-11_wp)
   end subroutine test_cascade


   !> Baker and Gollub's window of rotations
   subroutine test_rotating_cascade(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: thresholds(2)
      integer :: found

      call driven_cascade(driven_order8(128), taylor(1.4_wp), driven_amplitude, 0.005_wp, &
         [driven_state(-0.07_wp, 0.93_wp)], thresholds, found)
      call check(error, found, 2)
      if (allocated(error)) return
      call check(error, all(abs(thresholds - [1.4248732472060878_wp, 1.4598246038432490_wp]) < 1.0e-12_wp))
   end subroutine test_rotating_cascade


   !> The section of an orbit is a row of a section; a family of members is a bifurcation diagram
   subroutine test_section(error)
      type(error_type), allocatable, intent(out) :: error
      type(driven_state) :: state, family(3), orbit(40), points(8, 3)
      type(driven_scheme) :: scheme

      scheme = driven_order8(64)
      state = driven_state(0.1_wp, 0.0_wp)
      call driven_orbit(scheme, taylor(1.073_wp), state, 16, orbit)
      call check(error, abs(state%angle - orbit(40)%angle) <= 0.0_wp)
      if (allocated(error)) return
      family = driven_state(0.1_wp, 0.0_wp)
      call driven_section(scheme, taylor([0.9_wp, 1.073_wp, 1.2_wp]), family, 2, points)
      call check(error, all(driven_is_near(orbit(12::4), points(:, 2), 1.0e-10_wp)))
      if (allocated(error)) return
      call driven_section(scheme, taylor([0.9_wp, 1.073_wp, 1.2_wp]), family, 200, points)
      call check(error, all(driven_is_near(points(2:, 1), points(:7, 1), 1.0e-9_wp)), 'period 1')
      if (allocated(error)) return
      call check(error, all(driven_is_near(points(3:, 2), points(:6, 2), 1.0e-9_wp)) .and. &
         .not. any(driven_is_near(points(2:, 2), points(:7, 2), 0.1_wp)), 'period 2')
   end subroutine test_section


   !> ln|multiplier|/(n T) each; the sum is -b, and -b - 2 c <|rate|> with quadratic damping
   subroutine test_exponents_of_cycles(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: known(5) = [-0.25_wp, -0.25_wp, -0.25_wp, -0.042061_wp, -0.024378_wp]
      type(driven_pendulum) :: pendulum(6)
      type(driven_state) :: state(6)
      real(wp) :: exponents(2, 6), errors(6)

      pendulum = taylor([0.5_wp, 0.9_wp, 1.35_wp, 1.45_wp, 1.47_wp, 1.2_wp])
      pendulum(6)%damping = ieee_value(1.0_wp, ieee_quiet_nan)
      state = driven_state(0.2_wp, 0.1_wp)
      call driven_exponents(driven_order8(48), pendulum, state, 300, 320, exponents, errors)
      call check(error, all(abs(exponents(1, 4:5) - known(4:)) < 1.0e-6_wp))
      if (allocated(error)) return
      ! The first three turn round in the plane of the tangents: the error goes as 1/periods.
      call check(error, all(abs(exponents(1, :3) - known(:3)) < 2.0e-3_wp))
      if (allocated(error)) return
      call check(error, all(abs(sum(exponents(:, :5), 1) + 0.5_wp) < 1.0e-8_wp))
      if (allocated(error)) return
      call check(error, all(ieee_is_nan(exponents(:, 6))) .and. ieee_is_nan(errors(6)))
   end subroutine test_exponents_of_cycles


   !> Mean exponents of many starts within the stated bars (or four of their standard errors, where fewer
   !> periods are run): 8 x 1e5 periods by Taylor's method at 1e-16, 512 x 4000 by RK4 of 256 steps
   subroutine test_exponents_of_chaos(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: damping(5) = [0.5_wp, 0.5_wp, 0.5_wp, 0.25_wp, 0.25_wp]
      real(wp), parameter :: amplitude(5) = [1.15_wp, 1.2_wp, 1.5_wp, 1.5_wp, 1.15_wp]
      real(wp), parameter :: known(5) = [0.0994_wp, 0.1319_wp, 0.1125_wp, 0.1637_wp, 0.1009_wp]
      real(wp), parameter :: bar(5) = [5.0e-4_wp, 5.0e-4_wp, 3.0e-4_wp, 4.0e-4_wp, 4.0e-4_wp]
      integer, parameter :: members = merge(64, 512, quick), periods = merge(64, 1024, quick)
      type(driven_pendulum) :: pendulum(members)
      type(driven_state) :: state(members)
      real(wp) :: exponents(2, members), errors(members), mean, spread_of
      integer :: i

      do i = 1, merge(1, 5, quick)
         pendulum = driven_pendulum(damping=damping(i), amplitude=amplitude(i), frequency=2/3.0_wp)
         state(:) = grid_line(members)
         call driven_exponents(driven_order8(24), pendulum, state, 64, periods, exponents, errors)
         mean = sum(exponents(1, :))/members
         spread_of = sqrt(sum((exponents(1, :) - mean)**2)/(members*(members - 1.0_wp)))
         call check(error, abs(mean - known(i)) < max(bar(i), 4*spread_of))
         if (allocated(error)) return
         call check(error, abs(sqrt(sum(errors**2))/members/spread_of - 1) < merge(0.5_wp, 0.3_wp, quick), &
            'the error that a member states')
         if (allocated(error)) return
      end do
   end subroutine test_exponents_of_chaos


   pure function grid_line(n) result(state)
      integer, intent(in) :: n
      type(driven_state) :: state(n)
      integer :: i

      state%angle = [(pi*((2*i - 1.0_wp)/n - 1.0_wp), i=1, n)]
   end function grid_line


   subroutine test_return_torque(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: b(5) = [0.1_wp, 0.25_wp, 0.5_wp, 0.75_wp, 1.0_wp]
      real(wp), parameter :: known(5) = [0.1270088598054_wp, 0.3133903090910_wp, 0.5973832003112_wp, &
         0.8233042111392_wp, 0.9643271244707_wp]
      integer :: i

      do i = 1, merge(3, 5, quick)
         call check(error, abs(driven_return_torque(b(i)) - known(i)) < 5.0e-13_wp)
         if (allocated(error)) return
      end do
      call check(error, ieee_is_nan(driven_return_torque(0.0_wp)) .and. &
         ieee_is_nan(driven_return_torque(11.0_wp)))
      if (allocated(error) .or. quick) return
      call check(error, abs(driven_return_torque(1.5_wp) - 1) < 1.0e-12_wp)
   end subroutine test_return_torque


   subroutine test_least_rate(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: known(3, 2) = reshape([2.203798919109_wp, 2.708342011733_wp, 3.258284670118_wp, &
         3.088511869746_wp, 6.066813868106_wp, 9.152495851562_wp], [3, 2])
      integer :: i

      do i = 1, merge(1, 3, quick)
         call check(error, abs(driven_least_rate(0.1_wp, i) - known(i, 1)) < 1.1e-11_wp)
         if (allocated(error)) return
         call check(error, abs(driven_least_rate(0.5_wp, i) - known(i, 2)) < 1.1e-11_wp)
         if (allocated(error)) return
      end do
      call check(error, abs(driven_least_rate(0.0_wp, 1) - 2) < 1.0e-12_wp)
      if (allocated(error)) return
      call check(error, ieee_is_nan(driven_least_rate(0.1_wp, 0)) .and. &
         ieee_is_nan(driven_least_rate(-0.1_wp, 1)))
   end subroutine test_least_rate


   !> From rest; exact whole numbers and fractions
   subroutine test_locked_steps(error)
      type(error_type), allocatable, intent(out) :: error
      integer, parameter :: n = 16
      real(wp), parameter :: torque(n) = [0.2_wp, 0.4_wp, 0.6_wp, 0.7_wp, 0.8_wp, 0.9_wp, 1.0_wp, &
         1.1_wp, 1.2_wp, &
         1.3_wp, 1.4_wp, 1.5_wp, 0.4_wp, 0.85_wp, 1.1_wp, 1.3_wp]
      integer, parameter :: turns_known(n) = [0, 0, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 0, 0, 1, 1]
      integer, parameter :: periods_known(n) = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 3, 2]
      type(driven_pendulum) :: pendulum(n)
      type(driven_state) :: state(n)
      integer :: period(n)
      integer(int64) :: turns(n)

      pendulum = driven_pendulum(damping=1.0_wp, amplitude=1.0_wp, frequency=0.6_wp)
      pendulum(13:) = driven_pendulum(damping=2.0_wp, amplitude=1.5_wp, frequency=1.0_wp)
      pendulum%torque = torque
      state = driven_state()
      call driven_periods(driven_order8(48), pendulum, state, 200)
      call driven_locking(driven_order8(48), pendulum, state, 8, 1.0e-6_wp, period, turns)
      ! The period may be a multiple where symmetry or a doubling makes it one; the ratio is what is locked.
      call check(error, all(period > 0) .and. all(turns*periods_known == turns_known*period))
   end subroutine test_locked_steps


   !> Unlocked: over 1200 periods, to 1e-3
   subroutine test_winding(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: known(4) = [0.0650_wp, 0.2435_wp, 0.4327_wp, 0.6473_wp]
      type(driven_pendulum) :: pendulum(5)
      type(driven_state) :: state(5)
      real(wp) :: winding(5)

      pendulum = driven_pendulum(damping=2.0_wp, amplitude=1.5_wp, frequency=1.0_wp)
      pendulum(:4)%torque = [0.9_wp, 1.0_wp, 1.2_wp, 1.5_wp]
      pendulum(5)%amplitude = ieee_value(1.0_wp, ieee_quiet_nan)
      state = driven_state()
      call driven_winding(driven_order8(24), pendulum, state, 100, 1200, winding)
      call check(error, all(abs(winding(:4) - known) < 1.0e-3_wp))
      if (allocated(error)) return
      call check(error, ieee_is_nan(winding(5)))
   end subroutine test_winding


   !> Found by starts: those of the table, and no others
   subroutine test_attractors(error)
      type(error_type), allocatable, intent(out) :: error
      type(driven_state) :: state(64), points(8)
      integer :: label(8), found

      state = grid(8, -2.0_wp, 4.0_wp)
      call driven_attractors(driven_order8(48), driven_pendulum(damping=0.2_wp, amplitude=1.66_wp, &
         frequency=1.0_wp), &
         state, 150, 4, points, label, found)
      call check(error, found, 3)
      if (allocated(error)) return
      call check(error, all(label == [1, 2, 2, 3, 3, 0, 0, 0]))
      if (allocated(error)) return
      call check(error, all(abs(points([1])%angle - cycles(15)%angle) < 1.0e-8_wp))
      if (allocated(error)) return
      call check(error, any(abs(points%angle - cycles(16)%angle) < 1.0e-8_wp .and. points%turns == 2) .and. &
         any(abs(points%angle - cycles(17)%angle) < 1.0e-8_wp .and. points%turns == -2))
   end subroutine test_attractors


   !> Every cell as in 80 bits: counts, and the same in other steps
   subroutine test_robust_basins(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: amplitudes(2) = [1.35_wp, 1.4_wp]
      integer, parameter :: backwards(2) = [576, 625]
      type(driven_state) :: state(1024), few(16), points(4)
      integer :: label(4), found, basin(1024, 2), arrival(1024), i, j, k

      do i = 1, 2
         few = grid(4, -3.0_wp, 3.0_wp)
         call driven_attractors(driven_order8(48), taylor(amplitudes(i)), few, 150, 4, points, label, found)
         call check(error, found, 2)
         if (allocated(error)) return
         do j = 1, 2
            state = grid(32, -3.0_wp, 3.0_wp)
            call driven_basins(driven_order8(merge(48, 40, j == 1)), taylor(amplitudes(i)), state, &
               points, label, &
               1.0e-3_wp, 200, basin(:, j), arrival)
         end do
         call check(error, all(basin(:, 1) == basin(:, 2)))
         if (allocated(error)) return
         k = label(minloc(points(:2)%turns, 1))
         call check(error, count(basin(:, 1) == k), backwards(i))
         if (allocated(error)) return
         call check(error, count(basin(:, 1) > 0), 1024)
         if (allocated(error)) return
         call check_company(error, taylor(amplitudes(i)), points(:found), label(:found), basin(:, 2), arrival)
         if (allocated(error)) return
      end do
   end subroutine test_robust_basins


   !> In another company, where others come first, each start comes to the same at the same time,
   !> and stays there.
   subroutine check_company(error, pendulum, points, label, basin, arrival)
      type(error_type), allocatable, intent(out) :: error
      type(driven_pendulum), intent(in) :: pendulum
      !> Attractors of one point each, and what comes to them in order
      type(driven_state), intent(in) :: points(:)
      integer, intent(in) :: label(:)
      integer, intent(in) :: basin(1024)
      integer, intent(in) :: arrival(1024)
      type(driven_state) :: state(1024), there(1024)
      integer :: other(1024), when(1024), i

      state = grid(32, -3.0_wp, 3.0_wp)
      state = [(state(modulo(391*i, 1024) + 1), i=1, 1024)]
      call driven_basins(driven_order8(40), pendulum, state, points, label, 1.0e-3_wp, 200, other, when)
      call check(error, all(other == [(basin(modulo(391*i, 1024) + 1), i=1, 1024)]))
      if (allocated(error)) return
      call check(error, all(when == [(arrival(modulo(391*i, 1024) + 1), i=1, 1024)]))
      if (allocated(error)) return
      there = [(points(findloc(label, other(i), 1)), i=1, 1024)]
      call check(error, all(abs(state%angle - there%angle) + abs(state%rate - there%rate) <= 1.0e-3_wp))
   end subroutine check_company


   !> What has arrived early, cell by cell; of the end, numbers within three standard errors
   subroutine test_early_arrivals(error)
      type(error_type), allocatable, intent(out) :: error
      integer, parameter :: by_ten(3) = [45, 45, 36], by_twenty(3) = [673, 547, 593], ends(3) = [907, &
         1542, 1647]
      type(driven_state), allocatable :: points(:), more(:)
      type(driven_state), allocatable :: state(:)
      type(driven_state) :: all_points(5)
      type(driven_pendulum) :: pendulum
      integer :: basin(4096), arrival(4096), i

      call points_of(cycles(15), pendulum, points)
      all_points(1:1) = points
      call points_of(cycles(16), pendulum, more)
      all_points(2:3) = more
      call points_of(cycles(17), pendulum, more)
      all_points(4:5) = more
      state = grid(64, -2.0_wp, 4.0_wp)
      call driven_basins(driven_order8(48), pendulum, state, all_points, [1, 2, 2, 3, 3], 1.0e-3_wp, &
         merge(20, 400, quick), basin, arrival)
      do i = 1, 3
         call check(error, count(basin == i .and. arrival <= 10), by_ten(i))
         if (allocated(error)) return
         call check(error, abs(count(basin == i .and. arrival <= 20) - by_twenty(i)) <= 1)
         if (allocated(error)) return
         if (quick) cycle
         call check(error, abs(count(basin == i) - ends(i)) < 3*sqrt(real(ends(i), wp)))
         if (allocated(error)) return
      end do
      call check(error, all((basin > 0) .eqv. (arrival >= 0)))
      if (allocated(error)) return
      state = grid(64, -2.0_wp, 4.0_wp)
      call points_of(cycles(13), pendulum, points)
      call points_of(cycles(14), pendulum, more)
      call driven_basins(driven_order8(48), pendulum, state, [points, more], [1, 2], 1.0e-3_wp, 20, &
         basin, arrival)
      call check(error, count(basin == 1), 66)
      if (allocated(error)) return
      call check(error, count(basin == 2), 60)
   end subroutine test_early_arrivals


   !> alpha = 0.0563(15), and the uncertain part 0.537(8) at 1e-2, 0.366(8) at 1e-5, here from fewer starts
   subroutine test_uncertainty(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: epsilons(3) = [1.0e-2_wp, 1.0e-5_wp, 1.5e-6_wp]
      type(driven_state), allocatable :: points(:), more(:), start(:)
      type(driven_pendulum) :: pendulum
      real(wp) :: uncertain(size(epsilons)), alpha, deviation, parts

      call points_of(cycles(13), pendulum, points)
      call points_of(cycles(14), pendulum, more)
      start = grid(merge(8, 48, quick), -2.0_wp, 4.0_wp)
      call driven_uncertainty(driven_order8(24), pendulum, start, [points, more], [1, 2], 1.0e-3_wp, &
         merge(200, 2000, quick), epsilons, uncertain, alpha, deviation)
      parts = 4*hypot(0.5_wp/sqrt(real(size(start), wp)), 0.008_wp)
      call check(error, abs(uncertain(1) - 0.537_wp) < parts .and. abs(uncertain(2) - 0.366_wp) < parts)
      if (allocated(error)) return
      call check(error, abs(alpha - 0.0563_wp) < 4*hypot(deviation, 0.0015_wp))
      if (allocated(error)) return
      call check(error, deviation < merge(0.05_wp, 0.005_wp, quick))
   end subroutine test_uncertainty

end module test_driven
