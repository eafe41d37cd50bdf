! SPDX-License-Identifier: MIT

!> `furiko animate`: the page and the state it begins in, films, and a file that is whole or untouched.
!> What the page does in a browser is tested by .ci/browser.
module test_animate
   use test_program, only : line_count, run_inside, run_program, run_shell, test_folder
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
         new_unittest('the-state', test_state), &
         new_unittest('a-film', test_film), &
         new_unittest('a-film-that-fails', test_failing_film), &
         new_unittest('a-file-is-replaced', test_replaced), &
         new_unittest('refusals', test_refusals), &
         new_unittest('a-full-disk', test_full)]
   end subroutine collect_animate


   !> Byte for byte what stands in app/page, its parts in their places
   subroutine test_page(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_shell("awk '/^@.*@$/ && !/@begin@/ {gsub(""@"", """"); while ((getline line < " // &
         "(""app/page/"" $0)) > 0) " // &
         "print line; next} {print}' app/page/pendulum.html >" // test_folder() // &
         '/page; furiko animate -o - | ' // &
         "sed 's/^{""version"": .*/@begin@/' | cmp - " // test_folder() // '/page', output, errors, code)
      call check(error, code == 0 .and. output == '' .and. errors == '', output // errors)
   end subroutine test_page


   !> The options are in the page as its address would have them; angles in degrees.
   subroutine test_state(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: options(*) = [character(len=80) :: '', &
         '--release -30.5 --compare 1rad', &
         '--amplitude 179.9 --compare driven --linear 0.1 --drive 3 --drive-frequency 1.5', &
         '--angle 30 --rate=-6.5 --length 50cm --gravity 1.62', '--at 2min --language ja --compare small', &
         '--angle 10']
      character(len=*), parameter :: states(*) = [character(len=80) :: '#', &
         '#release=-30.5&compare=57.29577951308232', &
         '#amplitude=179.9&compare=driven&linear=0.1&drive=3&drive-frequency=1.5', &
         '#angle=30&rate=-6.5&length=0.5&gravity=1.62', '#compare=small&time=120&language=ja', &
         '#angle=10&rate=0']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(options)
         call run_shell('furiko animate -o - ' // trim(options(i)) // &
            ' | grep -c ''^{"version": "[0-9.]*", ' // &
            '"state": "' // trim(states(i)) // '"}$''', output, errors, code)
         call check(error, output == '1' // nl .and. errors == '', trim(options(i)) // ': ' // output // &
            errors)
         if (allocated(error)) return
      end do
   end subroutine test_state


   !> What gnuplot and ffmpeg are told, by two programs in their place that pass it on: 25 frames a second
   !> of one period, or of as many as bring the other motion back
   subroutine test_film(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: frames = " | grep -c '^[-0-9.]* [-0-9.]* [-0-9.]* [-0-9.]* $'; "
      character(len=*), parameter :: first = "sed -n '/END/{n;p;q}' "
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_inside(programs('cat', 'cat') // &
         'furiko animate --gif a --release 90; furiko animate --mp4 b --release 90; ' // &
         'cmp a b; cat a' // frames // first // 'a; furiko animate --gif c --angle 0 --rate 7 ' // &
         '--compare small; cat c' // &
         frames // 'furiko animate --mp4 d --amplitude 60 --compare 120; ' // first // 'd', output, &
         errors, code)
      call check(error, code == 0 .and. errors == '' .and. output == '59' // nl // &
         '1.000000 -0.000000 1.000000 -0.000000 ' // nl // '452' // nl // &
         '0.000000 -1.000000 0.000000 -1.000000 ' // nl // &
         'a' // nl // 'b' // nl // 'bin' // nl // 'c' // nl // 'd' // nl, output // errors)
   end subroutine test_film


   !> One line and no half film where a program is missing or fails, or where there is no loop
   subroutine test_failing_film(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: bad(*) = [character(len=24) :: '--compare driven', '--release 180', &
         '--at 1', &
         '--language ja', '--length 1e6', '-o b', '--angle 180 --rate 0']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      call run_inside(programs('cat', 'cat') // &
         'echo old >a; rm bin/ffmpeg; (PATH=$PWD/bin; furiko animate --gif a; ' // &
         'echo $?); cat a', output, errors, code)
      call check(error, output == '3' // nl // 'old' // nl // 'a' // nl // 'bin' // nl .and. &
         line_count(errors) == 1 .and. &
         index(errors, 'furiko animate: no ffmpeg here (apt-get install ffmpeg)') == 1, 'no ffmpeg: ' // &
         output // errors)
      if (allocated(error)) return
      call run_inside(programs('cat', 'echo broken >&2; exit 1') // &
         'echo old >a; furiko animate --gif a; echo $?; ' // &
         'cat a', output, errors, code)
      call check(error, output == '1' // nl // 'old' // nl // 'a' // nl // 'bin' // nl .and. &
         errors == 'furiko animate: ffmpeg made no film: broken' // nl, 'ffmpeg fails: ' // output // errors)
      if (allocated(error)) return
      call run_inside(programs('cat', 'exit 0') // 'furiko animate --mp4 a; echo $?', output, errors, code)
      call check(error, output == '1' // nl // 'bin' // nl .and. line_count(errors) == 1, &
         'an empty film: ' // errors)
      if (allocated(error)) return
      call run_inside(programs('exit 2', 'cat') // 'furiko animate --mp4 a; echo $?', output, errors, code)
      call check(error, output == '1' // nl // 'bin' // nl .and. line_count(errors) == 1, &
         'gnuplot fails: ' // errors)
      if (allocated(error)) return
      do i = 1, size(bad)
         call run_program('animate --gif a ' // trim(bad(i)), output, errors, code)
         call check(error, code == 2 .and. output == '' .and. line_count(errors) == 1, bad(i) // errors)
         if (allocated(error)) return
      end do
   end subroutine test_failing_film


   !> Shell commands that put programs in the place of gnuplot and of ffmpeg, which is asked for its
   !> version, too
   pure function programs(gnuplot, ffmpeg) result(commands)
      character(len=*), intent(in) :: gnuplot
      character(len=*), intent(in) :: ffmpeg
      character(len=:), allocatable :: commands

      commands = 'mkdir bin; (echo "#!/bin/sh"; echo ''' // gnuplot // &
         ''') >bin/gnuplot; (echo "#!/bin/sh"; ' // &
         'echo ''[ "$1" != -version ] || exec echo 1''; echo ''' // ffmpeg // ''') >bin/ffmpeg; ' // &
         'chmod +x bin/gnuplot bin/ffmpeg; PATH=$PWD/bin:$PATH; '
   end function programs


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
      character(len=*), parameter :: bad(*) = [character(len=48) :: '', '-o', '--output=', '-x', 'page', &
         '-o a --linear 1', '-o a --compare 180', '-o a --compare=', '-o a --compare nosuch', &
         '-o a --language fr', &
         '-o a --release 181', '-o a --angle 181', '-o a --angle 1 --rate 101', '-o a --length 1mm', &
         '-o a --at=-1', &
         '-o a --gravity 31', '-o a --compare driven --drive 51', '-o a --gif b', '--gif=', '-o a --rate 1']
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
