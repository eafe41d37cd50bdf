! SPDX-License-Identifier: MIT

!> What becomes of files, the user's and those at work: whole or as they were, where links lead, with
!> the mode they had; and nothing left when the program is ended.
module test_files
   use test_program, only : line_count, run_inside, run_shell
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   public :: collect_files


   character(len=*), parameter :: nl = new_line('a')


contains


   subroutine collect_files(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('links', test_links), &
         new_unittest('modes', test_modes), &
         new_unittest('lengths', test_lengths), &
         new_unittest('pipes-and-open-files', test_pipes), &
         new_unittest('refusals', test_refusals), &
         new_unittest('no-room', test_no_room), &
         new_unittest('several-at-once', test_several), &
         new_unittest('strange-names', test_names), &
         new_unittest('what-nobody-asked-for', test_unasked), &
         new_unittest('temporary-folders', test_temporary), &
         new_unittest('gnuplot-that-hangs', test_hanging), &
         new_unittest('progress', test_progress)]
   end subroutine collect_files


   !> A link, a link to a link in another folder, a link to a file to come; both names of one file
   subroutine test_links(error)
      type(error_type), allocatable, intent(out) :: error

      call expect(error, 'mkdir there; echo old >there/a; ln -s there/a b; ln -s ../b there/c; ' // &
         'furiko animate -o there/c; cmp there/a ../page; readlink b there/c; ' // &
         'ln -s there/d e; ln -s e f; furiko animate -o f; cmp there/d ../page; readlink e f; ' // &
         'echo old >g; ln g h; furiko animate -o h; cmp g ../page; test g -ef h', &
         'there/a ../b there/d e b e f g h there')
   end subroutine test_links


   !> A file keeps its mode, a new one has what umask leaves
   subroutine test_modes(error)
      type(error_type), allocatable, intent(out) :: error

      call expect(error, 'for mode in 600 666 755; do echo old >$mode; chmod $mode $mode; ' // &
         'furiko animate -o $mode; done; umask 027; furiko animate -o new; ls -l | cut -c 1-10 | sed 1d', &
         '-rw------- -rw-rw-rw- -rwxr-xr-x -rw-r----- 600 666 755 new')
   end subroutine test_modes


   !> In the place of a longer file, of an empty one, of one that may not be read
   subroutine test_lengths(error)
      type(error_type), allocatable, intent(out) :: error

      call expect(error, 'head -c 300000 /dev/zero >long; >empty; head -c 300000 /dev/zero >secret; ' // &
         'chmod 200 secret; for file in long empty secret; do furiko animate -o $file; ' // &
         'chmod 600 $file; cmp $file ../page; done', 'empty long secret')
   end subroutine test_lengths


   !> A pipe with a name stays one, and who reads it has all; what is open goes on where it ends
   subroutine test_pipes(error)
      type(error_type), allocatable, intent(out) :: error

      call expect(error, 'mkfifo a; cmp a ../page & furiko animate -o a; wait $! && test -p a; ' // &
         'for out in /dev/stdout /dev/fd/1; do (echo one; furiko animate -o $out; echo two) >b; ' // &
         'sed "1d; \$d" b | cmp - ../page; sed -n "1p; \$p" b; done; ' // &
         'echo one >c; furiko animate -o /dev/fd/3 3>>c; sed 1d c | cmp - ../page; ' // &
         ! A reader that has had enough, and does not go
         'exec 8<>a; timeout -s KILL 20 "$program" animate -o a & head -c 1 <&8; kill $!; ' // &
         '{ wait $!; } 2>../said; echo " $?"', 'one two one two < 143 a b c')
   end subroutine test_pipes


   !> Code 1, a line with the file and the reason, and before any work
   subroutine test_refusals(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: files(*) = [character(len=9) :: 'folder', 'folder/', '.', 'file/', &
         'file/x', 'no/', 'no/x', 'nowhere', 'circle', 'protected']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(files)
         call run_inside('mkdir folder; echo old >file; ln -s no/x nowhere; ln -s circle circle; ' // &
            'echo old >protected; chmod 444 protected; furiko animate -o ' // trim(files(i)), &
            output, errors, code)
         ! root may write anything
         if (files(i) == 'protected' .and. code == 0) cycle
         call check(error, code == 1 .and. line_count(errors) == 1 .and. index(errors, &
            'furiko: cannot write ' // trim(files(i)) // ': ') == 1, trim(files(i)) // ': ' // errors)
         if (allocated(error)) return
      end do
      call run_inside(gnuplot('echo drawing >&2') // 'mkdir a.svg; ln -s no/x b.svg; ' // &
         'for name in a b no/c; do furiko plot phase -o $name.svg; done', output, errors, code)
      call check(error, line_count(errors) == 3 .and. index(errors, 'drawing') == 0, errors)
   end subroutine test_refusals


   !> Files as they were where there is no room: a limit stands for the full disk
   subroutine test_no_room(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_inside('echo old >old; (ulimit -f 16; furiko animate -o old; furiko animate -o new; ' // &
         'furiko animate -o - >out); code=$?; rm out; cat old; (exit $code)', output, errors, code)
      call check(error, code == 1 .and. output == 'old' // nl // 'old' // nl, output // errors)
      if (allocated(error)) return
      call check(error, line_count(errors) == 3 .and. index(errors, 'furiko: cannot write old: ') == 1 .and. &
         index(errors, nl // 'furiko: cannot write new: ') > 0 .and. &
         index(errors, nl // 'furiko: cannot write the output: ') > 0, errors)
   end subroutine test_no_room


   !> On one name, new or old, all succeed, and the file is whole
   subroutine test_several(error)
      type(error_type), allocatable, intent(out) :: error

      call expect(error, 'for round in new old; do for i in 1 2 3 4; do ' // &
         'furiko animate -o a || echo failed & done; wait; cmp a ../page; done', 'a')
   end subroutine test_several


   !> Names are names, up to the longest there is
   subroutine test_names(error)
      type(error_type), allocatable, intent(out) :: error

      call expect(error, 'for name in -x "- " "~" "a b" "$(printf "a\nb")" "$(printf %0255d 0)"; do ' // &
         'furiko animate -o "$name"; cmp "./$name" ../page && rm "./$name"; done', '')
   end subroutine test_names


   !> Without gnuplot neither a file nor a link that leads nowhere is replaced, unless that is asked for
   subroutine test_unasked(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: start = 'echo old >x.csv; ln -s no y.gp; path_of_all=$PATH PATH=; '
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_inside(start // 'furiko plot period -o x.svg; furiko plot period -o y.svg; ' // &
         'PATH=$path_of_all; cat x.csv', output, errors, code)
      call check(error, output == 'old' // nl // 'x.csv' // nl // 'y.gp' // nl .and. &
         line_count(errors) == 2 .and. index(errors, '--data replaces them') > 0, output // errors)
      if (allocated(error)) return
      call run_inside(start // 'furiko plot period -o x.svg --data; furiko plot period -o y.svg --data; ' // &
         'PATH=$path_of_all; grep old x.csv; readlink y.gp', output, errors, code)
      call check(error, output == 'no' // nl // 'no' // nl // 'x.csv' // nl // 'x.gp' // nl // &
         'y.csv' // nl // 'y.gp' // nl .and. line_count(errors) == 2, output // errors)
   end subroutine test_unasked


   !> Where there is no TMPDIR, or none that can be written; nothing is left in one that can
   subroutine test_temporary(error)
      type(error_type), allocatable, intent(out) :: error

      call expect(error, gnuplot('echo "</svg>"') // 'mkdir temporary; ' // &
         'for TMPDIR in "" /no $PWD/temporary; do export TMPDIR; furiko plot phase -o x.svg; ' // &
         'cat x.svg; done; unset TMPDIR; furiko plot phase -o x.svg; ls temporary', &
         '</svg> </svg> </svg> bin temporary x.svg')
   end subroutine test_temporary


   !> A gnuplot that hangs, heeds no signal and has started others ends with the program: then nobody
   !> has its pipe open any more, and the pipe's reader is at the end.
   subroutine test_hanging(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      ! Under nohup, as tests may be run, HUP ends nothing.
      call run_shell("sh -c 'kill -HUP $$; echo ignored'", output, errors, code)
      call expect(error, gnuplot('trap "" HUP INT TERM; exec 9>pipe; sleep 60 & sleep 60; sleep 60') // &
         'mkfifo pipe; export TMPDIR=.; for name in ' // merge('    ', 'HUP ', output == 'ignored' // nl) // &
         'TERM KILL; do ' // &
         '"$program" plot phase -o x.svg --data & exec 8<pipe; kill -$name $!; ' // &
         '{ wait $!; } 2>../said; echo $?; timeout 20 cat <&8; echo $?; done', &
         repeat('129 0 ', merge(0, 1, output == 'ignored' // nl)) // '143 0 137 0 bin pipe')
   end subroutine test_hanging


   !> Where rows wait for their reader, a terminal is told how far they have come, and nothing is left
   !> of it; elsewhere nothing is said.
   subroutine test_progress(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: rows = 'rk4 --every 1 --periods 200 | (sleep 5; wc -l)'
      character(len=*), parameter :: margin = char(13)
      character(len=:), allocatable :: errors, output
      integer :: at, code

      call run_inside('furiko ' // rows, output, errors, code)
      call check(error, code == 0 .and. errors == '' .and. index(output, '2000') > 0, errors)
      if (allocated(error)) return
      call run_inside('command -v script || exit 1; export program; ' // &
         'script -qc ''"$program" ' // rows // ''' /dev/null', output, errors, code)
      if (code /= 0) call skip_test(error, 'no script, which makes a terminal')
      if (allocated(error)) return
      at = index(output, ' of 20001 rows (')
      call check(error, at > 0 .and. index(output(max(1, at):), '/s, ') > 0 .and. &
         index(output(max(1, at):), ' s left' // margin // '   ') > 0, output)
   end subroutine test_progress


   !> Shell text that puts a program in front of any other gnuplot
   pure function gnuplot(script)
      character(len=*), intent(in) :: script
      character(len=:), allocatable :: gnuplot

      gnuplot = 'mkdir bin; printf "#!/bin/sh\n%s\n" ''' // script // ''' >bin/gnuplot; ' // &
         'chmod +x bin/gnuplot; PATH=$PWD/bin:$PATH; '
   end function gnuplot


   !> Run a shell command in a new folder, with the page of `animate` in ../page: nothing may fail or
   !> complain, and what is printed, with what lies there then, are the words given.
   subroutine expect(error, command, words)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: command
      character(len=*), intent(in) :: words
      character(len=:), allocatable :: errors, output
      integer :: code, i

      call run_inside('furiko animate -o - >../page; ' // command, output, errors, code)
      do i = 1, len(output)
         if (output(i:i) == nl) output(i:i) = ' '
      end do
      call check(error, code == 0 .and. errors == '' .and. output == words, output // errors)
   end subroutine expect

end module test_files
