! SPDX-License-Identifier: MIT

!> What the program promises at the command line: bytes, exit codes, one line on standard error.
module test_cli
   use furiko, only : furiko_version
   use test_program, only : contents, line_count, run_program, run_shell
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   public :: collect_cli


   character(len=*), parameter :: nl = new_line('a')


contains


   subroutine collect_cli(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('fractions-of-a-degree', test_fractions), &
         new_unittest('next-to-180', test_next_to_180), &
         new_unittest('last-row-is-to', test_last_row), &
         new_unittest('long-table', test_long_table), &
         new_unittest('csv', test_csv), &
         new_unittest('json', test_json), &
         new_unittest('help-and-version', test_help), &
         new_unittest('refusals', test_refusals), &
         new_unittest('session', test_session), &
         new_unittest('session-of-digits', test_digits_session), &
         new_unittest('printed-digits-are-right', test_commands), &
         new_unittest('output-that-fails', test_output_failure)]
   end subroutine collect_cli


   !> Decimals stay what was typed: 0.3 is three tenths, and ten steps of 0.1 make 1.0
   subroutine test_fractions(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_program('table --from 0.1 --to 1 --step .3', output, errors, code)
      call check(error, output, &
         '  0.1    1.000000190385921' // nl // '  0.4    1.000003046182704' // nl // &
         '  0.7    1.000009328988258' // nl // '  1.0    1.000019038921006' // nl)
      if (allocated(error)) return
      call run_program('--from=89.9995d0 --to 90 --step 5e-4 --format=text', output, errors, code)
      call check(error, output, &
         ' 89.9995    1.180338245657652' // nl // ' 90.0000    1.180340599016096' // nl)
   end subroutine test_fractions


   !> Where a real64 angle, a real64 sine and 1 - k*k each lose everything
   subroutine test_next_to_180(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_program('table --from 179.999999 --to 179.999999', output, errors, code)
      call check(error, output, '179.999999   12.696222116445628' // nl)
      if (allocated(error)) return
      call run_program('table --from 179.99999999999999 --to 179.99999999999999', output, errors, code)
      call check(error, output, '179.99999999999999   24.423191698516472' // nl)
   end subroutine test_next_to_180


   !> --to is a row also where the steps miss it
   subroutine test_last_row(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_program('table --step 100 --to 150', output, errors, code)
      call check(error, output, ' 0    1.000000000000000' // nl // &
         '100    1.232229196737520' // nl // '150    1.762203729503756' // nl)
   end subroutine test_last_row


   !> However many rows, they ask for no more memory
   subroutine test_long_table(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_shell('ulimit -s 512; furiko --step 0.005 | tail -n 1', output, errors, code)
      call check(error, output, '179.000    3.901065160389086' // nl, errors)
   end subroutine test_long_table


   subroutine test_csv(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_program('table --from 60 --to 61 --step .5 --format csv', output, errors, code)
      call check(error, output, 'amplitude_deg,period_ratio' // nl // '60.0,1.073182007149364' // nl &
         // '60.5,1.074492158983775' // nl // '61.0,1.075816264757340' // nl)
   end subroutine test_csv


   !> One array of objects, without a comma behind the last
   subroutine test_json(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_program('table --to 90 --step 90 --format json', output, errors, code)
      call check(error, output, '[' // nl // &
         '{"amplitude_deg": 0, "period_ratio": 1.000000000000000}' // nl // &
         ',{"amplitude_deg": 90, "period_ratio": 1.180340599016096}' // nl // ']' // nl)
   end subroutine test_json


   !> Help answers on standard output; the version is the manifest's
   subroutine test_help(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      character(len=100) :: line
      integer :: code, unit

      call run_program('--help', output, errors, code)
      call check(error, code == 0 .and. index(output, 'furiko [COMMAND]') == 1 .and. errors == '')
      if (allocated(error)) return
      call run_program('table -h', output, errors, code)
      call check(error, code == 0 .and. index(output, 'furiko table [OPTIONS]') == 1)
      if (allocated(error)) return
      call run_program('--version', output, errors, code)
      call check(error, output, 'furiko ' // furiko_version // nl)
      if (allocated(error)) return
      open(newunit=unit, file='fpm.toml', status='old', action='read')
      do
         read(unit, '(a)') line
         if (index(line, 'version = ') == 1) exit
      end do
      close(unit)
      call check(error, trim(line), 'version = "' // furiko_version // '"')
   end subroutine test_help


   !> A bad command line: code 2, one line that names the word, nothing on standard output
   subroutine test_refusals(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: commands(*) = [character(len=40) :: &
         'nosuch', '--nosuch', 'table nosuch', 'table table', 'table --nosuch 3', 'table -x', &
         '--from', '--from=', '--to --step', '--format', '--format xml', '--format TEXT', &
         '--from abc', "--from ''", "--from ' 1'", '--from 1,5', '--from 1e', '--from e1', &
         '--from 1..5', '--from .', '--from +-1', '--from 1e+-1', '--from 1f0', '--from 2*3', &
         '--from NaN', '--from inf', '--from 1e300', '--from 1e99999999999', '--from 0x10', &
         '--from 0.0000000000000001', '--from -1', '--to 180', '--to 180.0', '--to 999', '--to -0.5', &
         '--from 20 --to 10', '--from 179.5', '--step 0', '--step 0.0', '--step -1', '--step 1x']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(commands)
         call run_program(trim(commands(i)), output, errors, code)
         call check(error, code, 2, 'code of: ' // trim(commands(i)))
         if (allocated(error)) return
         call check(error, output, '', 'output of: ' // trim(commands(i)))
         if (allocated(error)) return
         call check(error, line_count(errors) == 1 .and. index(errors, 'furiko') == 1, &
            'message of: ' // trim(commands(i)))
         if (allocated(error)) return
      end do
      call run_program('--to 180', output, errors, code)
      call check(error, index(errors, '--to 180 is outside') > 0 .and. index(errors, 'infinite') > 0)
   end subroutine test_refusals


   !> Every refusal and some of each answer, to the byte
   subroutine test_session(error)
      type(error_type), allocatable, intent(out) :: error

      call check_session(error, 'test/data/session.txt')
   end subroutine test_session


   !> Numbers as people type them: what mpmath says, to the last digit
   subroutine test_commands(error)
      type(error_type), allocatable, intent(out) :: error

      call check_session(error, 'test/data/session-commands.txt')
   end subroutine test_commands


   subroutine test_digits_session(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_program('digits', output, errors, code)
      if (index(errors, 'real128') > 0) then
         call skip_test(error, 'this compiler has no real128')
         return
      end if
      call check_session(error, 'test/data/session-digits.txt')
   end subroutine test_digits_session


   !> The commands of a file answer what stands below them.
   subroutine check_session(error, file)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: file
      character(len=:), allocatable :: errors, expected, output
      character(len=12) :: number
      integer :: code, i, line

      call run_shell('session=' // file // '; . test/data/session.sh', output, errors, code)
      expected = contents(file)
      if (output == expected .and. errors == '') return
      line = 1
      do i = 1, min(len(output), len(expected))
         if (output(i:i) /= expected(i:i)) exit
         if (output(i:i) == nl) line = line + 1
      end do
      write(number, '(i0)') line
      call check(error, .false., file // ' line ' // trim(number) // ': ' // &
         output(i:min(len(output), i + 99)) // errors)
   end subroutine check_session


   !> A full device, a closed output, a reader that leaves: an error code, one line, no backtrace
   subroutine test_output_failure(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: commands(*) = [character(len=40) :: &
         '>/dev/full', '--version >/dev/full', '--step 0.001 >/dev/full', '--help >&-', '>&-']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(commands)
         call run_program(trim(commands(i)), output, errors, code)
         call check(error, code, 1, 'code of: ' // trim(commands(i)))
         if (allocated(error)) return
         call check(error, line_count(errors) == 1 .and. index(errors, 'furiko: cannot write') == 1, &
            'message of: ' // trim(commands(i)))
         if (allocated(error)) return
      end do
      call run_shell('{ furiko --step 0.0001 && echo fine >&2; } | head -n 1', output, errors, code)
      call check(error, line_count(output) == 1 .and. index(errors, 'fine') == 0 &
         .and. line_count(errors) <= 1, 'a reader that leaves')
   end subroutine test_output_failure

end module test_cli
