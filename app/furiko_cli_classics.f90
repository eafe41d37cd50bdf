! SPDX-License-Identifier: MIT

!> `furiko converge` and `furiko perimeter`: the notes' own ways, and the ellipse.
module furiko_cli_classics
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : agm_steps_k, ellipk_k, ellipk_series_k, ellipk_trapezoid_k, ellipse_perimeter, &
      ellipse_perimeter_series
   use furiko_cli_arguments, only : argument_reader, value_of
   use furiko_cli_quantity, only : integer_of, metres, number_of, pure_number
   use furiko_cli_sheet, only : begin_sheet, sheet
   use furiko_cli_terminal, only : finish, put, refuse
   implicit none
   private
   public :: converge_command, perimeter_command


   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: converge_help = &
      'furiko converge [--k K] [--steps N] [--format F]' // nl // nl // &
      'K(k) by three ways side by side: the first n terms of its power series, the trapezoidal rule' // &
      nl // 'with n intervals, n steps of the arithmetic-geometric mean. For n = 1 to N each has its' // &
      nl // 'value, its relative error and how many digits are right (16: all of them).' // nl // nl // &
      '  --k K          modulus, -1 < K < 1, as 0.5 or 1/2 (1/2)' // nl // &
      '  --steps N      last n (8)' // nl // &
      '  --format F     text, csv or json (text)' // nl // nl // &
      'Example:' // nl // nl // &
      '  furiko converge --k 1/2 --steps 8'
   character(len=*), parameter :: perimeter_help = &
      'furiko perimeter A B [--terms N] [--format F]' // nl // nl // &
      'The perimeter of an ellipse with semiaxes A and B, in their unit (metres if they have one).' // &
      nl // nl // &
      '  --terms N      a further column: by the first N terms of its series' // nl // &
      '  --format F     text, csv or json (text)' // nl // nl // &
      'Example:' // nl // nl // &
      '  furiko perimeter 2 1'


contains


   subroutine converge_command(arguments)
      type(argument_reader), intent(inout) :: arguments
      character(len=*), parameter :: command = 'furiko converge'
      character(len=:), allocatable :: form, word
      real(wp) :: k
      integer :: steps

      form = 'text'
      k = 0.5_wp
      steps = 8
      do while (.not. arguments%done())
         word = arguments%word()
         call arguments%advance()
         select case (word)
         case ('-h', '--help')
            call put(converge_help)
            call finish()
            return
         case ('--format')
            form = value_of(command, word, arguments)
         case ('--k')
            word = value_of(command, word, arguments)
            k = number_of(command // ': --k', word, pure_number(:0))
            if (.not. abs(k) < 1.0_wp) call refuse(command // ': --k ' // word // ' is outside -1 < k < 1')
         case ('--steps')
            steps = integer_of(command // ': ' // word, value_of(command, word, arguments), 1, 10000)
         case default
            call refuse(command // ": unknown word '" // word // "'; see furiko converge --help")
         end select
      end do
      call print_convergence(command, k, steps, form)
   end subroutine converge_command


   subroutine print_convergence(command, k, steps, form)
      character(len=*), intent(in) :: command
      real(wp), intent(in) :: k
      integer, intent(in) :: steps
      character(len=*), intent(in) :: form
      type(sheet) :: page
      real(wp), dimension(0:steps) :: a, b, c, mean, e
      real(wp) :: exact, values(3)
      integer :: i, n

      exact = ellipk_k(k)
      call agm_steps_k(k, a, b, c, mean, e)
      page = begin_sheet(command, form, [character(len=16) :: 'n', 'series', 'series_error', &
         'series_digits', 'trapezoid', 'trapezoid_error', 'trapezoid_digits', 'agm', 'agm_error', &
         'agm_digits'], [character(len=8) :: 'i5', ('f18.15', 'es15.1', 'i17   ', i=1, 3)])
      do n = 1, steps
         values = [ellipk_series_k(k, n), ellipk_trapezoid_k(k, n), mean(n)]
         call page%row([real(n, wp), (values(i), values(i)/exact - 1, &
            digits_of(values(i)/exact - 1), i=1, 3)])
      end do
      call page%end()
      call finish()
   end subroutine print_convergence


   !> How many decimal digits an error leaves, at most 16
   elemental function digits_of(error)
      real(wp), intent(in) :: error
      real(wp) :: digits_of

      digits_of = aint(min(16.0_wp, -log10(max(abs(error), tiny(error)))))
   end function digits_of


   subroutine perimeter_command(arguments)
      type(argument_reader), intent(inout) :: arguments
      character(len=*), parameter :: command = 'furiko perimeter'
      type(sheet) :: page
      character(len=:), allocatable :: form, word
      character(len=16) :: columns(2)
      real(wp) :: axes(2), row(2)
      integer :: given, i, terms

      form = 'text'
      terms = 0
      given = 0
      do while (.not. arguments%done())
         word = arguments%word()
         call arguments%advance()
         select case (word)
         case ('-h', '--help')
            call put(perimeter_help)
            call finish()
            return
         case ('--format')
            form = value_of(command, word, arguments)
         case ('--terms')
            terms = integer_of(command // ': ' // word, value_of(command, word, arguments), 1, 1000000)
         case default
            given = given + 1
            if (given > 2) call refuse(command // ": unknown word '" // word // "'; two semiaxes are enough")
            axes(given) = number_of(command // ': the semiaxis', word, metres)
            if (axes(given) < 0.0_wp) call refuse(command // ': the semiaxis ' // word // ' is below 0')
         end select
      end do
      if (given < 2) call refuse(command // ': name two semiaxes, as furiko perimeter 2 1')

      row = [ellipse_perimeter(axes(1), axes(2)), ellipse_perimeter_series(axes(1), axes(2), terms)]
      terms = merge(2, 1, terms > 0)
      columns = [character(len=16) :: 'perimeter', 'series']
      page = begin_sheet(command, form, columns(:terms), [('g26.16e3', i=1, terms)])
      call page%row(row(:terms))
      call page%end()
      call finish()
   end subroutine perimeter_command

end module furiko_cli_classics
