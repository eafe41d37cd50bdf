! SPDX-License-Identifier: MIT

!> `furiko plot`: pictures that are whole, of the size asked for, and that carry the data; or no
!> picture and one line. Where gnuplot is missing the tests that draw are skipped.
module test_plot
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use test_program, only : contents, line_count, run_inside, run_program, run_shell, work
   use furiko, only : rk4
   use furiko_pendulum_rates_dp, only : driven_pendulum_rates
   use testdrive, only : check, error_type, new_unittest, skip_test, test_failed, unittest_type
   implicit none
   private
   public :: collect_plot


   character(len=*), parameter :: figures(*) = [character(len=11) :: 'phase', 'motion', 'period', &
      'drift', 'converge', 'energy', 'accuracy', 'functions', 'integrals', 'surface', 'spectrum', 'flow', &
      'tension', 'driven', 'poincare']
   !> Figures that take a second or two by themselves, and a small table for each
   character(len=*), parameter :: sweeps(*) = [character(len=11) :: 'bifurcation', 'basins', 'staircase', &
      'exponents']
   character(len=*), parameter :: tables(*) = [character(len=96) :: &
      'bifurcation --vary drive --from 1 --to 1.1 --points 8 --transient 20 --periods 9', &
      'basins --drive 1.4 --grid 8 --transient 60', &
      'winding --damping 2 --drive 1.5 --frequency 1 --vary torque --from 0 --to 0.5 --points 9', &
      'lyapunov --vary drive --from 1 --to 1.1 --points 9 --transient 10 --periods 16']
   character(len=*), parameter :: nl = new_line('a')


   !> The points of one curve, from the data or from the picture
   type :: polyline
      real(wp), allocatable :: x(:)
      real(wp), allocatable :: y(:)
      !> The third number of a row, where there is one
      real(wp), allocatable :: z(:)
      !> Whether it has gaps
      logical :: broken = .false.
   end type polyline


