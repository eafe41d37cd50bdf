! SPDX-License-Identifier: MIT

!> The note's table, every digit of it, against 40 digits.
module test_table
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : period_ratio
   use test_program, only : run_program
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   public :: collect_table


   character(len=*), parameter :: nl = new_line('a')


contains


   subroutine collect_table(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('all-180-rows', test_rows), &
         new_unittest('digits-the-note-has-wrong', test_misprints), &
         new_unittest('period-ratio-in-radians', test_radians)]
   end subroutine collect_table


   !> The whole output, byte for byte, in the note's format '%2d %20.15f'
   subroutine test_rows(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: expected, errors, output
      character(len=42) :: digits(0:179)
      character(len=24) :: row
      integer :: code, degrees

      digits = reference_digits()
      expected = ''
      do degrees = 0, 179
         write(row, '(i0.1)') degrees
         if (degrees < 10) row = ' ' // row
         expected = expected // trim(row) // '    ' // to_15_decimals(digits(degrees)) // nl
      end do
      call run_program('', output, errors, code)
      call check(error, code, 0)
      if (allocated(error)) return
      call check(error, errors, '')
      if (allocated(error)) return
      call check(error, output == expected .and. len(output) == len(expected), 'the table differs')
   end subroutine test_rows


   !> Rows 60, 170 and 179 of the published table are wrong: 1 - k*k loses digits next to 180
   subroutine test_misprints(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_program('table --from 60 --to 60', output, errors, code)
      call check(error, output, '60    1.073182007149364' // nl, 'the note has ...365')
      if (allocated(error)) return
      call run_program('table --from 170 --to 170', output, errors, code)
      call check(error, output, '170    2.439362719673884' // nl, 'the note has ...885')
      if (allocated(error)) return
      call run_program('table --from 179 --to 179', output, errors, code)
      call check(error, output, '179    3.901065160389086' // nl, 'the note has ...9150')
   end subroutine test_misprints


   !> The library's period ratio, 3 ulp and what the rounding of the angle to radians does: its
   !> error of half an ulp counts tan(theta0/2)/2 dK/dtheta0-fold, 60 times at 179 degrees
   subroutine test_radians(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: pi = acos(-1.0_wp)
      character(len=42) :: digits(0:179)
      real(wp) :: reference(0:179), ratio(0:179)
      integer :: degrees

      digits = reference_digits()
      read(digits, *) reference
      ratio = period_ratio([(degrees*pi/180, degrees=0, 179)])
      call check(error, all(abs(ratio - reference)/spacing(reference) &
         <= [(3 + tan(degrees*pi/360)/2, degrees=0, 179)]))
   end subroutine test_radians


   !> The 41 digits of each row of test/data/table.dat
   function reference_digits() result(digits)
      character(len=42) :: digits(0:179)
      integer :: degrees, row, unit

      open(newunit=unit, file='test/data/table.dat', status='old', action='read')
      read(unit, *)
      do degrees = 0, 179
         read(unit, *) row, digits(row)
      end do
      close(unit)
   end function reference_digits


   !> d.ddd... rounded to 15 decimals, in decimal
   pure function to_15_decimals(text) result(rounded)
      character(len=*), intent(in) :: text
      character(len=17) :: rounded
      character(len=16) :: leading
      integer(int64) :: units

      leading = text(:1) // text(3:17)
      read(leading, '(i16)') units
      if (text(18:18) >= '5') units = units + 1
      write(rounded, '(i1, a, i15.15)') units/10_int64**15, '.', mod(units, 10_int64**15)
   end function to_15_decimals

end module test_table
