! SPDX-License-Identifier: MIT

!> Numbers and labels of figures as text, and the points that curves are made of.
module furiko_figure_text
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_cli_text, only : whole_text
   implicit none
   private
   public :: fixed, letters, plain, ramp, significant, to_text


   !> A number as gnuplot reads it
   interface to_text
      module procedure :: integer_to_text
      module procedure :: real_to_text
   end interface to_text


contains


   !> A label as text: without the marks of slanted, raised and lowered letters
   pure function plain(text) result(bare)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: bare
      integer :: i

      bare = ''
      do i = 1, len(text)
         if (scan(text(i:i), '<>{}_^') == 0) bare = bare // text(i:i)
      end do
   end function plain


   !> How many letters a label has: of UTF-8, what is not the first byte of a letter does not count
   pure function letters(label) result(number)
      character(len=*), intent(in) :: label
      integer :: number
      character(len=:), allocatable :: text
      integer :: i

      text = plain(label)
      number = count([(iachar(text(i:i)) < 128 .or. iachar(text(i:i)) > 191, i=1, len(text))])
   end function letters


   !> x with so many decimals: 0.300; 58 with none
   pure function fixed(x, decimals) result(text)
      real(wp), intent(in) :: x
      integer, intent(in) :: decimals
      character(len=:), allocatable :: text
      character(len=40) :: buffer, form

      write(form, '(a, i0, a)') '(f40.', decimals, ')'
      write(buffer, form) x
      text = trim(adjustl(buffer))
      if (decimals == 0) text = text(:len(text) - 1)
   end function fixed


   !> x > 0 with two significant digits: 0.30, 0.0048, 1.9·10^{−8}
   pure function significant(x) result(text)
      real(wp), intent(in) :: x
      character(len=:), allocatable :: text
      character(len=16) :: buffer
      integer :: power

      write(buffer, '(es10.1e3)') x
      read(buffer(index(buffer, 'E') + 1:), *) power
      if (power < -3) then
         text = trim(adjustl(buffer(:index(buffer, 'E') - 1))) // '·10^{−' // to_text(-power) // '}'
      else
         text = fixed(x, max(0, 1 - power))
      end if
   end function significant


   pure function integer_to_text(number) result(text)
      integer, intent(in) :: number
      character(len=:), allocatable :: text

      text = whole_text(number)
   end function integer_to_text


   !> Ten digits, of any magnitude
   pure function real_to_text(x) result(text)
      real(wp), intent(in) :: x
      character(len=:), allocatable :: text
      character(len=17) :: buffer

      write(buffer, '(es17.9e3)') x
      text = trim(adjustl(buffer))
   end function real_to_text


   !> n + 1 points from a to b.
   pure function ramp(a, b, n) result(x)
      real(wp), intent(in) :: a
      real(wp), intent(in) :: b
      integer, intent(in) :: n
      real(wp) :: x(n + 1)
      integer :: i

      x = [(a + (b - a)*i/n, i=0, n)]
   end function ramp

end module furiko_figure_text
