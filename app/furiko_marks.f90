! SPDX-License-Identifier: MIT

!> What gnuplot leaves out of its pictures: an SVG file's words and its colours on a dark page, a PNG file's
!> resolution. Where a picture is not as expected it stays as it is.
module furiko_marks
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_cli_text, only : replaced
   implicit none
   private
   public :: with_words, with_resolution


   character(len=*), parameter :: nl = new_line('a')
   !> Lightness is turned round, hues stay: white becomes #141414, and each pen keeps its contrast.
   character(len=*), parameter :: dark = '<style>@media (prefers-color-scheme: dark) ' // &
      '{ #gnuplot_canvas { filter: invert(0.92) hue-rotate(180deg); } }</style>'


contains


   !> An SVG file that tells a screen reader what it shows, and that is dark on a dark page.
   pure function with_words(svg, title, about) result(text)
      character(len=*), intent(in) :: svg
      character(len=*), intent(in) :: title
      character(len=*), intent(in) :: about
      character(len=:), allocatable :: text

      text = replaced(svg, '<title>Gnuplot</title>', '<title id="title">' // escaped(title) // '</title>')
      if (text == svg) return
      text = replaced(text, '<desc>', '<desc id="about">' // escaped(about) // ' ')
      text = replaced(text, '</desc>', '</desc>' // nl // dark)
      text = replaced(text, '<svg ', '<svg role="img" aria-labelledby="title about"')
   end function with_words


   pure function escaped(text)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: escaped

      escaped = replaced(replaced(replaced(text, '&', '&amp;'), '<', '&lt;'), '>', '&gt;')
   end function escaped


   !> A PNG file that says how large a pixel is, so that one of twice the pixels is not shown twice as large:
   !> the chunk pHYs behind the header's (PNG specification, 11.3.4.3)
   pure function with_resolution(png, pixels_per_inch) result(text)
      character(len=*), intent(in) :: png
      real(wp), intent(in) :: pixels_per_inch
      character(len=:), allocatable :: text
      !> The signature, then the header's length, name, 13 bytes and sum
      integer, parameter :: first = 8 + 4 + 4 + 13 + 4
      real(wp), parameter :: inches_per_metre = 1/0.0254_wp
      character(len=:), allocatable :: chunk, pixels

      text = png
      if (len(png) < first .or. index(png, 'pHYs') > 0) return
      pixels = big_endian(nint(pixels_per_inch*inches_per_metre, int64))
      chunk = 'pHYs' // pixels // pixels // achar(1)
      text = png(:first) // big_endian(9_int64) // chunk // big_endian(checksum(chunk)) // png(first + 1:)
   end function with_resolution


   pure function big_endian(number) result(bytes)
      integer(int64), intent(in) :: number
      character(len=4) :: bytes
      integer :: i

      do i = 1, 4
         bytes(i:i) = achar(ibits(number, 32 - 8*i, 8))
      end do
   end function big_endian


   !> CRC-32 (ISO 3309), bit by bit
   pure function checksum(bytes) result(sum)
      character(len=*), intent(in) :: bytes
      integer(int64) :: sum
      integer(int64), parameter :: ones = 4294967295_int64, polynomial = 3988292384_int64
      integer :: bit, i
      logical :: odd

      sum = ones
      do i = 1, len(bytes)
         sum = ieor(sum, int(iachar(bytes(i:i)), int64))
         do bit = 1, 8
            odd = btest(sum, 0)
            sum = ishft(sum, -1)
            if (odd) sum = ieor(sum, polynomial)
         end do
      end do
      sum = ieor(sum, ones)
   end function checksum

end module furiko_marks
