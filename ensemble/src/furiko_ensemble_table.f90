! SPDX-License-Identifier: MIT

!> A file's numbers as CSV, with the columns of `furiko driven SUBJECT --format csv`, chunk by chunk.
module furiko_ensemble_table
   use, intrinsic :: iso_c_binding, only : c_int
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : driven_pendulum, driven_state
   use furiko_cli_decimal, only : fixed
   use furiko_cli_number, only : scientific, significant
   use furiko_ensemble_file, only : ensemble_file, is_done, read_chunk
   use furiko_ensemble_sweep, only : chunks, constants, members_of, quantities, quantity, sweep, take_members
   use furiko_ensemble_system, only : output_write, reason
   use furiko_word_arithmetic_dp, only : words
   implicit none
   private
   public :: write_table


   !> How the numbers of a column are written, as in furiko_cli_sheet
   integer, parameter :: whole = 1, places = 2, powers = 3

   type :: column
      !> With its unit
      character(len=12) :: name
      !> The quantity of the file
      character(len=12) :: from
      integer :: style
      !> Decimal places, or digits
      integer :: count = 0
      !> The last number, as a text: many are the same as the one before
      real(wp) :: number = 0.0_wp
      character(len=:), allocatable :: text
   end type column

   !> Text that waits to be written
   type :: buffer
      character(len=2**16) :: text
      integer :: length = 0
      integer(c_int) :: failed = 0
   end type buffer


contains


   !> The chunks that are done
   subroutine write_table(file, asked, trouble)
      type(ensemble_file), intent(inout) :: file
      type(sweep), intent(in) :: asked
      character(len=:), allocatable, intent(out) :: trouble
      type(column), allocatable :: columns(:)
      type(quantity), allocatable :: results(:)
      type(buffer) :: output
      integer(int64) :: chunk

      trouble = ''
      columns = columns_of(asked)
      results = quantities(asked)
      call put_head(columns, output)
      do chunk = 0, chunks(asked) - 1
         if (.not. is_done(file, chunk)) cycle
         call read_chunk(file, asked, chunk, results, trouble)
         if (trouble /= '') exit
         call put_chunk(asked, chunk, results, columns, output)
         if (output%failed /= 0) exit
      end do
      if (output%failed == 0) call flush_buffer(output)
      if (output%failed /= 0) trouble = 'standard output: ' // reason(output%failed)
   end subroutine write_table


   function columns_of(asked) result(columns)
      type(sweep), intent(in) :: asked
      type(column), allocatable :: columns(:)
      type(column) :: state(2), value

      state = [column('angle_rad', 'angle', places, 15), column('rate', 'rate', places, 15)]
      value = column(constants(asked%vary), constants(asked%vary), places, 15)
      select case (asked%subject)
      case ('section')
         columns = [column('period', 'period', whole), state, column('turns', 'turns', whole)]
      case ('bifurcation')
         columns = [value, state]
      case ('lyapunov')
         columns = [value, column('exponent_1', 'exponent_1', places, 12), &
            column('exponent_2', 'exponent_2', places, 12), column('error_1', 'error_1', powers, 2)]
      case ('winding')
         columns = [value, column('winding', 'winding', places, 12), column('turns', 'turns', whole), &
            column('cycle', 'cycle', whole)]
      case default
         columns = [state, column('attractor', 'attractor', whole), column('arrival', 'arrival', whole)]
      end select
   end function columns_of


   subroutine put_head(columns, output)
      type(column), intent(in) :: columns(:)
      type(buffer), intent(inout) :: output
      integer :: i

      do i = 1, size(columns)
         call put(output, trim(columns(i)%name) // merge(new_line('a'), ',', i == size(columns)))
      end do
   end subroutine put_head


   !> The rows of a chunk: of each member one, or one for each period
   subroutine put_chunk(asked, chunk, results, columns, output)
      type(sweep), intent(in) :: asked
      integer(int64), intent(in) :: chunk
      type(quantity), intent(in) :: results(:)
      type(column), intent(inout) :: columns(:)
      type(buffer), intent(inout) :: output
      type(driven_pendulum), allocatable :: pendulum(:)
      type(driven_state), allocatable :: start(:)
      real(wp), allocatable :: values(:), numbers(:, :)
      integer :: i, j

      call take_members(asked, chunk, values, pendulum, start)
      allocate(numbers(maxval(results%rows), size(columns)))
      do i = 1, members_of(asked, chunk)
         do j = 1, size(columns)
            call take_column(asked, columns(j)%from, results, i, start(i), numbers(:, j))
         end do
         do j = 1, size(numbers, 1)
            call put_row(output, columns, numbers(j, :))
         end do
         if (output%failed /= 0) return
      end do
   end subroutine put_chunk


   !> A member's numbers of a column
   pure subroutine take_column(asked, from, results, member, start, numbers)
      type(sweep), intent(in) :: asked
      character(len=*), intent(in) :: from
      type(quantity), intent(in) :: results(:)
      integer, intent(in) :: member
      type(driven_state), intent(in) :: start
      real(wp), intent(out) :: numbers(:)
      integer :: i

      ! What is no result
      if (from == 'period') numbers = [(real(asked%transient, wp) + i, i=1, size(numbers))]
      if (from == 'angle') numbers = start%angle
      if (from == 'rate') numbers = start%rate
      do i = 1, size(results)
         if (results(i)%name /= from) cycle
         if (allocated(results(i)%wholes)) then
            numbers = real(results(i)%wholes(:, member), wp)
         else if (results(i)%each_period) then
            numbers = results(i)%reals(:, member)
         else
            numbers = results(i)%reals(1, member)
         end if
      end do
   end subroutine take_column


   subroutine put_row(output, columns, numbers)
      type(buffer), intent(inout) :: output
      type(column), intent(inout) :: columns(:)
      real(wp), intent(in) :: numbers(:)
      integer :: i

      do i = 1, size(columns)
         associate (one => columns(i))
            if (.not. allocated(one%text) .or. abs(numbers(i) - one%number) > 0.0_wp &
               .or. .not. abs(numbers(i)) <= huge(1.0_wp)) then
               one%number = numbers(i)
               one%text = written(numbers(i), one%style, one%count)
            end if
            call put(output, one%text)
            call put(output, merge(new_line('a'), ',', i == size(columns)))
         end associate
      end do
   end subroutine put_row


   !> As furiko_cli_sheet writes numbers in csv
   pure function written(x, style, count) result(text)
      real(wp), intent(in) :: x
      integer, intent(in) :: style
      integer, intent(in) :: count
      character(len=:), allocatable :: text
      integer, parameter :: most_digits = 15

      if (style == powers) then
         text = scientific(words(x), count)
      else if (abs(x) < 10.0_wp**(most_digits - count)) then
         text = fixed(words(x), count)
      else
         text = significant(words(x), most_digits)
      end if
   end function written


   subroutine put(output, text)
      type(buffer), intent(inout) :: output
      character(len=*), intent(in) :: text

      if (output%length + len(text) > len(output%text)) call flush_buffer(output)
      output%text(output%length + 1:output%length + len(text)) = text
      output%length = output%length + len(text)
   end subroutine put


   subroutine flush_buffer(output)
      type(buffer), intent(inout) :: output

      if (output%failed == 0) output%failed = output_write(output%text(:output%length))
      output%length = 0
   end subroutine flush_buffer
end module furiko_ensemble_table
