! SPDX-License-Identifier: MIT

!> The pendulum at the command line: motion, period, amplitude, drift, converge, perimeter, rk4, digits.
module test_pendulum_cli
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use test_program, only : contents, line_count, run_program, run_shell
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   public :: collect_pendulum_cli


   character(len=*), parameter :: nl = new_line('a')

   !> One of each command with rows
   character(len=*), parameter :: samples(*) = [character(len=110) :: &
      'motion --amplitude 99 --to 1 --step .5 --columns time,angle,harmonic,rate,tension,turns,phase', &
      'motion --release 1rad --to 1 --step .5', &
      'motion --angle 10 --rate 7 --to 1 --step .5', &
      'period 45 1rad 0 --terms 3', &
      'amplitude --slower 3%', &
      'drift --amplitude 20', &
      'converge --k 1/2 --steps 6', &
      'perimeter 2 1 --terms 5', &
      'arc 3 1 --from 10 --to 75', &
      'arc 3 1 --from 10 --to 75 --equal 5', &
      'time --slack --angle 100 --rate -1', &
      'rk4 --periods 2']


contains


   subroutine collect_pendulum_cli(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('motion', test_motion), &
         new_unittest('motion-columns', test_columns), &
         new_unittest('period', test_period), &
         new_unittest('amplitude', test_amplitude), &
         new_unittest('drift', test_drift), &
         new_unittest('converge', test_converge), &
         new_unittest('perimeter', test_perimeter), &
         new_unittest('rk4', test_rk4), &
         new_unittest('digits', test_digits), &
         new_unittest('digits-next-to-1', test_digits_next_to_one), &
         new_unittest('units', test_units), &
         new_unittest('heads', test_heads), &
         new_unittest('every-option-does-something', test_options), &
         new_unittest('csv-is-the-text', test_csv), &
         new_unittest('text-fits-80-columns', test_width), &
         new_unittest('json-is-the-csv', test_json), &
         new_unittest('json-is-json', test_json_tool), &
         new_unittest('help', test_help), &
         new_unittest('every-help-to-the-byte', test_all_help), &
         new_unittest('refusals', test_refusals), &
         new_unittest('output-that-fails', test_output_failure)]
   end subroutine collect_pendulum_cli


   !> Starts at the top, at the bottom, anywhere; times of any unit; the last row is --to
   subroutine test_motion(error)
      type(error_type), allocatable, intent(out) :: error

      call expect(error, 'motion --release 1rad --to 0', '0.000000 1.000000 1.000000' // nl)
      if (allocated(error)) return
      call expect(error, 'motion --amplitude 1rad --to 20ms --step 0.01 --gravity 9.8', &
         '0.000000 0.000000 0.000000' // nl // '0.010000 0.030012 0.030012' // nl // &
         '0.020000 0.059994 0.059994' // nl)
      if (allocated(error)) return
      call expect(error, 'motion --angle=-30deg --rate 0 --from -1 --to -1 --columns time,angle,rate', &
         '      time_s   angle_rad  rate_rad_s' // nl // '   -1.000000    0.522552   -0.101287' // nl)
      if (allocated(error)) return
      ! a quarter of the length and of gravity changes nothing
      call expect(error, 'motion --release 90 --length 25cm --gravity 2.4516625 --from 1 --to 1', &
         '1.000000 -1.404720 -1.570717' // nl)
   end subroutine test_motion


   !> Over the top: turns are counted; to and fro: phase and tension
   subroutine test_columns(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      real(wp) :: row(6)
      integer :: code, stat

      call run_program('motion --angle 0 --rate 10 --from 60 --to 60 --columns ' // &
         'time,angle,turns,rate,energy,tension', output, errors, code)
      call check(error, code, 0, errors)
      if (allocated(error)) return
      call read_line(output(index(output, nl) + 1:), row, stat)
      call check(error, stat, 0)
      if (allocated(error)) return
      call check(error, abs(row(3) - anint(row(2)/acos(-1.0_wp)/2)) <= 0.0_wp .and. row(3) > 70)
      if (allocated(error)) return
      call check(error, abs(row(5) - row(4)**2/2 + 9.80665_wp*cos(row(2))) <= 1.0e-4_wp)
      if (allocated(error)) return
      call check(error, abs(row(6) - cos(row(2)) - row(4)**2/9.80665_wp) <= 1.0e-5_wp)
      if (allocated(error)) return
      call expect(error, 'motion --release 60 --at 0 --columns phase,tension,turns', &
         '       phase     tension  turns' // nl // '    0.250000    0.500000      0' // nl)
   end subroutine test_columns


   !> The header and a row for each amplitude; T grows with the root of the length
   subroutine test_period(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: row(5)

      call first_row(error, 'period 90deg', row(:4))
      if (allocated(error)) return
      call check(error, all(abs(row(:4) - [90.0_wp, 2.36824634628601_wp, 1.180340599016096_wp, &
         18.0340599016096_wp]) <= [1.0e-12_wp, 1.0e-14_wp, 1.0e-15_wp, 6.0e-11_wp]))
      if (allocated(error)) return
      call first_row(error, 'period 1rad --length 4 --gravity 1 --terms 3', row)
      if (allocated(error)) return
      call check(error, all(abs(row - [57.295779513082_wp, 13.3999513287409_wp, 1.066334245579963_wp, &
         6.63342455799630_wp, 1.064891499773949_wp]) <= 1.0e-10_wp))
      if (allocated(error)) return
      ! 3.4e-15 of the period, though T/T_h rounds to 1
      call first_row(error, 'period 1e-6rad', row(:4))
      if (allocated(error)) return
      call check(error, abs(row(4) - 6.25e-12_wp) <= 1.0e-23_wp)
      if (allocated(error)) return
      call first_row(error, 'period 179.99999999999999', row(:4))
      if (allocated(error)) return
      call check(error, abs(row(3) - 24.423191698516472_wp) <= 1.0e-14_wp)
   end subroutine test_period


   subroutine test_amplitude(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: row(3)

      call first_row(error, 'amplitude --slower 3%', row)
      if (allocated(error)) return
      call check(error, all(abs(row - [39.15878049131711_wp, 0.6834496506392064_wp, 39.25621850659067_wp]) &
         <= 5.0e-12_wp*row))
      if (allocated(error)) return
      call first_row(error, 'amplitude --slower 1e-15', row)
      if (allocated(error)) return
      call check(error, abs(row(2) - 1.264911064067351e-7_wp) <= 6.0e-19_wp)
      if (allocated(error)) return
      call first_row(error, 'amplitude --slower 1/10', row)
      if (allocated(error)) return
      call check(error, abs(row(1) - 69.32514596387685_wp) <= 6.0e-11_wp)
   end subroutine test_amplitude


   !> Ten swings for the note's 30 %; half as many for half of it
   subroutine test_drift(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: row(4), half(4)

      call first_row(error, 'drift --slower 3% --off 30% --gravity 9.8', row)
      if (allocated(error)) return
      call check(error, abs(row(3) - 10) <= 1.0e-12_wp)
      if (allocated(error)) return
      call check(error, abs(row(4) - 10.3_wp*8*atan(1.0_wp)/sqrt(9.8_wp)) <= 6.0e-11_wp)
      if (allocated(error)) return
      call first_row(error, 'drift --amplitude 39.15878049131711 --off 15%', half)
      if (allocated(error)) return
      call check(error, abs(half(3) - 5) <= 1.0e-11_wp)
   end subroutine test_drift


   !> Appendix C's digits; three columns for each way
   subroutine test_converge(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: row(10)
      character(len=:), allocatable :: errors, output
      integer :: code, stat

      call run_program('converge --k 1/2 --steps 8 --format csv', output, errors, code)
      call check(error, code == 0 .and. line_count(output) == 9)
      if (allocated(error)) return
      call read_line(output(index(output, nl // '6,') + 1:), row, stat)
      call check(error, stat, 0)
      if (allocated(error)) return
      call check(error, abs(row(5) - 1.685750354812606_wp) <= 0.0_wp .and. nint(row(7)) == 14)
      if (allocated(error)) return
      call check(error, abs(row(8) - 1.685750354812596_wp) <= 0.0_wp .and. nint(row(10)) == 28)
      if (allocated(error)) return
      call check(error, abs(row(3) + 1.48e-5_wp) <= 6.0e-8_wp .and. nint(row(4)) == 4)
   end subroutine test_converge


   !> Circle, needle, both huge, the series
   subroutine test_perimeter(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: two_pi = 8*atan(1.0_wp)
      real(wp) :: row(2)

      call first_row(error, 'perimeter 1 2', row(:1))
      if (allocated(error)) return
      call check(error, abs(row(1) - 9.688448220547675_wp) <= 6.0e-12_wp)
      if (allocated(error)) return
      call first_row(error, 'perimeter 1e300 1e300', row(:1))
      if (allocated(error)) return
      call check(error, abs(row(1)/1.0e300_wp - two_pi) <= 6.0e-12_wp)
      if (allocated(error)) return
      call first_row(error, 'perimeter 50cm 0', row(:1))
      if (allocated(error)) return
      call check(error, abs(row(1) - 2) <= 0.0_wp)
      if (allocated(error)) return
      call first_row(error, 'perimeter 1 2 --terms 1', row)
      if (allocated(error)) return
      call check(error, abs(row(2) - 2*two_pi) <= 6.0e-11_wp)
   end subroutine test_perimeter


   !> The methods' orders show: twice the steps, a sixteenth or a quarter of the error
   subroutine test_rk4(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: methods(3) = [character(len=11) :: 'rk4', 'verlet', 'forest-ruth']
      real(wp) :: off(2)
      integer :: i

      do i = 1, size(methods)
         off(1) = error_of('--steps 100')
         off(2) = error_of('--steps 200')
         call check(error, abs(off(1)) > 0.0_wp .and. abs(off(2)) > 0.0_wp, methods(i))
         if (allocated(error)) return
         call check(error, nint(log(abs(off(1)/off(2)))/log(2.0_wp)), merge(2, 4, i == 2), methods(i))
         if (allocated(error)) return
      end do


   contains


      !> Of the angle after a period
      function error_of(steps) result(off)
         character(len=*), intent(in) :: steps
         real(wp) :: off
         character(len=:), allocatable :: errors, output
         real(wp) :: row(5)
         integer :: code, stat

         call run_shell('furiko rk4 --periods 1 --method ' // trim(methods(i)) // ' ' // steps // &
            ' --format csv | tail -n 1', output, errors, code)
         call read_line(output, row, stat)
         off = merge(row(4), 0.0_wp, code == 0 .and. stat == 0)
      end function error_of
   end subroutine test_rk4


   subroutine test_digits(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_program('digits --k 1/2 --digits 33', output, errors, code)
      if (index(errors, 'real128') > 0) then
         call skip_test(error, 'this compiler has no real128')
         return
      end if
      call check(error, output, '1.68575035481259604287120365779908' // nl)
      if (allocated(error)) return
      call run_program('digits --k 0.5 --digits 50', output, errors, code)
      call check(error, code == 2 .and. index(errors, 'sh digits/run --k 0.5 --digits 50') > 0, errors)
   end subroutine test_digits


   !> 1 - k has all the digits that were typed, as a decimal and as a fraction; K of many digits
   subroutine test_digits_next_to_one(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: nines = repeat('9', 1000)
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_program('digits', output, errors, code)
      if (index(errors, 'real128') > 0) then
         call skip_test(error, 'this compiler has no real128')
         return
      end if
      call expect(error, 'digits --k 0.' // nines(:50), '58.6043480956910600645756345492964' // nl)
      if (allocated(error)) return
      call expect(error, 'digits --k -' // nines(:66) // 'e-66', '77.0250288396434255367195661867713' // nl)
      if (allocated(error)) return
      call expect(error, 'digits --k 0.' // nines, '1152.33226726786275997312157552437' // nl)
      if (allocated(error)) return
      call expect(error, 'digits --k ' // nines(:66) // '/1' // repeat('0', 66), &
         '77.0250288396434255367195661867713' // nl)
      if (allocated(error)) return
      call expect(error, 'digits --k -0.5/.75', '1.80966749548658849463748228937659' // nl)
      if (allocated(error)) return
      call expect(error, 'digits --k 1e-3000', '1.57079632679489661923132169163975' // nl)
      if (allocated(error)) return
      call expect(error, 'digits --digits 3 --k 0.' // nines, '1.15e3' // nl)
      if (allocated(error)) return
      call expect(error, 'digits --digits 4 --k 0.' // nines, '1152' // nl)
      if (allocated(error)) return
      call run_program('digits --k 0.' // repeat('9', 4801), output, errors, code)
      call check(error, code == 2 .and. output == '' .and. index(errors, '9 --digits 33' // nl) > 0, errors)
      if (allocated(error)) return
      call expect_refusal(error, 'digits --k 1.' // repeat('0', 100) // '1', errors)
      if (allocated(error)) return
      call expect_refusal(error, 'digits --k 3/0', errors)
   end subroutine test_digits_next_to_one


   !> A quantity in any unit is the same quantity, to the last digit
   subroutine test_units(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: pairs(2, 25) = reshape([character(len=48) :: &
         'period 45 --length 57cm', 'period 45 --length 0.57', &
         'period 45 --length 57cm', 'period 45 --length 570mm', &
         'period 45 --length 57cm', 'period 45 --length 0.57m', &
         'period 45 --length 0.00057km', 'period 45 --length 0.57', &
         'period 45 --length 7mm', 'period 45 --length 0.007', &
         'period 45deg', 'period 45', &
         'period 0.1rad', 'period 1e-1rad', &
         'amplitude --slower 3%', 'amplitude --slower 0.03', &
         'amplitude --slower 7%', 'amplitude --slower 7e-2', &
         'drift --amplitude 20 --off 29%', 'drift --amplitude 20 --off 0.29', &
         'motion --amplitude 1 --to 57ms --step 7ms', 'motion --amplitude 1 --to 0.057 --step 0.007', &
         'motion --amplitude 1 --to 1min --step 1', 'motion --amplitude 1 --to 60s --step 1s', &
         'motion --amplitude 1 --to 0.01h --step 0.1min', 'motion --amplitude 1 --to 36 --step 6', &
         'motion --release 45 --to 1', 'motion --angle 45deg --to 1s', &
         'rk4 --length 57cm', 'rk4 --length 0.57', &
         'perimeter 57cm 29cm', 'perimeter 0.57 0.29', &
         'period 45°', 'period 45', 'period pi/4', 'period 45', 'period 0.25pi', 'period 45', &
         'period 1/4πrad', 'period 45', "period 30°30\'", 'period 30.5', &
         "period 30deg30\'36\""", 'period 30.51', 'period 30°30′36″', 'period 30.51', &
         "motion --angle -30\'", 'motion --angle -0.5', "motion --angle -1°30\'", 'motion --angle -1.5'], &
         [2, 25])
      character(len=:), allocatable :: errors, one, other
      integer :: code, i

      do i = 1, size(pairs, 2)
         call run_program(trim(pairs(1, i)) // ' --format csv', one, errors, code)
         call check(error, code, 0, trim(pairs(1, i)) // ': ' // errors)
         if (allocated(error)) return
         call run_program(trim(pairs(2, i)) // ' --format csv', other, errors, code)
         call check(error, one, other, pairs(1, i))
         if (allocated(error)) return
      end do
   end subroutine test_units


   !> The first line of csv: every column's name, and its unit
   subroutine test_heads(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: all_columns = &
         'time,angle,harmonic,degrees,rate,energy,tension,turns,phase,rk4,error'
      character(len=*), parameter :: heads(2, 11) = reshape([character(len=120) :: &
         'period 1rad', 'amplitude_deg,period_s,period_ratio,slower_percent', &
         'period 1rad --terms 3', 'amplitude_deg,period_s,period_ratio,slower_percent,series', &
         'amplitude --slower 3%', 'amplitude_deg,amplitude_rad,three_terms_deg', &
         'drift --amplitude 20', 'amplitude_deg,slower_percent,swings,time_s', &
         'converge --k 1/2', 'n,series,series_error,series_digits,trapezoid,trapezoid_error,' // &
         'trapezoid_digits,agm,agm_error,agm_digits', &
         'perimeter 2 1', 'perimeter', &
         'rk4', 'periods,angle_rad,rate_rad_s,angle_error_rad,energy_error_s_2', &
         'time --release 9 --at 0', 'angle_deg,time_s,rate_rad_s,tension', &
         'arc 2 1', 'from_deg,to_deg,arc', 'arc 2 1 --equal 3', 'point,t_deg,x,y,arc', &
         'table --to 1', 'amplitude_deg,period_ratio'], [2, 11])
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(heads, 2)
         call run_program(trim(heads(1, i)) // ' --format csv', output, errors, code)
         call check(error, output(:index(output, nl) - 1), trim(heads(2, i)), heads(1, i))
         if (allocated(error)) return
      end do
      call run_program('motion --amplitude 1 --to 0 --format csv --columns ' // all_columns, output, &
         errors, code)
      call check(error, output(:index(output, nl) - 1), 'time_s,angle_rad,harmonic_rad,degrees,' // &
         'rate_rad_s,energy_s_2,tension,turns,phase,rk4_rad,error_rad')
   end subroutine test_heads


   !> Each option changes what is printed
   subroutine test_options(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: commands(*) = [character(len=40) :: &
         'motion --amplitude 60', 'period 60', 'drift --amplitude 20', 'converge', 'perimeter 2 1', &
         'rk4', 'rk4 --angle 10', 'arc 2 1', 'time --release 60 --at 3']
      character(len=*), parameter :: options(*) = [character(len=130) :: &
         '--from 1,--to 3,--step 1,--columns=time,--length 2,--gravity 1,--format csv,--format json', &
         '--terms 2,--length 2,--gravity 1,--format csv,--format json', &
         '--off 1,--length 2,--gravity 1,--format csv,--format json', &
         '--k 0.7,--steps 3,--format csv,--format json', &
         '--terms 2,--format csv,--format json', &
         '--amplitude 2,--method verlet,--steps 50,--periods 2,--every 50,--linear .1,--quadratic 1', &
         '--rate 1,--length 2,--gravity 1,--format csv,--format json,--drive 1 --drive-frequency 2', &
         '--from 1,--to 2,--from 9 --polar,--equal 3,--format csv,--format json', &
         '--length 2,--gravity 1,--format csv,--format json']
      character(len=:), allocatable :: errors, option, output, plain, rest
      integer :: code, comma, i

      do i = 1, size(commands)
         call run_program(trim(commands(i)), plain, errors, code)
         call check(error, code == 0 .and. errors == '', trim(commands(i)))
         if (allocated(error)) return
         rest = trim(options(i)) // ','
         do while (len(rest) > 0)
            comma = index(rest, ',')
            option = rest(:comma - 1)
            rest = rest(comma + 1:)
            call run_program(trim(commands(i)) // ' ' // option, output, errors, code)
            call check(error, code == 0 .and. output /= plain, trim(commands(i)) // ' ' // option)
            if (allocated(error)) return
         end do
      end do
   end subroutine test_options


   !> The same rows, and what the text says of a number is the number
   subroutine test_csv(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, header, output
      real(wp), allocatable :: csv(:), text(:)
      integer :: code, i

      do i = 1, size(samples)
         ! whose text has fewer columns
         if (index(samples(i), 'converge') == 1) cycle
         call run_program(trim(samples(i)) // ' --format csv', output, errors, code)
         call check(error, code == 0 .and. errors == '', samples(i))
         if (allocated(error)) return
         header = output(:index(output, nl))
         call check(error, verify(header, 'abcdefghijklmnopqrstuvwxyz_0123456789,' // nl), 0, header)
         if (allocated(error)) return
         csv = numbers_of(output(len(header) + 1:))
         call run_program(trim(samples(i)), output, errors, code)
         if (verify(output(1:1), ' ') == 0) output = output(index(output, nl) + 1:)
         output = output(:index(output // '(', '(') - 1)
         text = numbers_of(output)
         call check(error, size(csv) == size(text) .and. size(csv) > 0, samples(i))
         if (allocated(error)) return
         call check(error, all(abs(csv - text) <= 1.0e-6_wp*(1 + abs(csv))), samples(i))
         if (allocated(error)) return
      end do
   end subroutine test_csv


   !> No line is longer but where many columns were asked for, none has a star, and a head says what is below.
   subroutine test_width(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: commands(*) = [character(len=50) :: 'period 1 179.9999999 --terms 3', &
         'amplitude --slower 3%', 'drift --amplitude 1e-3', 'converge', 'perimeter 2 1 --terms 5', 'rk4', &
         'rk4 --angle 1 --rate 1e50 --periods 1', 'arc 3 1 --equal 20', 'arc 3e9 1 --equal 20', &
         'time --release 170 --at -169.9', 'motion --release 9 --columns time,angle,rate,error']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(commands)
         call run_shell('furiko ' // trim(commands(i)) // ' | grep -E -e "^.{80}." -e "[*]"', output, &
            errors, code)
         call check(error, output, '', commands(i))
         if (allocated(error)) return
         call run_shell('furiko ' // trim(commands(i)) // ' | head -n 1 | grep -c " [a-z][a-z_]*"', output, &
            errors, code)
         call check(error, output, '1' // nl, commands(i))
         if (allocated(error)) return
      end do
   end subroutine test_width


   !> Json without its names and brackets is csv without its header
   subroutine test_json(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: csv, errors, json
      integer :: code, i

      do i = 1, size(samples)
         call run_shell('furiko ' // trim(samples(i)) // ' --format csv | tail -n +2', csv, errors, code)
         call run_shell('furiko ' // trim(samples(i)) // ' --format json | sed -e ''s/"[^"]*": *//g'' ' // &
            '-e ''s/[][{}]//g'' -e ''s/^,//'' -e ''s/,$//'' -e ''s/, /,/g'' -e ''s/^ *//'' -e ''/^$/d''', &
            json, errors, code)
         call check(error, json, csv, trim(samples(i)))
         if (allocated(error)) return
      end do
   end subroutine test_json


   !> Another's parser takes it, and what is no number is null
   subroutine test_json_tool(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code, i

      call run_shell('command -v python3', output, errors, code)
      if (code /= 0) then
         call skip_test(error, 'no python3 here')
         return
      end if
      do i = 1, size(samples)
         call run_shell('furiko ' // trim(samples(i)) // ' --format json | python3 -m json.tool', output, &
            errors, code)
         call check(error, code == 0 .and. errors == '', trim(samples(i)) // ': ' // errors)
         if (allocated(error)) return
      end do
      call run_shell('furiko amplitude --slower 1000 --format json | python3 -m json.tool', output, errors, &
         code)
      call check(error, code == 0 .and. index(output, 'null') > 0)
   end subroutine test_json_tool


   !> Help says how, with an example, which works
   subroutine test_help(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: commands(*) = [character(len=9) :: 'motion', 'period', &
         'amplitude', 'drift', 'converge', 'perimeter', 'rk4', 'driven', 'digits', 'time', 'arc', 'help', &
         'table']
      character(len=:), allocatable :: errors, example, output
      integer :: code, i

      do i = 1, size(commands)
         call run_program(trim(commands(i)) // ' --help', output, errors, code)
         call check(error, code == 0 .and. errors == '' .and. &
            index(output, 'furiko ' // trim(commands(i))) == 1, commands(i))
         if (allocated(error)) return
         example = output(index(output, nl // '  furiko ', back=.true.) + 10:len(output) - 1)
         call run_program(example, output, errors, code)
         if (index(errors, 'no real128') > 0) cycle
         call check(error, code == 0 .and. line_count(output) > 0, example)
         if (allocated(error)) return
      end do
   end subroutine test_help


   !> What each --help says is in test/data/help.txt; -h is the same; a full disk is noticed.
   subroutine test_all_help(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: commands(*) = [character(len=10) :: '', 'table', 'motion', 'period', &
         'time', 'amplitude', 'drift', 'rk4', 'driven', 'converge', 'digits', 'perimeter', 'arc', 'plot', &
         'eval', 'animate', 'selftest', 'help', 'man', 'completion']
      character(len=:), allocatable :: all_help, errors, output
      integer :: code, i

      all_help = ''
      do i = 1, size(commands)
         call run_program(trim(commands(i)) // ' --help', output, errors, code)
         call check(error, code == 0 .and. errors == '', commands(i))
         if (allocated(error)) return
         all_help = all_help // '== furiko ' // trim(commands(i)) // nl // output
         call expect(error, trim(commands(i)) // ' -h', output)
         if (allocated(error)) return
         call run_program(trim(commands(i)) // ' --help >/dev/full', output, errors, code)
         call check(error, code == 1 .and. line_count(errors) == 1 .and. &
            index(errors, 'furiko: cannot write') == 1, trim(commands(i)) // ' --help: ' // errors)
         if (allocated(error)) return
      end do
      call check(error, all_help, contents('test/data/help.txt'))
   end subroutine test_all_help


   !> Code 2, nothing on standard output, one line that names the argument and its value
   subroutine test_refusals(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: commands(*) = [character(len=45) :: &
         'motion', 'motion --amplitude', 'motion --amplitude 180', 'motion --amplitude -180', &
         'motion --amplitude NaN', 'motion --amplitude 1e300', &
         'period pipi', 'period 1/2pi/3', 'period pi/0', 'period pi/1e400', 'period 5°°', 'period pi°', &
         'motion --amplitude 1grad', &
         'motion --angle 1 --rate 1e300', 'motion --angle 1 --rate 1deg', 'motion --angle 1e300', &
         'motion --amplitude 1 --to -1', 'motion --amplitude 1 --to 1e300', &
         'motion --amplitude 1 --to 5parsec', 'motion --amplitude 1 --step 0', &
         'motion --amplitude 1 --step -1', 'motion --amplitude 1 --step NaN', &
         'motion --amplitude 1 --step 1e-300', &
         'motion --amplitude 1 --length -1', 'motion --amplitude 1 --length 0', &
         'motion --amplitude 1 --length 1e300', 'motion --amplitude 1 --length 3ft', &
         'motion --amplitude 1 --gravity NaN', 'motion --amplitude 1 --gravity -9.8', &
         'motion --amplitude 1 --columns time,foo', 'motion --amplitude 1 --format xml', &
         'motion --amplitude 1 --nosuch', 'motion 1', &
         'period', 'period 180', 'period -1', 'period 1e300', 'period nan', 'period 3.2rad', &
         'period 45 --terms 0', 'period 45 --terms 1e9', 'period 45 --length -1', 'period --nosuch', &
         'amplitude', 'amplitude --slower 0', 'amplitude --slower -3%', 'amplitude --slower NaN', &
         'amplitude --slower 3deg', 'amplitude 3', 'converge 3', &
         'drift', 'drift --amplitude 180', 'drift --slower -1', 'drift --amplitude 20 --off 0', &
         'drift --amplitude 20 --off -1', 'drift --slower 3% --off 1e308', 'drift --off 3% --slower 1e308', &
         'drift --amplitude 20 --gravity 0', &
         'drift --amplitude 0', 'converge --k 1', 'converge --k -1.5', 'converge --k NaN', &
         'converge --steps 0', 'converge --steps 1e300', &
         'perimeter', 'perimeter 2 -1', 'perimeter 1 NaN', 'perimeter 1 1e999', &
         'perimeter 1 2 3', 'perimeter 1 2 --terms 0', &
         'rk4 --amplitude 180', 'rk4 --method euler', 'rk4 --steps 0', 'rk4 --periods -1', &
         'rk4 --every 0', 'rk4 --linear NaN', &
         'time', 'time --at 1', 'time --release 9 --at 10', 'arc 2', 'arc 2 0', 'arc 2 1 --equal 0', &
         'completion', 'completion tcsh', &
         'digits --k 1', 'digits --k NaN', 'digits --digits 34', 'digits --digits 0']
      !> Words that do not go together
      character(len=*), parameter :: combinations(*) = [character(len=45) :: &
         'motion --amplitude 1 --release 2', 'motion --amplitude 1 --rate 2', 'motion --rate 2', &
         "period 30°60\'", "period 30°-5\'", 'rk4 --steps 3 --steps 3', 'arc 2 1 --polar=1', &
         'motion --release 9 --at 1 --to 3', &
         'time --slack --release 9', 'rk4 --linear -20000', 'rk4 --quadratic -10', &
         'time --release 9', 'time --release 9 --at 1 --slack', 'motion --amplitude 1 --from 5 --to 1', &
         'drift --amplitude 20 --slower 3%', 'perimeter 1']
      character(len=:), allocatable :: errors, output, word
      integer :: code, i

      do i = 1, size(commands)
         word = trim(commands(i))
         call expect_refusal(error, word, errors)
         if (allocated(error)) return
         word = word(index(word, ' ', back=.true.) + 1:)
         if (scan(word, '0123456789') == 0) cycle
         call check(error, index(errors, word) > 0, trim(commands(i)) // ': ' // errors)
         if (allocated(error)) return
      end do
      do i = 1, size(combinations)
         call expect_refusal(error, trim(combinations(i)), errors)
         if (allocated(error)) return
      end do
   end subroutine test_refusals


   !> A full device: code 1, one line; a reader that leaves
   subroutine test_output_failure(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(samples)
         call run_program(trim(samples(i)) // ' >/dev/full', output, errors, code)
         call check(error, code == 1 .and. line_count(errors) == 1 .and. &
            index(errors, 'furiko: cannot write') == 1, trim(samples(i)) // ': ' // errors)
         if (allocated(error)) return
      end do
      call run_shell('{ furiko motion --amplitude 1 --to 1h --step 1ms && echo fine >&2; } | head -n 1', &
         output, errors, code)
      call check(error, line_count(output) == 1 .and. index(errors, 'fine') == 0 .and. &
         line_count(errors) <= 1, errors)
   end subroutine test_output_failure


   !> The program's whole answer
   subroutine expect(error, arguments, answer)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: arguments
      character(len=*), intent(in) :: answer
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_program(arguments, output, errors, code)
      call check(error, output // errors, answer, arguments)
   end subroutine expect


   !> Code 2 and one line by the command's name
   subroutine expect_refusal(error, arguments, errors)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: arguments
      character(len=:), allocatable, intent(out) :: errors
      character(len=:), allocatable :: command, output
      integer :: code

      call run_program(arguments, output, errors, code)
      command = 'furiko ' // arguments(:index(arguments // ' ', ' ') - 1) // ': '
      call check(error, code == 2 .and. output == '' .and. line_count(errors) == 1 .and. &
         index(errors, command) == 1, arguments // ': ' // errors)
   end subroutine expect_refusal


   !> The numbers of the first row of csv
   subroutine first_row(error, arguments, row)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: arguments
      real(wp), intent(out) :: row(:)
      character(len=:), allocatable :: errors, output
      integer :: code, stat

      call run_program(arguments // ' --format csv', output, errors, code)
      call check(error, code, 0, arguments // ': ' // errors)
      if (allocated(error)) return
      call read_line(output(index(output, nl) + 1:), row, stat)
      call check(error, stat, 0, arguments // ': ' // output)
   end subroutine first_row


   !> The numbers of a text's first line; stat /= 0 where it has fewer. (To `read`, the end of a line
   !> in the midst of a text is no blank.)
   subroutine read_line(text, numbers, stat)
      character(len=*), intent(in) :: text
      real(wp), intent(out) :: numbers(:)
      integer, intent(out) :: stat

      read(text(:index(text // nl, nl) - 1), *, iostat=stat) numbers
      if (stat /= 0) numbers = huge(numbers)
   end subroutine read_line


   !> All numbers of a text
   function numbers_of(text) result(numbers)
      character(len=*), intent(in) :: text
      real(wp), allocatable :: numbers(:)
      character(len=len(text)) :: words
      logical :: inside(0:len(text))
      integer :: i, stat

      words = text
      inside(0) = .false.
      do i = 1, len(text)
         inside(i) = scan(text(i:i), ' ,' // nl) == 0
         if (.not. inside(i)) words(i:i) = ' '
      end do
      allocate(numbers(count(inside(1:) .and. .not. inside(:len(text) - 1))))
      read(words, *, iostat=stat) numbers
      if (stat /= 0) numbers = huge(numbers)
   end function numbers_of

end module test_pendulum_cli
