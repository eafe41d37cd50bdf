! SPDX-License-Identifier: MIT

!> `furiko eval`: what it reads, what it refuses, what it writes
module test_eval
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_by_name_dp, only : evaluate
   use test_program, only : contents, line_count, run_inside, run_program, run_shell, work
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   public :: collect_eval


   character(len=*), parameter :: nl = new_line('a')


contains


   subroutine collect_eval(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('rows', test_rows), &
         new_unittest('kinds', test_kinds), &
         new_unittest('separators', test_separators), &
         new_unittest('what-others-write', test_others), &
         new_unittest('fields-refused', test_fields_refused), &
         new_unittest('rows-before-a-bad-one', test_rows_before), &
         new_unittest('long-lines', test_long_lines), &
         new_unittest('header', test_header), &
         new_unittest('formats', test_formats), &
         new_unittest('columns', test_columns), &
         new_unittest('reads-its-own', test_own), &
         new_unittest('as-the-arrays', test_arrays), &
         new_unittest('wherever-a-read-ends', test_chunks), &
         new_unittest('answers-at-once', test_at_once), &
         new_unittest('memory', test_memory), &
         new_unittest('input-that-cannot-be-read', test_no_input), &
         new_unittest('output-that-fails', test_no_output), &
         new_unittest('commands-refused', test_commands_refused), &
         new_unittest('list-can-be-called', test_list)]
   end subroutine collect_eval


   !> Run `furiko eval` with arguments on what printf makes of a text; expect an output.
   subroutine expect(error, text, arguments, expected)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: text
      character(len=*), intent(in) :: arguments
      character(len=*), intent(in) :: expected
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_shell("printf '" // text // "' | furiko eval " // arguments, output, errors, code)
      call check(error, output, expected, text)
      if (allocated(error)) return
      call check(error, code == 0 .and. errors == '', text // ': ' // errors)
   end subroutine expect


   !> Run `furiko eval ellipf_m` on a bad text; expect one line of complaint and the code 2.
   subroutine expect_refusal(error, text, complaint)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: text
      character(len=*), intent(in) :: complaint
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_shell("printf '" // text // "' | furiko eval ellipf_m", output, errors, code)
      call check(error, errors, 'furiko eval: ' // complaint // nl, text)
      if (allocated(error)) return
      call check(error, code == 2 .and. output == '', text // ': ' // output)
   end subroutine expect_refusal


   !> Comments, blank lines, CR and a last line without its end; two results in two columns; no rows
   subroutine test_rows(error)
      type(error_type), allocatable, intent(out) :: error

      call expect(error, '0.25\n# m\n\n \t\r\n 5d-1 \r\n  # 3, 4\n1', 'ellipke_m', &
         '1.685750354812596 1.4674622093394272' // nl // '1.8540746773013719 1.3506438810476755' // nl // &
         'inf 1' // nl)
      if (allocated(error)) return
      call expect(error, '', 'ellipk_m', '')
   end subroutine test_rows


   subroutine test_kinds(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call expect(error, '0.25', 'ellipk_m --kind real32', '1.6857504' // nl)
      if (allocated(error)) return
      call expect(error, '16777217.0000001 1', 'agm --kind real32 --columns a', '16777218' // nl)
      if (allocated(error)) return
      call run_shell('echo 0.1 | furiko eval --kind=real128 ellipk_m --columns m,K', output, errors, code)
      if (index(errors, 'no real128') > 0) return
      call check(error, index(output, '0.1 1.61244134872021939822991636308537'), 1)
      if (allocated(error)) return
      call expect(error, '1e-4950 -inf', 'agm --kind real128 --columns a,b', '1e-4950 -inf' // nl)
   end subroutine test_kinds


   !> The same row, however its fields stand apart
   subroutine test_separators(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: rows(*) = [character(len=24) :: '1 0.5', '  1    0.5  ', '1,0.5', &
         ' 1 ,\t 0.5 ', '1;0.5', '1 ; 0.5', '1\t0.5', '\t1 \t 0.5\t', '"1","0.5"', '"1" "0.5"', &
         '" 1 ";0.5']
      integer :: i

      do i = 1, size(rows) - 1
         call expect(error, trim(rows(i)), 'ellipf_m', '1.0832167728451687' // nl)
         if (allocated(error)) return
      end do
      call expect_refusal(error, rows(i), "line 1 column 1 ' 1 ' is not a number")
   end subroutine test_separators


   !> Fortran, C, Excel: the words for what is not finite, exponents, a byte order mark
   subroutine test_others(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: columns = 'ellipf_m --columns phi,m'

      call expect(error, 'Infinity -Infinity\nINF NAN\n-nan +inf\nNaN -inf\n', columns, &
         'inf -inf' // nl // 'inf nan' // nl // 'nan inf' // nl // 'nan -inf' // nl)
      if (allocated(error)) return
      call expect(error, '0.1-109 -1.5+120\n1E+5 1D5\n.5 5.\n+3 1d-05\n', columns, &
         '1e-110 -1.5e120' // nl // '100000 100000' // nl // '0.5 5' // nl // '3 0.00001' // nl)
      if (allocated(error)) return
      call expect(error, '\357\273\2771;"0.5"\r\n2;0.5\r\n', columns, '1 0.5' // nl // '2 0.5' // nl)
      if (allocated(error)) return
      call expect(error, '\357\273\277phi,m\r\n', columns // ' 2>&1; true', &
         'furiko eval: line 1 has names, not numbers, and no row follows' // nl)
   end subroutine test_others


   subroutine test_fields_refused(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: texts(*) = [character(len=20) :: &
         '1,,2', ',1', '1,', '1;;2', '1\t\t2', '"",1', &
         '1,5;2', '"1,5" 2', '1 2,3', '2*3 1', '1-5 2', '1 0x10', '1 2 3', '1,5;', '1 "2', &
         '1\0 2', '1\1772 3', '\3772 3', '1e400 2', '1 -1e-400', '/', '1 2/']
      character(len=*), parameter :: complaints(*) = [character(len=64) :: &
         '2 is empty', '1 is empty', '2 is empty', '2 is empty', '2 is empty', '1 is empty', &
         "1 '1,5' is not a number: decimals stand behind a point", &
         "1 '1,5' is not a number: decimals stand behind a point", &
         "1 '1 2' is not a number", "1 '2*3' is not a number", "1 '1-5' is not a number", &
         "2 '0x10' is not a number", '', "1 '1,5' is not a number: decimals stand behind a point", &
         "2 '""2' is not a number", '1 has the byte 0, which is not text', &
         '1 has the byte 127, which is not text', "1 '" // char(255) // "2' is not a number", &
         "1 '1e400' is out of the range of real64", "2 '-1e-400' is out of the range of real64", &
         "1 '/' is not a number", "2 '2/' is not a number"]
      integer :: i

      do i = 1, size(texts)
         if (complaints(i) == '') then
            call expect_refusal(error, trim(texts(i)), 'line 1 has 3 fields, but ellipf_m takes 2: phi m')
         else
            call expect_refusal(error, trim(texts(i)), 'line 1 column ' // trim(complaints(i)))
         end if
         if (allocated(error)) return
      end do
   end subroutine test_fields_refused


   !> They are answered in every format, and the bad line is named.
   subroutine test_rows_before(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: forms(*) = [character(len=4) :: 'text', 'csv', 'json']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(forms)
         call run_shell("{ printf 'm\n'; yes 0 | head -n 3000; printf 'x\n0\n'; } | furiko eval " // &
            'ellipk_m --format ' // forms(i), output, errors, code)
         call check(error, code == 2 .and. line_count(output) == 3000 + min(1, i - 1) .and. &
            errors == "furiko eval: line 3002 column 1 'x' is not a number" // nl, forms(i) // errors)
         if (allocated(error)) return
      end do
   end subroutine test_rows_before


   !> A million characters are a line, in a comment too; one more is refused, and so is no end at all.
   subroutine test_long_lines(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: ones = "head -c 999998 /dev/zero | tr '\0' 1; "
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_shell("{ printf '# '; " // ones // "printf '\n0.'; " // ones // "printf '\n0\n'; } | " // &
         'furiko eval ellipk_m', output, errors, code)
      call check(error, line_count(output) == 2 .and. errors == '' .and. code == 0, errors)
      if (allocated(error)) return
      call run_shell("{ printf '0\n0.1'; " // ones // "printf '\n0\n'; } | furiko eval ellipk_m", output, &
         errors, code)
      call check(error, errors, 'furiko eval: line 2 is longer than 1000000 characters' // nl)
      if (allocated(error)) return
      call check(error, code == 2 .and. output == '1.5707963267948966' // nl)
      if (allocated(error)) return
      call run_shell("tr '\0' 1 </dev/zero | furiko eval ellipk_m", output, errors, code)
      call check(error, errors, 'furiko eval: line 1 is longer than 1000000 characters' // nl)
   end subroutine test_long_lines


   !> Names above the numbers go above the columns that pass through; a word that may be a slip of a
   !> number is none, and neither is a second row of names.
   subroutine test_header(error)
      type(error_type), allocatable, intent(out) :: error

      call expect(error, 'phi m\n1 0.5\n', 'ellipf_m', '1.0832167728451687' // nl)
      if (allocated(error)) return
      call expect(error, '# data\n"angle/rad" par_1\n1 0.5\n', 'ellipf_m --format csv --columns m,F,phi', &
         'par_1,F,angle/rad' // nl // '0.5,1.0832167728451687,1' // nl)
      if (allocated(error)) return
      call expect_refusal(error, 'O.5 1\n1 0.5', "line 1 column 1 'O.5' is not a number")
      if (allocated(error)) return
      call expect_refusal(error, 'a b\nc d\n1 2', "line 2 column 1 'c' is not a number")
      if (allocated(error)) return
      call expect_refusal(error, 'a nan\n1 2', "line 1 column 1 'a' is not a number")
      if (allocated(error)) return
      call expect_refusal(error, 'a b c\n1 2', "line 1 column 1 'a' is not a number")
      if (allocated(error)) return
      call expect_refusal(error, 'm phi\n1 2', &
         "line 1 has the names of ellipf_m's arguments in another order than phi m")
      if (allocated(error)) return
      call expect_refusal(error, '# m\na b\n\n', 'line 2 has names, not numbers, and no row follows')
   end subroutine test_header


   subroutine test_formats(error)
      type(error_type), allocatable, intent(out) :: error

      call expect(error, '0\n1\n', 'ellipke_m --format csv', 'K,E' // nl // &
         '1.5707963267948966,1.5707963267948966' // nl // 'inf,1' // nl)
      if (allocated(error)) return
      call expect(error, '0\n1\n', 'ellipke_m --format=json', '[' // nl // &
         '{"K": 1.5707963267948966, "E": 1.5707963267948966}' // nl // ',{"K": null, "E": 1}' // nl // &
         ']' // nl)
      if (allocated(error)) return
      call expect(error, '', 'ellipke_m --format csv', 'K,E' // nl)
      if (allocated(error)) return
      call expect(error, '', 'ellipke_m --format json', '[' // nl // ']' // nl)
   end subroutine test_formats


   subroutine test_columns(error)
      type(error_type), allocatable, intent(out) :: error

      call expect(error, '0 0.5\n', 'jacobi_m --columns dn,u,m,sn', '1 0 0.5 0' // nl)
      if (allocated(error)) return
      call expect(error, '0 0.5\n', 'jacobi_m --columns m --format json', '[' // nl // '{"m": 0.5}' // nl // &
         ']' // nl)
   end subroutine test_columns


   !> What it writes it reads: the columns that pass through come back as they were.
   subroutine test_own(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: rows = "printf '1e-300 -0\n0.1 5e-324\ninf nan\n-inf 1e22\n' |"
      character(len=*), parameter :: again = ' furiko eval ellipf_m --format csv --columns phi,m'
      character(len=:), allocatable :: errors, output, twice
      integer :: code

      call run_shell(rows // again, output, errors, code)
      call run_shell(rows // again // ' |' // again, twice, errors, code)
      call check(error, twice, output)
      if (allocated(error)) return
      call check(error, output, 'phi,m' // nl // '1e-300,-0' // nl // '0.1,5e-324' // nl // 'inf,nan' // &
         nl // '-inf,1e22' // nl)
   end subroutine test_own


   !> To the bit what the library gives for arrays
   subroutine test_arrays(error)
      type(error_type), allocatable, intent(out) :: error
      integer, parameter :: rows = 2500
      character(len=:), allocatable :: errors, output
      real(wp) :: x(rows, 2), y(rows, 3), answers(3, rows)
      integer :: code, i, unit

      call random_number(x)
      x(:, 1) = 20*x(:, 1)
      call run_shell('mkdir -p ' // work(), output, errors, code)
      open(newunit=unit, file=work() // '/eval.in', action='write')
      write(unit, '(es25.17e3, " ", es25.17e3)') (x(i, :), i=1, rows)
      close(unit)
      call run_shell('furiko eval jacobi_m <' // work() // '/eval.in', output, errors, code)
      call evaluate('jacobi_m', x, y)
      call check(error, line_count(output), rows)
      if (allocated(error)) return
      ! To `read`, the end of a line in the midst of a text is no blank.
      do i = 1, len(output)
         if (output(i:i) == nl) output(i:i) = ' '
      end do
      read(output, *) answers
      call check(error, .not. any(abs(transpose(answers) - y) > 0.0_wp))
   end subroutine test_arrays


   !> Pieces of 7 bytes, a few at a time
   subroutine test_chunks(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output, whole
      integer :: code

      call run_shell('seq 0 0.001 0.999 | furiko eval ellipk_m', whole, errors, code)
      call run_shell('seq 0 0.001 0.999 | dd bs=7 2>/dev/null | furiko eval ellipk_m', output, errors, code)
      call check(error, line_count(whole) == 1000 .and. whole == output)
   end subroutine test_chunks


   !> The answer is there before the next row comes.
   subroutine test_at_once(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_inside('mkfifo pipe; ' // &
         'furiko eval ellipk_m <pipe | { read -r line; echo first $line >&2; >answered; cat; } & ' // &
         'exec 3>pipe; echo 0 >&3; for i in $(seq 200); do test -e answered && break; sleep 0.1; done; ' // &
         'rm answered; echo second >&2; echo 0.5 >&3; exec 3>&-; wait', &
         output, errors, code)
      call check(error, errors, 'first 1.5707963267948966' // nl // 'second' // nl)
      if (allocated(error)) return
      call check(error, output, '1.8540746773013719' // nl // 'pipe' // nl)
   end subroutine test_at_once


   !> As little for half a million rows as for one
   subroutine test_memory(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_shell('yes 0.5 | head -n 500000 | { ulimit -v 40000; furiko eval ellipk_m; } | uniq -c', &
         output, errors, code)
      call check(error, errors, '')
      if (allocated(error)) return
      call check(error, adjustl(output), '500000 1.8540746773013719' // nl)
   end subroutine test_memory


   !> A closed input, a folder
   subroutine test_no_input(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: commands(*) = [character(len=24) :: 'eval ellipk_m <&-', &
         'eval ellipk_m </']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(commands)
         call run_program(trim(commands(i)), output, errors, code)
         call check(error, code == 2 .and. output == '' .and. line_count(errors) == 1 .and. &
            index(errors, 'furiko: cannot read standard input: ') == 1, commands(i))
         if (allocated(error)) return
      end do
   end subroutine test_no_input


   !> A full disk, a closed output, a reader that leaves
   subroutine test_no_output(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: outputs(*) = [character(len=10) :: '>/dev/full', '>&-']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(outputs)
         call run_shell('echo 0 | furiko eval ellipk_m ' // outputs(i), output, errors, code)
         call check(error, code == 1 .and. line_count(errors) == 1 .and. &
            index(errors, 'furiko: cannot write the output: ') == 1, outputs(i))
         if (allocated(error)) return
      end do
      call run_shell('{ yes 0 | furiko eval ellipk_m && echo fine >&2; } | head -n 1', output, errors, code)
      call check(error, line_count(output) == 1 .and. index(errors, 'fine') == 0 .and. &
         line_count(errors) <= 1)
   end subroutine test_no_output


   subroutine test_commands_refused(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: commands(*) = [character(len=40) :: 'nosuch', '', '--kind', &
         'ellipk_m --kind real16', 'ellipk_m ellipk_k', '--nosuch', 'ellipk_m --format xml', &
         'ellipk_m --columns=', 'ellipk_m --columns k', 'ellipk_m --columns K,m,K', 'ellipk_m --columns m,,K']
      character(len=:), allocatable :: errors, output
      integer :: code, i

      do i = 1, size(commands)
         call run_shell('echo 0 | furiko eval ' // trim(commands(i)), output, errors, code)
         call check(error, code == 2 .and. output == '' .and. line_count(errors) == 1, commands(i))
         if (allocated(error)) return
      end do
   end subroutine test_commands_refused


   !> The list to the byte, and each name of it answers a row of arguments
   subroutine test_list(error)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: errors, output
      integer :: code

      call run_program('eval --list', output, errors, code)
      call check(error, output, contents('test/data/list.txt'))
      if (allocated(error)) return
      call run_shell('tail -n +2 test/data/names.dat | while read -r name arguments results rest; do ' // &
         'echo $rest | cut -d" " -f1-$arguments | furiko eval $name || echo $name >&2; ' // &
         'done', output, errors, code)
      call check(error, errors, '')
      if (allocated(error)) return
      call check(error, line_count(output) == 2*line_count(contents('test/data/list.txt')) .and. &
         index(output, 'nan') == 0, output)
   end subroutine test_list

end module test_eval
