! SPDX-License-Identifier: MIT

!> `furiko animate`: the page's data, and a file that is whole or untouched. What the page does in a
!> browser is tested by .ci/browser.
module test_animate
   use test_program, only : line_count, run_program, run_shell, test_folder
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   public :: collect_animate


   character(len=*), parameter :: nl = new_line('a')


contains


   subroutine collect_animate(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('the-page', test_page), &
         new_unittest('a-file-is-replaced', test_replaced), &
         new_unittest('refusals', test_refusals), &
         new_unittest('a-full-disk', test_full)]
   end subroutine collect_animate


   !> The template with the table in its place; period ratio and nome are mpmath's, rounded to 17 digits
   subroutine test_page(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_shell("furiko animate -o - | sed '/^{""version""/,/^\]}/c\@table@' | " // &
         'cmp - app/page/pendulum.html', output, errors, code)
      call check(error, code == 0 .and. output == '' .and. errors == '', output // errors)
      if (allocated(error)) return
      call run_shell("furiko animate -o - | grep '^\[[0-9]' | sed -n '1p; 901p; 1800p; $='", output, &
         errors, code)
      call check(error, output, '[1.0000000000000000,0.0000000000000000E+00],' // nl // &
         '[1.1803405990160962,4.3213918263772251E-02],' // nl // &
         '[5.3668671090259465,5.5690078227721240E-01]' // nl // '1800' // nl)
   end subroutine test_page


   !> A new file, one in an old one's place, a pipe and a device
   subroutine test_replaced(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_shell('cd ' // test_folder() // ' && rm -rf animate && mkdir animate && cd animate && ' // &
         'furiko() { ../../app/furiko "$@"; }; ' // &
         'furiko animate -o - >page && furiko animate --output=a && cmp a page && ' // &
         'echo old >b && furiko animate -o b && cmp b page && ' // &
         'furiko animate -o /dev/stdout | cmp - page && furiko animate -o /dev/null && ' // &
         'test -c /dev/null && echo *', output, errors, code)
      call check(error, code == 0 .and. output == 'a b page' // nl .and. errors == '', output // errors)
   end subroutine test_replaced


   subroutine test_refusals(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: bad(*) = [character(len=16) :: '', '-o', '--output=', '-x', 'page']
      character(len=*), parameter :: unwritable(*) = [character(len=16) :: '/nosuch/page', '/', &
         'fpm.toml/page']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(bad)
         call run_program('animate ' // trim(bad(i)), output, errors, code)
         call check(error, code == 2 .and. output == '' .and. line_count(errors) == 1, bad(i))
         if (allocated(error)) return
      end do
      do i = 1, size(unwritable)
         call run_program('animate -o ' // trim(unwritable(i)), output, errors, code)
         call check(error, code == 1 .and. output == '' .and. line_count(errors) == 1 .and. &
            index(errors, 'furiko: cannot write ' // trim(unwritable(i)) // ':') == 1, errors)
         if (allocated(error)) return
      end do
   end subroutine test_refusals


   !> A device that is full
   subroutine test_full(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_program('animate -o /dev/full', output, errors, code)
      call check(error, code == 1 .and. output == '' .and. line_count(errors) == 1 .and. &
         index(errors, 'furiko: cannot write /dev/full: ') == 1, errors)
   end subroutine test_full

end module test_animate