contains


   subroutine collect_plot(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('list-and-help', test_list), &
         new_unittest('refusals', test_refusals), &
         new_unittest('places-that-cannot-be-written', test_places), &
         new_unittest('without-gnuplot', test_without_gnuplot), &
         new_unittest('gnuplot-that-fails', test_failing_gnuplot), &
         new_unittest('formats-and-sizes', test_formats), &
         new_unittest('strange-names-and-titles', test_strange_text), &
         new_unittest('names-that-gnuplot-would-run', test_names_of_commands), &
         new_unittest('titles-as-they-were-typed', test_titles), &
         new_unittest('titles-in-utf-8', test_utf8), &
         new_unittest('amplitudes', test_amplitudes), &
         new_unittest('data', test_data), &
         new_unittest('data-of-the-functions', test_function_data), &
         new_unittest('poincare-points-follow-each-other', test_section), &
         new_unittest('figures-of-driven-pendulums', test_sweeps), &
         new_unittest('tables', test_tables), &
         new_unittest('tables-of-any-length', test_long_tables), &
         new_unittest('tables-that-are-none', test_bad_tables), &
         new_unittest('tables-of-ensemble', test_ensemble), &
         new_unittest('words-of-the-data', test_header), &
         new_unittest('words-of-the-picture', test_words), &
         new_unittest('scale', test_scale), &
         new_unittest('digits-as-converge', test_converge), &
         new_unittest('how-late', test_late), &
         new_unittest('scripts-and-data', test_scripts), &
         new_unittest('svg-carries-the-data', test_svg)]
   end subroutine collect_plot


   !> Every figure is in the list
   subroutine test_list(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code, i

      call run_program('plot --list', output, errors, code)
      call check(error, code == 0 .and. line_count(output) == size(figures) + size(sweeps) .and. errors == '')
      if (allocated(error)) return
      do i = 1, size(figures)
         call check(error, index(nl // output, nl // trim(figures(i)) // ' ') > 0, figures(i))
         if (allocated(error)) return
      end do
      do i = 1, size(sweeps)
         call check(error, index(nl // output, nl // trim(sweeps(i)) // ' ') > 0, sweeps(i))
         if (allocated(error)) return
      end do
      call run_program('plot --help', output, errors, code)
      call check(error, code == 0 .and. index(output, 'furiko plot FIGURE -o FILE') == 1)
   end subroutine test_list


   !> A bad command line: code 2, one line, nothing written
   subroutine test_refusals(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: commands(*) = [character(len=72) :: '', '-o x.svg', &
         'nosuch -o x.svg', 'phase', 'phase -o', 'phase -o ""', 'phase -o x', 'phase -o x.gif', &
         'phase -o x.SVG', 'phase -o .svg', 'phase -o svg', 'phase phase -o x.svg', &
         'phase -o x.svg --nosuch', 'phase -o x.svg --size 800', 'phase -o x.svg --size 800x', &
         'phase -o x.svg --size x500', 'phase -o x.svg --size 8x5', 'phase -o x.svg --size 9000x500', &
         'phase -o x.svg --size 800x500x2', 'phase -o x.svg --size 99999999999x500', &
         'phase -o x.svg --size -800x500', &
         'phase -o x.svg --size 599x400', 'phase -o x.svg --size 600x399', 'phase -o x.svg --scale 0.7', &
         'phase -o x.svg --scale 9', 'phase -o x.svg --scale x', 'phase -o x.svg --scale nan', &
         'phase -o x.svg --size 5000x4000 --scale 2', 'flow -o x.svg --amplitude 1', 'phase -o x.svg ' // &
         '--amplitude 0', &
         'phase -o x.svg --amplitude 180', 'phase -o x.svg --amplitude 3.15rad', &
         'phase -o x.svg --amplitude -1', 'phase -o x.svg --amplitude 1,', &
         'phase -o x.svg --amplitude ,1', 'phase -o x.svg --amplitude nan', &
         'phase -o x.svg --amplitude 1grad', 'phase -o x.svg --amplitude=', &
         'motion -o x.svg --amplitude 1,2,3,4,5,6', 'drift -o x.svg --amplitude 1,2', &
         'energy -o x.svg --amplitude 1,2', 'period -o x.svg --amplitude 1', &
         'accuracy -o x.svg --amplitude 1', 'phase -o x.svg --title "$(printf "a\nb")"', &
         'phase -o "$(printf "a\nb.svg")"', 'phase -o x.svg --title "$(printf "\033")"', &
         'phase -o x.svg --title "a]]>b"', 'phase -o x.svg --title "$(printf "%1001d" 1)"', &
         'phase -o x.svg --title "$(printf "a\377b")"', 'phase -o x.svg --title "$(printf "\303")"', &
         'phase -o x.svg --title "$(printf "\357\277\276")"', &
         'phase -o x.svg --title "$(printf "x\357\277\277")"', &
         'phase -o x.svg --amplitude $(yes , | head -n 60000 | tr -d "\n")', &
         'converge -o x.svg --amplitude 1,2,3', 'tension -o x.svg --amplitude 1,2,3,4,5,6,7']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(commands)
         call run_inside('furiko plot ' // trim(commands(i)), output, errors, code)
         call check(error, code == 2 .and. output == '', 'code and output of: ' // commands(i))
         if (allocated(error)) return
         call check(error, line_count(errors) == 1 .and. index(errors, 'furiko plot: ') == 1, &
            'message of: ' // commands(i))
         if (allocated(error)) return
      end do
   end subroutine test_refusals


   !> Code 1, one line that names the file, nothing left
   subroutine test_places(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_inside('furiko plot phase -o none/x.svg', output, errors, code)
      call check(error, code == 1 .and. output == '' .and. line_count(errors) == 1 .and. &
         index(errors, 'furiko: cannot write none/x.svg: ') == 1, errors)
      if (allocated(error)) return
      call run_inside('mkdir x.svg; furiko plot phase -o x.svg', output, errors, code)
      call check(error, code == 1 .and. output == 'x.svg' // nl .and. line_count(errors) == 1 .and. &
         index(errors, 'furiko: cannot write x.svg: Is a directory') == 1, errors)
   end subroutine test_places


   !> Code 3, one line that says how to get it, the data and a script that draws the picture
   subroutine test_without_gnuplot(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_inside('(PATH=; furiko plot period -o x.png)', output, errors, code)
      call check(error, code == 3 .and. output == 'x.csv' // nl // 'x.gp' // nl .and. &
         line_count(errors) == 1 .and. index(errors, 'apt-get install gnuplot-nox') > 0, &
         'without gnuplot: ' // output // errors)
      if (allocated(error)) return
      if (.not. have_gnuplot()) return
      call run_shell('cd ' // work() // ' && gnuplot x.gp && ls', output, errors, code)
      call check(error, code == 0 .and. output == 'x.csv' // nl // 'x.gp' // nl // 'x.png' // nl, &
         'the script: ' // output // errors)
      if (allocated(error)) return
      call check(error, size_of('png', contents(work() // '/x.png')), '800x500')
   end subroutine test_without_gnuplot


   !> Code 1, one line with gnuplot's own, the old picture as it was, nothing else; also where
   !> gnuplot says that all is well and has drawn nothing, or a half
   subroutine test_failing_gnuplot(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: scripts(*) = [character(len=40) :: 'echo oops >&2; exit 1', &
         'exit 0', 'echo "<svg "', 'echo "</svg>"; kill -9 $$']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(scripts)
         call run_inside('mkdir bin; echo old >x.svg; printf ''#!/bin/sh\n%s\n'' ''' // &
            trim(scripts(i)) // ''' >bin/gnuplot; chmod +x bin/gnuplot; ' // &
            '(PATH=$PWD/bin:$PATH; furiko plot phase -o x.svg)', output, errors, code)
         call check(error, code == 1 .and. output == 'bin' // nl // 'x.svg' // nl .and. &
            contents(work() // '/x.svg') == 'old' // nl .and. line_count(errors) == 1 .and. &
            index(errors, 'furiko plot: gnuplot drew no whole x.svg') == 1, &
            trim(scripts(i)) // ': ' // output // errors)
         if (allocated(error)) return
         if (i == 1) call check(error, index(errors, ': oops') > 0, errors)
         if (allocated(error)) return
      end do
   end subroutine test_failing_gnuplot


   !> Every figure in every form: there, alone, whole, of the size asked for
   subroutine test_formats(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: forms(*) = ['svg', 'png', 'pdf']
      character(len=:), allocatable :: errors, extent, file, output
      integer :: code, i, j

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      do j = 1, size(forms)
         do i = 1, size(figures)
            call draw(trim(figures(i)), '')
            if (allocated(error)) return
         end do
         do i = 1, size(sweeps)
            call draw(trim(sweeps(i)), 'furiko driven ' // trim(tables(i)) // ' --steps 16 --format csv | ')
            if (allocated(error)) return
         end do
      end do

   contains

      subroutine draw(name, table)
         character(len=*), intent(in) :: name
         !> What writes the table, and a pipe; empty for none
         character(len=*), intent(in) :: table

         file = 'x.' // forms(j)
         call run_inside(table // 'furiko plot ' // name // trim(merge(' --from -', '         ', &
            table /= '')) // ' --size 640x480 -o ' // file, output, errors, code)
         call check(error, code == 0 .and. errors == '' .and. output == file // nl, &
            name // ' as ' // forms(j) // ': ' // output // errors)
         if (allocated(error)) return
         call check(error, len(contents(work() // '/' // file)) > 5000, name // ' is small')
         if (allocated(error)) return
         extent = size_of(forms(j), contents(work() // '/' // file))
         call check(error, extent == '640x480' .or. forms(j) == 'pdf' .and. extent == 'packed', &
            name // ' as ' // forms(j) // ': ' // extent)
      end subroutine draw

   end subroutine test_formats


   !> Names and titles are text to the shell and to gnuplot
   subroutine test_strange_text(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      call run_inside('export GNUTERM=x11; furiko plot period --title "it''s \`touch y\` \$(touch y) <b>' // &
         ' & {/Bold x} %d θ_0" -o "it''s \$(touch y) \`touch y\` ; <b>.svg" --data && ' // &
         'mv *.svg x.svg', output, errors, code)
      call check(error, code == 0 .and. output == "it's $(touch y) `touch y` ; <b>.csv" // nl // &
         "it's $(touch y) `touch y` ; <b>.gp" // nl // 'x.svg' // nl, output // errors)
      if (allocated(error)) return
      call check(error, index(contents(work() // '/x.svg'), &
         ">it's `touch y` $(touch y) &lt;b> &amp; {/Bold x} %d θ_0<") > 0, 'the title')
   end subroutine test_strange_text


   !> Neither the program nor the script that it leaves runs what a name says
   subroutine test_names_of_commands(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: names(*) = [character(len=12) :: '<touch y; #', '|touch y; #', '-', &
         '+', '++', '$y', '''', '''''q', '~y', '"`touch y`"']
      character(len=:), allocatable :: errors, name, output
      integer :: code, i

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      do i = 1, size(names)
         name = trim(names(i))
         call run_inside('name=$(cat <<\END' // nl // name // nl // 'END' // nl // &
            '); furiko plot accuracy -o "$name.svg" --data && rm "./$name.svg" && gnuplot "./$name.gp"', &
            output, errors, code)
         call check(error, code == 0 .and. output == name // '.csv' // nl // name // '.gp' // nl // &
            name // '.svg' // nl, name // ': ' // output // errors)
         if (allocated(error)) return
      end do
   end subroutine test_names_of_commands


   !> Quotes in front, doubled, behind; what the shell, gnuplot or a format would replace
   subroutine test_titles(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: titles(*) = [character(len=12) :: '''', '''''', '''a', 'a''', '$HOME', &
         '`touch y`', '\"x', '@x', '%d %s', '~a', '#x', '^_', '\', '日本']
      character(len=:), allocatable :: errors, figure, output, title
      integer :: code, i

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      do i = 1, size(titles)
         title = trim(titles(i))
         figure = trim(merge('accuracy', 'converge', modulo(i, 2) == 0))
         call run_inside('title=$(cat <<\END' // nl // title // nl // 'END' // nl // '); furiko plot ' // &
            figure // ' -o x.svg --title "$title"', output, errors, code)
         call check(error, code == 0 .and. output == 'x.svg' // nl .and. &
            index(contents(work() // '/x.svg'), '>' // title // '<') > 0, title // ': ' // output // errors)
         if (allocated(error)) return
      end do
   end subroutine test_titles


   !> What is no UTF-8 is refused before anything is drawn, the first and last of each length is not.
   !> The title is followed by a wrong option, so that nothing needs gnuplot.
   subroutine test_utf8(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: broken(*) = [character(len=16) :: '\200', '\277', '\300\200', &
         '\301\277', &
         '\302', '\302(', '\303\300', '\337\176', '\340\237\277', '\340\240', '\355\240\200', &
         '\357\277(', '\357\277\300', '\360\217\277\277', '\360\220\200', '\364\220\200\200', &
         '\365\200\200\200', '\377', '\303\244\244', 'x\303', '\303x']
      character(len=*), parameter :: whole(*) = [character(len=20) :: '\176', '\302\200', '\337\277', &
         '\340\240\200', '\355\237\277', '\356\200\200', '\357\277\275', '\360\220\200\200', &
         '\364\217\277\277', 'x\316\270x\316\270']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(broken)
         call run_inside('furiko plot phase -o x.svg --title "$(printf ''' // trim(broken(i)) // ''')"; ls', &
            output, errors, code)
         call check(error, output == '' .and. errors == 'furiko plot: --title is not UTF-8' // nl, &
            trim(broken(i)) // ': ' // errors)
         if (allocated(error)) return
      end do
      do i = 1, size(whole)
         call run_inside('furiko plot phase -o x.svg --amplitude 200 --title "$(printf ''' // &
            trim(whole(i)) // ''')"; ls', output, errors, code)
         call check(error, output == '' .and. index(errors, 'UTF') == 0 .and. index(errors, '200') > 0, &
            trim(whole(i)) // ': ' // errors)
         if (allocated(error)) return
      end do
   end subroutine test_utf8


   !> What was typed is what is drawn
   subroutine test_amplitudes(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output, picture
      integer :: code

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      call run_inside('furiko plot motion --data --amplitude 0.50rad,60deg -o x.svg && ' // &
         'grep -v "^#" x.csv | cut -d, -f1 | uniq | grep .; rm x.csv x.gp', output, errors, code)
      call check(error, output, 'curve' // nl // 'exact 0.50 rad' // nl // 'harmonic 0.50 rad' // nl &
         // 'exact 60°' // nl // 'harmonic 60°' // nl // 'x.svg' // nl)
      if (allocated(error)) return
      picture = contents(work() // '/x.svg')
      call check(error, index(picture, ' = 60°,') > 0 .and. index(picture, ' = 1.0732 ') > 0, 'labels')
   end subroutine test_amplitudes


   !> Numbers that are known: the note's period at 90 degrees; a tenth swing that ends after 10.3
   !> small ones; half an ulp up to the top
   subroutine test_data(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      call run_inside('furiko plot period --data -o x.svg; grep "^exact,9.0*E+001" x.csv; ' // &
         'tail -n 1 x.csv | cut -d, -f1-3; rm x.*', output, errors, code)
      ! The latter by mpmath: 2 K(sin^2(179.9/2 degrees))/pi
      call check(error, output, 'exact,9.000000000E+001,1.180340599E+000,9.000000000E+001' // nl // &
         'exact,1.799000000E+002,5.366867109E+000' // nl)
      if (allocated(error)) return
      call run_inside('furiko plot drift --data -o x.svg; awk -F, ''/^exact/ && $2 > 9.8 && $3 > most ' // &
         '{most = $3; at = $2} END {print ((at - 10.3)^2 < 1e-3), (most > 39.1)}'' x.csv; rm x.*', &
         output, errors, code)
      call check(error, output, '1 1' // nl)
      if (allocated(error)) return
      call run_inside('furiko plot accuracy --data -o x.svg; awk -F, ' // &
         '''/^K by mc/ {n++; if ($3 > 0.7) bad++} END {print n, bad + 0}'' x.csv; rm x.*', &
         output, errors, code)
      call check(error, output, '104 0' // nl)
   end subroutine test_data


   !> A value from each of the figures that show functions, by mpmath 1.4.1 with 40 digits, and what a figure
   !> marks
   subroutine test_function_data(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: rows(*) = [character(len=80) :: &
         'sn of m = 0.90,6.000000000E+000,-6.938929155E-001$', &
         'cn of m = 0.99,1.200000000E+001,1.041830557E-001$', &
         'dn of m = 0.50,3.000000000E+000,8.952830450E-001$', &
         'am of m = 0.90,1.200000000E+001,4.799043231E+000$', &
         'F of m = 0.99,1.200000000E+002,6.079618589E+000$', &
         'E of m = 0.50,1.800000000E+002,2.701287762E+000$', &
         'complement of K,5.000000000E-001,1.854074677E+000$', &
         'n = 3,9.000000000E+001,1.372435010E+000$', &
         'sn,4.000000000E+000,9.375000000E-001,9.323326939E-001$', &
         'flow,8.100000000E+001,-2.500000000E-001,-1.432394488E+001,-9.876883406E-001$', &
         'slack of 120°,1.094712206E+002,0.000000000E+000$', &
         'amplitude 60°,0.000000000E+000,2.000000000E+000$', &
         'periods of a = 0.90,-3.2098[67][0-9]*E+001,1.93358[0-9]*E+000$']
      character(len=*), parameter :: names(*) = [character(len=9) :: 'functions', 'functions', &
         'functions', 'functions', &
         'integrals', 'integrals', 'integrals', 'spectrum', 'surface', 'flow', &
         'tension', 'tension', 'driven']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      do i = 1, size(rows)
         call run_inside('furiko plot ' // trim(names(i)) // ' --data -o x.svg; grep -c "^' // &
            trim(rows(i)) // &
            '" x.csv; rm x.*', output, errors, code)
         call check(error, output, '1' // nl, trim(rows(i)) // ': ' // output // errors)
         if (allocated(error)) return
      end do
   end subroutine test_function_data


   !> The second and the third point of each start come from the one before in a period of the drive, in
   !> steps half as long.
   subroutine test_section(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: degree = acos(-1.0_wp)/180, nu = 2.0_wp/3.0_wp
      integer, parameter :: steps = 480
      character(len=:), allocatable :: errors, output
      type(polyline), allocatable :: curves(:)
      real(wp) :: turn, y(2)
      integer :: code, i

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      call run_inside('furiko plot poincare --data -o x.svg', output, errors, code)
      curves = data_of(contents(work() // '/x.csv'))
      call check(error, size(curves) == 1 .and. size(curves(1)%x) == 1200, 'points')
      if (allocated(error)) return
      do i = 1, 1199
         if (modulo(i, 3) == 0) cycle
         y = [curves(1)%x(i)*degree, curves(1)%y(i)]
         call rk4(driven_pendulum_rates, [1.0_wp, 0.5_wp, 0.0_wp, 1.5_wp, nu], 0.0_wp, &
            2*acos(-1.0_wp)/nu/steps, steps, y)
         turn = (y(1)/degree - curves(1)%x(i + 1))/360
         call check(error, abs(turn - anint(turn)) < 1e-5_wp .and. abs(y(2) - curves(1)%y(i + 1)) < 1e-4_wp, &
            'a point that does not follow')
         if (allocated(error)) return
      end do
   end subroutine test_section


   !> The figures by themselves: points of cycles and exponents that driven.md's table has, the sizes of two
   !> basins, a step; and an image, so that none of the files is large
   subroutine test_sweeps(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: programs(*) = [character(len=200) :: &
         '/^d/ && $2 < 1.066 && $4 {n[$2]++} /^d/ && $2 < 1.0601 && $4 && ($3 + 14.127)^2 < 0.01 ' // &
            '{near = 1} END {for (x in n) if (n[x] > 2) wide++; print wide + 0, near + 0}', &
         '/^b/ {n++; one += $4 == 1} /^p.*1,/ && ($2 + 4.1412)^2 + ($3 - 0.93428)^2 < 1e-7 {near = 1} ' // &
            'END {print (one/n > 0.607 && one/n < 0.614), near + 0}', &
         '/^locked at 1.2/ && $3 == 0.5 && $2 > 0.97 && $2 < 1.11 {n++} /^w/ && $3 < 0 {bad++} ' // &
            'END {print n, bad + 0}', &
         '/^e/ && ($2 - 1.35)^2 < 1e-6 {n = 1; if (($3 + 0.25)^2 > 1e-6) bad++} END {print n, bad + 0}']
      character(len=*), parameter :: answers(*) = [character(len=3) :: '0 1', '1 1', '2 0', '1 0']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      do i = 1, size(sweeps)
         call run_inside('furiko plot ' // trim(sweeps(i)) // ' --data -o x.svg && grep -c "<image" ' // &
         'x.svg; ' // &
            'awk -F, ''' // trim(programs(i)) // ''' x.csv; rm x.csv x.gp', output, errors, code)
         call check(error, output, merge('1', '0', i < 3) // nl // trim(answers(i)) // nl // 'x.svg' // nl, &
            trim(sweeps(i)) // ': ' // output // errors)
         if (allocated(error)) return
         call check(error, len(contents(work() // '/x.svg')) < 200000, trim(sweeps(i)) // ' is large')
         if (allocated(error)) return
      end do
   end subroutine test_sweeps


   !> Each row of a table is in the picture, in the columns that the header names, wherever they stand, and
   !> the axis is called what the header calls it. Rows of NaN are left out, and said.
   subroutine test_tables(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code, i

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      do i = 1, 2
         call run_inside('furiko driven ' // trim(tables(i)) // ' --steps 16 --format csv >t; furiko ' // &
         'plot ' // &
            trim(sweeps(i)) // ' --from t --data -o x.svg; awk -F, ''/^[db][ea]/ {n += /^d/ ? $4 : 1} ' // &
            'END ' // &
            '{print n}'' x.csv; rm *', output, errors, code)
         call check(error, output, trim(merge('72', '64', i == 1)) // nl, trim(sweeps(i)) // errors)
         if (allocated(error)) return
      end do
      call run_inside('printf "volt_age;x;winding;angle_rad\n1;0;0.5;1\n2;0;0.5;nan\n3;0;0.5;-1\n" >t; ' // &
         'furiko plot staircase --from t --data -o x.svg; grep -c ">volt age<" x.svg; grep "^l" x.csv; ' // &
         'furiko plot bifurcation --from t --data -o x.svg; awk -F, ''/^d/ && $4 ' // &
         '{print $2, ($3 > 0)}'' x.csv; rm *', output, errors, code)
      call check(error, output, '1' // nl // 'locked at 1/2,1.000000000E+000,5.000000000E-001' // nl // &
         'locked at 1/2,3.000000000E+000,5.000000000E-001' // nl // '3.000000000E+000 0' // nl // &
         '1.000000000E+000 1' // nl, output // errors)
      if (allocated(error)) return
      call check(error, errors, 'furiko plot: --from t: rows of NaN, of members that ran away, are left ' // &
      'out: 1' &
         // nl)
   end subroutine test_tables


   !> More rows than are kept in memory, and more points of a curve than a picture has room for
   subroutine test_long_tables(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      call run_inside('awk ''BEGIN {print "drive,angle_rad,exponent_1,rate"; for (i = 0; i < 300000; ' // &
      'i++) ' // &
         'print int(i/100), sin(i), (i % 7) - 3, cos(i)}'' OFS=, >t; for figure in bifurcation poincare ' // &
         'exponents; do furiko plot $figure --from t --data -o x.svg; awk -F, ''/^d/ {n += $4} /^e/ ' // &
         '{n++; ' // &
         'if ($3 == 3) high++} END {print n, high + 0}'' x.csv; done; rm *', output, errors, code)
      call check(error, output // errors, '300000 0' // nl // '300000 0' // nl // '1388 694' // nl)
   end subroutine test_long_tables


   !> What is no table of the figure: code 2, one line, and no file is touched
   subroutine test_bad_tables(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: bad(*) = [character(len=72) :: '', 'drive,angle_rad', '1,2', &
         'drive,rate\n1,2', 'angle_rad,rate\n1,2', 'drive,angle_rad\n1,x', 'drive,angle_rad\n1', &
         'drive,angle_rad\n1,2,3', 'drive,angle_rad\n1,', 'drive,angle_rad\n1,nan', &
         'drive,angle_rad\n1,1e999', '<x>,angle_rad\n1,2', '1e5,angle_rad\n1,2', ',angle_rad\n1,2', &
         'a_very_long_name_of_a_column,angle_rad\n1,2', '{"drive": 1}']
      character(len=*), parameter :: commands(*) = [character(len=72) :: 'phase --from t -o x.svg', &
         'poincare --from= -o x.svg', 'basins --from t -o x.svg', 'basins --from u -o x.svg', &
         'bifurcation --from "$(printf "a\nb")" -o x.svg', 'bifurcation --from - -o x.svg <v']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(bad)
         call run_inside('echo old >x.svg; printf "' // trim(bad(i)) // '" | furiko plot bifurcation ' // &
            '--from - -o x.svg; code=$?; cat x.svg; (exit $code)', output, errors, code)
         call check(error, code == 2 .and. output == 'old' // nl // 'x.svg' // nl .and. &
            line_count(errors) == 1 .and. index(errors, 'furiko plot: standard input') == 1, &
            trim(bad(i)) // ': ' // output // errors)
         if (allocated(error)) return
      end do
      do i = 1, size(commands)
         call run_inside('printf "angle_rad,rate,attractor\n1,1,1\n2,1,1\n1,2,1\n" >t; ' // &
            'printf "angle_rad,rate,attractor\n1,1,1\n2,1,1\n1,2,1\n2,3,1\n" >u; printf ' // &
            '"\211HDF\r\n\032\n" >v; ' // &
            'furiko plot ' // trim(commands(i)) // '; code=$?; rm t u v; (exit $code)', output, errors, code)
         call check(error, code == 2 .and. output == '' .and. line_count(errors) == 1 .and. &
            index(errors, 'furiko plot: ') == 1, trim(commands(i)) // ': ' // output // errors)
         if (allocated(error)) return
      end do
      call run_inside('furiko plot bifurcation --from none -o x.svg', output, errors, code)
      call check(error, code == 2 .and. output == '' .and. line_count(errors) == 1 .and. &
         index(errors, 'furiko: cannot read none: ') == 1, errors)
      if (allocated(error)) return
      call run_inside('furiko plot bifurcation --from . -o x.svg', output, errors, code)
      call check(error, code == 2 .and. output == '' .and. line_count(errors) == 1, errors)
   end subroutine test_bad_tables


   !> An HDF5 file goes through `ensemble table`, found in the PATH; it says itself what it cannot do. The
   !> name of the file is text to the shell.
   subroutine test_ensemble(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: start = 'mkdir bin; printf "#!/bin/sh\n[ \"\$1\" = table ] && . ' // &
      'bin/it\n" ' // &
         '>bin/ensemble; chmod +x bin/ensemble; printf "\211HDF\r\n\032\nrest" >"it''s \$(touch y).h5"; '
      character(len=*), parameter :: draw = 'PATH=$PWD/bin:${others-$PATH} ' // &
         'furiko plot bifurcation --from ' // &
         '"it''s \$(touch y).h5" -o x.svg; code=$?; rm -r bin *.h5; (exit $code)'
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_inside(start // 'echo "echo oops: \$2 >&2; exit 1" >bin/it; ' // draw, output, errors, code)
      call check(error, code == 2 .and. output == '' .and. errors == "oops: it's $(touch y).h5" // nl, &
         output // errors)
      if (allocated(error)) return
      call run_inside(start // 'rm bin/ensemble; others=/usr/bin:/bin; ' // draw, output, errors, code)
      call check(error, code == 2 .and. output == '' .and. line_count(errors) == 1 .and. &
         index(errors, 'no ensemble here') > 0, output // errors)
      if (allocated(error) .or. .not. have_gnuplot()) return
      call run_inside(start // 'echo "printf ''drive,angle_rad\n1,2\n2,1\n''" >bin/it; ' // draw, output, &
         errors, code)
      call check(error, code == 0 .and. output == 'x.svg' // nl .and. errors == '', output // errors)
   end subroutine test_ensemble


   !> The data begin with what they are, the command as the shell takes it, and a line for each column.
   subroutine test_header(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      call run_inside('furiko plot drift --amplitude 5 --title "it''s" --data -o x.svg; head -n 6 ' // &
         'x.csv; rm x.*', &
         output, errors, code)
      call check(error, output, '# it''s' // nl // &
         '# command: furiko plot drift --amplitude 5 --title ''it''\''''s'' --data -o x.svg' // nl // &
         '# curve: its name' // nl // '# time_over_small_period: time in periods of small swings' // nl // &
         '# angle_deg: angle in degrees' // nl // 'curve,time_over_small_period,angle_deg' // nl)
   end subroutine test_header


   !> Every SVG file says what it is, in its own words, once, and is dark on a dark page.
   subroutine test_words(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output, picture
      integer :: code, i

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      do i = 1, size(figures)
         call run_inside('furiko plot ' // trim(figures(i)) // ' -o x.svg', output, errors, code)
         picture = contents(work() // '/x.svg')
         call check(error, index(picture, '<svg role="img" aria-labelledby="title about"') > 0 .and. &
            index(picture, '<title id="title">' // trim(figures(i)) // ': ') > 0 .and. &
            index(picture, 'Gnuplot') == 0 .and. index(picture, '>data ') == 0 .and. &
            index(picture, 'prefers-color-scheme: dark') > 0 .and. index(picture, '<text>') > 0, figures(i))
         if (allocated(error)) return
         picture = picture(index(picture, '<desc id="about">') + len('<desc id="about">'):)
         call check(error, index(picture, 'Produced by GNUPLOT') > 100 .and. &
            index(picture, 'Produced by GNUPLOT') < index(picture, '</desc>'), figures(i) // ' has no words')
         if (allocated(error)) return
      end do
      call run_inside('furiko plot flow --title "a & b <c>" -o x.svg', output, errors, code)
      call check(error, index(contents(work() // '/x.svg'), '<title id="title">a &amp; b ' // &
         '&lt;c&gt;</title>') > 0)
   end subroutine test_words


   !> Twice as large: paper, letters, lines, and pixels that are half as large
   subroutine test_scale(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: forms(*) = ['svg', 'png', 'pdf']
      character(len=:), allocatable :: errors, extent, output, picture
      integer :: code, i

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      do i = 1, size(forms)
         call run_inside('furiko plot tension --size 600x400 --scale 2 -o x.' // forms(i), output, &
            errors, code)
         call check(error, code == 0, errors)
         if (allocated(error)) return
         picture = contents(work() // '/x.' // forms(i))
         extent = size_of(forms(i), picture)
         call check(error, extent == '1200x800' .or. forms(i) == 'pdf' .and. extent == 'packed', extent)
         if (allocated(error)) return
         if (forms(i) == 'svg') call check(error, index(picture, 'font-size="28.00"') > 0 .and. &
            index(picture, 'font-size="14.00"') == 0 .and. index(picture, 'stroke-width="4.00"') > 0, &
            'letters, lines')
         if (allocated(error)) return
         ! 192 pixels an inch: 7559 a metre, and the sum of the chunk by zlib
         if (forms(i) == 'png') call check(error, picture(34:54) == achar(0) // achar(0) // achar(0) // &
            achar(9) // &
            'pHYs' // achar(0) // achar(0) // achar(29) // achar(135) // achar(0) // achar(0) // &
            achar(29) // &
            achar(135) // achar(1) // achar(143) // achar(229) // achar(241) // achar(101), 'pHYs')
         if (allocated(error)) return
      end do
   end subroutine test_scale


   !> The work that the figure tells is what `furiko converge` needs for an error below half an ulp, at 60
   !> degrees, k = 1/2.
   subroutine test_converge(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output, picture
      integer :: code

      call run_shell('furiko converge --k 1/2 --steps 30 --format csv | awk -F, ''' // &
         'function small(x) {return (x < 0 ? -x : x) <= 2^-53} ' // &
         'NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i; next} ' // &
         '!s && small($at["series_error"]) {s = $1} !t && small($at["trapezoid_error"]) {t = $1} ' // &
         '!a && small($at["agm_error"]) {a = $1} ' // &
         'END {printf "%d terms, %d subintervals, %d steps at 60", s, t, a}''', output, errors, code)
      call check(error, index(output, '24 terms, 7 subintervals, 4 steps') == 1, output // errors)
      if (allocated(error)) return
      if (.not. have_gnuplot()) return
      picture = output
      call run_inside('furiko plot converge -o x.svg', output, errors, code)
      call check(error, index(contents(work() // '/x.svg'), picture) > 0, picture)
   end subroutine test_converge


   !> Small delays are told by their digits.
   subroutine test_late(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: amplitudes(*) = [character(len=6) :: '5', '39.159', '0.01', '179.99']
      character(len=*), parameter :: delays(*) = [character(len=16) :: '0.0048', '0.30', '1.9·10−8', '58']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      do i = 1, size(amplitudes)
         call run_inside('furiko plot drift --amplitude ' // trim(amplitudes(i)) // ' -o x.svg', &
            output, errors, code)
         call check(error, index(contents(work() // '/x.svg'), 'They end ' // trim(delays(i)) // &
            ' periods') > 0, &
            amplitudes(i))
         if (allocated(error)) return
      end do
   end subroutine test_late


   !> What gnuplot is told, and the heads, names and some rows of the data, as in session-plots.txt;
   !> numbers to six digits
   subroutine test_scripts(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_inside('session=$OLDPWD/test/data/session-plots.txt; . "$OLDPWD/test/data/session.sh"', &
         output, errors, code)
      call check(error, output // errors, contents('test/data/session-plots.txt'))
   end subroutine test_scripts


   !> Every curve of every figure: one scale and one shift take its points in the data to those of
   !> its path in the picture, to the picture's last digit
   subroutine test_svg(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code, i

      if (.not. have_gnuplot()) call skip_test(error, 'no gnuplot')
      if (allocated(error)) return
      do i = 1, size(figures)
         call run_inside('furiko plot ' // trim(figures(i)) // ' --data -o x.svg', output, errors, code)
         call check(error, code == 0, errors)
         if (allocated(error)) return
         call compare(error, trim(figures(i)))
         if (allocated(error)) return
      end do
   end subroutine test_svg


   !> Compare x.svg with x.csv, following the order in which x.gp draws.
   subroutine compare(error, name)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: name
      type(polyline), allocatable :: curves(:)
      character(len=:), allocatable :: picture, script, group
      logical, allocatable :: seen(:)
      logical :: logarithmic(2)
      integer :: at, block

      script = contents(work() // '/x.gp')
      picture = contents(work() // '/x.svg')
      curves = data_of(contents(work() // '/x.csv'))
      allocate(seen(size(curves)))
      seen = .false.
      logarithmic = .false.
      do
         at = index(script, ' index ')
         if (at == 0) exit
         if (index(script(:at), 'unset logscale') > 0) logarithmic = &
            [index(script(:at), 'set logscale x') > 0, index(script(:at), 'set logscale y') > 0]
         script = script(at + len(' index '):)
         read(script(:scan(script, ' ')), *) block
         at = index(picture, '<g id="gnuplot_plot_')
         call check(error, at > 0, name // ': a curve is not drawn')
         if (allocated(error)) return
         picture = picture(at + 1:)
         group = picture(:index(picture // '<g id="gnuplot_plot_', '<g id="gnuplot_plot_') - 1)
         seen(block + 1) = .true.
         call compare_drawn(error, name, script(:index(script, ' title') - 1), curves(block + 1), &
            group, logarithmic)
         if (allocated(error)) return
      end do
      call check(error, all(seen), name // ': a curve of the data is not drawn')
   end subroutine compare


   !> By the way it is drawn: lines point by point, points and arrows by their number; of the surface,
   !> which is seen from aslant, and of broken lines, that they are there
   subroutine compare_drawn(error, name, look, curve, group, logarithmic)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: name
      !> What the script says of it
      character(len=*), intent(in) :: look
      type(polyline), intent(in) :: curve
      !> The picture's part that shows it
      character(len=*), intent(in) :: group
      logical, intent(in) :: logarithmic(2)
      type(polyline) :: numbers

      numbers%x = curve%x
      if (index(look, ' using 4:3') > 0) numbers%x = curve%z
      numbers%y = curve%y
      if (index(look, ' with points') > 0) then
         call check(error, occurrences(group, '<use ') == size(curve%x), name // ': number of points')
      else if (index(look, ' with vectors') > 0) then
         call check(error, occurrences(group, 'M') == 2*size(curve%x), name // ': number of arrows')
      else if (index(look, ':4 with') > 0 .or. curve%broken) then
         call check(error, occurrences(group, 'L') > size(curve%x)/2, name // ': a line is missing')
      else
         call compare_curve(error, name, numbers, path_of(group), logarithmic)
      end if
   end subroutine compare_drawn


   pure function occurrences(text, part) result(count)
      character(len=*), intent(in) :: text
      character(len=*), intent(in) :: part
      integer :: count
      integer :: i

      count = 0
      do i = 1, len(text) - len(part) + 1
         if (text(i:i + len(part) - 1) == part) count = count + 1
      end do
   end function occurrences


   subroutine compare_curve(error, name, numbers, path, logarithmic)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: name
      type(polyline), intent(in) :: numbers
      type(polyline), intent(in) :: path
      logical, intent(in) :: logarithmic(2)
      !> Of a pixel: both ends of the scale are rounded to 0.01, and so is every point
      real(wp), parameter :: tolerance = 0.03_wp
      real(wp), allocatable :: x(:), y(:)
      real(wp) :: best
      integer :: n

      ! Where the axes cut a curve off, at one of its ends, its last point is not of the data.
      n = size(path%x)
      call check(error, n > 1 .and. n <= size(numbers%x), name // ': points')
      if (allocated(error)) return
      x = numbers%x
      y = numbers%y
      if (logarithmic(1)) x = log10(x)
      if (logarithmic(2)) y = log10(y)
      best = min(apart(x(:n - 1), y(:n - 1), path%x(:n - 1), path%y(:n - 1)), &
         apart(x(size(x) - n + 2:), y(size(y) - n + 2:), path%x(2:), path%y(2:)))
      call check(error, best < tolerance, name // ': the path leaves the data')
      if (allocated(error)) return
      call check(error, maxval(path%x) - minval(path%x) > 1.0_wp, name // ': a curve is a point')
   end subroutine compare_curve


   !> How far a path is from numbers, across or down
   pure function apart(x, y, across, down)
      real(wp), intent(in) :: x(:)
      real(wp), intent(in) :: y(:)
      real(wp), intent(in) :: across(:)
      real(wp), intent(in) :: down(:)
      real(wp) :: apart

      apart = max(residual(x, across), residual(y, down))
   end function apart


   !> How far pixels are from scale*numbers + shift, these taken from the ends of the range
   pure function residual(numbers, pixels)
      real(wp), intent(in) :: numbers(:)
      real(wp), intent(in) :: pixels(:)
      real(wp) :: residual
      real(wp) :: scale
      integer :: high, low

      low = minloc(numbers, dim=1)
      high = maxloc(numbers, dim=1)
      scale = 0.0_wp
      if (numbers(high) > numbers(low)) scale = (pixels(high) - pixels(low))/(numbers(high) - numbers(low))
      residual = maxval(abs(pixels - pixels(low) - scale*(numbers - numbers(low))))
   end function residual


   !> The curves of a CSV file: runs of rows, two blank lines between them; a single one is a gap
   function data_of(csv) result(curves)
      character(len=*), intent(in) :: csv
      type(polyline), allocatable :: curves(:)
      real(wp) :: row(3)
      integer :: at, blank, comma, columns, next

      allocate(curves(0))
      call append_empty(curves)
      at = index(csv, nl // 'curve,') + 1
      columns = count([(csv(next:next) == ',', next=at, at + index(csv(at:), nl))])
      at = at + index(csv(at:), nl)
      row = 0.0_wp
      blank = 0
      do while (at <= len(csv))
         next = at + index(csv(at:), nl)
         if (next == at + 1) then
            blank = blank + 1
         else
            if (blank == 2) call append_empty(curves)
            comma = at + index(csv(at:next - 2), ',')
            read(csv(comma:next - 2), *) row(:min(3, columns))
            associate (last => curves(size(curves)))
               if (blank == 1) last%broken = .true.
               last%x = [last%x, row(1)]
               last%y = [last%y, row(2)]
               last%z = [last%z, row(3)]
            end associate
            blank = 0
         end if
         at = next
      end do
   end function data_of


   !> One curve more, as yet without points
   subroutine append_empty(curves)
      type(polyline), allocatable, intent(inout) :: curves(:)
      type(polyline), allocatable :: longer(:)
      integer :: n

      n = size(curves)
      allocate(longer(n + 1))
      longer(:n) = curves
      allocate(longer(n + 1)%x(0), longer(n + 1)%y(0), longer(n + 1)%z(0))
      call move_alloc(longer, curves)
   end subroutine append_empty


   !> The first line in the paths of a piece of SVG: those behind it are axes
   function path_of(svg) result(line)
      character(len=*), intent(in) :: svg
      type(polyline) :: line
      character(len=:), allocatable :: rest
      real(wp), allocatable :: numbers(:)
      integer :: at, i

      rest = svg(index(svg, ' d=''M') + len(' d=''M'):)
      rest = rest(:index(rest, '''') - 1)
      do i = 1, len(rest)
         if (scan(rest(i:i), 'L' // achar(9) // nl) > 0) rest(i:i) = ' '
      end do
      at = verify(rest // 'M', '0123456789.,- ' // achar(9) // nl)
      allocate(numbers(2*count([(rest(i:i) == ',', i=1, at - 1)])))
      read(rest(:at - 1), *) numbers
      line%x = numbers(1::2)
      line%y = numbers(2::2)
   end function path_of


   !> Width and height in pixels as the file tells them, as '800x500'; 'packed' where a PDF's is in a
   !> compressed part (Debian 13's cairo)
   function size_of(form, picture) result(extent)
      character(len=*), intent(in) :: form
      character(len=*), intent(in) :: picture
      character(len=:), allocatable :: extent
      character(len=24) :: text
      integer :: at, height, width

      select case (form)
      case ('svg')
         at = index(picture, 'viewBox="0 0 ') + len('viewBox="0 0 ')
         read(picture(at:at + index(picture(at:), '"') - 2), *) width, height
      case ('png')
         width = big_endian(picture(17:20))
         height = big_endian(picture(21:24))
      case default
         extent = 'packed'
         if (index(picture, '/MediaBox') == 0) return
         at = index(picture, '/MediaBox [ 0 0 ') + len('/MediaBox [ 0 0 ')
         read(picture(at:at + index(picture(at:), ']') - 2), *) width, height
         width = width*4/3
         height = height*4/3
      end select
      write(text, '(i0, a, i0)') width, 'x', height
      extent = trim(text)
   end function size_of


   pure function big_endian(bytes) result(number)
      character(len=4), intent(in) :: bytes
      integer :: number
      integer :: i

      number = 0
      do i = 1, 4
         number = 256*number + iachar(bytes(i:i))
      end do
   end function big_endian


   function have_gnuplot()
      logical :: have_gnuplot
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_shell('command -v gnuplot', output, errors, code)
      have_gnuplot = code == 0
   end function have_gnuplot

end module test_plot
