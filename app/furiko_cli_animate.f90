! SPDX-License-Identifier: MIT

!> `furiko animate`: the pendulum in motion, as one page for any browser.
module furiko_cli_animate
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : furiko_version, nome_m, nome_mc
   use furiko_cli_arguments, only : argument_reader, value_of
   use furiko_cli_decimal, only : decimal, to_double_word
   use furiko_cli_output, only : open_output, output
   use furiko_cli_terminal, only : finish, put, refuse
   use furiko_double_word, only : double_word, double_word_pi, sin, operator(*), operator(/)
   use furiko_period_degrees, only : period_ratio_degrees
   implicit none
   private
   public :: animate_command


   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: help = &
      'furiko animate -o FILE' // nl // nl // &
      'The pendulum in motion: one page that any browser opens from disk, without a network. It' // &
      nl // 'shows the exact pendulum beside the small-angle one, or beside another exact one, with' // &
      nl // 'traces, phase portrait and period ratio, for amplitudes from 0 to 179.9 degrees.' // nl // &
      nl // '  -o FILE      the page to write, - for standard output; a file of that name is' // nl // &
      '  --output     replaced once the new one is whole' // nl // nl // &
      'Example:' // nl // nl // &
      '  furiko animate -o pendulum.html'


contains


   !> Parse the words that follow `animate`, then write the page.
   subroutine animate_command(arguments)
      type(argument_reader), intent(inout) :: arguments
      type(output) :: page
      character(len=:), allocatable :: file, option

      file = ''
      do while (.not. arguments%done())
         option = arguments%word()
         call arguments%advance()
         select case (option)
         case ('-h', '--help')
            call put(help)
            call finish()
            return
         case ('-o', '--output')
            file = value_of('furiko animate', option, arguments)
         case default
            call refuse("furiko animate: unknown word '" // option // "'; see furiko animate --help")
         end select
      end do
      if (file == '') call refuse('furiko animate: name the page to write, as in -o pendulum.html')
      page = open_output(file)
      call put_page(page)
      call page%close()
   end subroutine animate_command


   !> What the page knows of each amplitude it offers, in JSON.
   subroutine put_table(page)
      type(output), intent(inout) :: page
      integer, parameter :: last = 1799
      integer :: tenths

      call page%put('{"version": "' // furiko_version // '", "rows": [')
      do tenths = 0, last
         call page%put(row(tenths) // trim(merge(',', ' ', tenths < last)))
      end do
      call page%put(']}')
   end subroutine put_table


   !> T/T_h and the nome for an amplitude in tenths of a degree, to 17 digits.
   pure function row(tenths)
      integer, intent(in) :: tenths
      character(len=:), allocatable :: row
      character(len=60) :: buffer
      type(double_word) :: ratio

      ratio = period_ratio_degrees(degrees(tenths))
      write(buffer, '("[", f18.16, ",", es22.16e2, "]")') ratio%hi, nome(tenths)
      row = trim(buffer)
   end function row


   !> The library's nome of k = sin(amplitude/2), from m or 1 - m, whichever is the smaller
   pure function nome(tenths) result(q)
      integer, intent(in) :: tenths
      real(wp) :: q
      type(double_word) :: sine

      sine = sin(degrees(min(tenths, 1800 - tenths))*double_word_pi/double_word(360.0_wp))
      sine = sine*sine
      if (tenths <= 900) then
         q = nome_m(sine%hi)
      else
         q = nome_mc(sine%hi)
      end if
   end function nome


   pure function degrees(tenths)
      integer, intent(in) :: tenths
      type(double_word) :: degrees

      degrees = to_double_word(decimal(int(tenths, int64), 1))
   end function degrees


   include 'furiko_cli_page.inc'

end module furiko_cli_animate
! rooms: 3224500294
