! SPDX-License-Identifier: MIT

!> `furiko animate`: the pendulum in motion, as one page for any browser.
module furiko_cli_animate
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : furiko_version, nome_m, nome_mc
   use furiko_cli_decimal, only : decimal, to_words
   use furiko_cli_files, only : open_output, output
   use furiko_cli_options, only : command, command_line, option, word
   use furiko_period_degrees, only : period_ratio_degrees
   use furiko_word_arithmetic_dp, only : words, pi_words, sin, operator(*), operator(/)
   implicit none
   private
   public :: animate_usage


contains


   function animate_usage() result(usage)
      type(command) :: usage

      usage = command('animate', 'the pendulum in motion, as a page for the browser', '-o FILE', 0, &
         'The pendulum in motion: one page that any browser opens from disk, without a network. It ' // &
         'shows the exact pendulum beside the small-angle one, or beside another exact one, with ' // &
         'traces, phase portrait and period ratio, for amplitudes from 0 to 179.9 degrees.', &
         example='furiko animate -o pendulum.html', options=[ &
         option('--output', 'FILE', '', 'the page to write, - for standard output; a file of that name ' // &
            'is replaced once the new one is whole', 'o')], run=animate_command)
   end function animate_usage


   subroutine animate_command(line)
      type(command_line), intent(in) :: line
      type(output) :: page
      type(word) :: file

      file = line%value('--output')
      if (file%text == '') call line%reject('name the page to write, as in -o pendulum.html')
      page = open_output(file%text)
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
      type(words) :: ratio

      ratio = period_ratio_degrees(degrees(tenths))
      write(buffer, '("[", f18.16, ",", es22.16e2, "]")') ratio%hi, nome(tenths)
      row = trim(buffer)
   end function row


   !> The library's nome of k = sin(amplitude/2), from m or 1 - m, whichever is the smaller
   pure function nome(tenths) result(q)
      integer, intent(in) :: tenths
      real(wp) :: q
      type(words) :: sine

      sine = sin(degrees(min(tenths, 1800 - tenths))*pi_words/360.0_wp)
      sine = sine*sine
      if (tenths <= 900) then
         q = nome_m(sine%hi)
      else
         q = nome_mc(sine%hi)
      end if
   end function nome


   pure function degrees(tenths)
      integer, intent(in) :: tenths
      type(words) :: degrees

      degrees = to_words(decimal(int(tenths, int64), 1))
   end function degrees


   include 'furiko_cli_page.inc'

end module furiko_cli_animate
! rooms: 474001326
