! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

!> All tests, or one suite, or one test of it: fpm test -- [SUITE [TEST]]; or the accuracy report:
!> fpm test -- report FILE; or all functions at random bits, for so many seconds, by a seed:
!> fpm test -- fuzz [SECONDS [SEED]]
program main
   use, intrinsic :: iso_c_binding, only : c_int
   use, intrinsic :: iso_fortran_env, only : error_unit, output_unit
   use test_accuracy, only : collect_accuracy, write_report
   use test_animate, only : collect_animate
   use test_catalogue, only : collect_catalogue
   use test_classics_dp, only : collect_classics_dp => collect_classics
#ifdef FURIKO_REAL128
   use test_classics_qp, only : collect_classics_qp => collect_classics
#endif
   use test_classics_sp, only : collect_classics_sp => collect_classics
   use test_cli, only : collect_cli
   use test_complete_dp, only : collect_complete_dp => collect_complete
#ifdef FURIKO_REAL128
   use test_complete_qp, only : collect_complete_qp => collect_complete
#endif
   use test_complete_sp, only : collect_complete_sp => collect_complete
   use test_driven, only : collect_driven
   use test_edges, only : collect_edges
   use test_eval, only : collect_eval
   use test_fgsl, only : collect_fgsl
   use test_files, only : collect_files
   use test_chance, only : seed_chance
   use test_fuzz_dp, only : collect_fuzz_dp => collect_fuzz, fuzz_dp => fuzz
#ifdef FURIKO_REAL128
   use test_fuzz_qp, only : collect_fuzz_qp => collect_fuzz, fuzz_qp => fuzz
#endif
   use test_fuzz_sp, only : collect_fuzz_sp => collect_fuzz, fuzz_sp => fuzz
   use test_incomplete_dp, only : collect_incomplete_dp => collect_incomplete
#ifdef FURIKO_REAL128
   use test_incomplete_qp, only : collect_incomplete_qp => collect_incomplete
#endif
   use test_incomplete_sp, only : collect_incomplete_sp => collect_incomplete
   use test_integrators_dp, only : collect_integrators_dp => collect_integrators
#ifdef FURIKO_REAL128
   use test_integrators_qp, only : collect_integrators_qp => collect_integrators
#endif
   use test_integrators_sp, only : collect_integrators_sp => collect_integrators
   use test_jacobi_dp, only : collect_jacobi_dp => collect_jacobi
#ifdef FURIKO_REAL128
   use test_jacobi_qp, only : collect_jacobi_qp => collect_jacobi
#endif
   use test_jacobi_sp, only : collect_jacobi_sp => collect_jacobi
   use test_known_values, only : collect_known_values
   use test_motion_dp, only : collect_motion_dp => collect_motion
#ifdef FURIKO_REAL128
   use test_motion_qp, only : collect_motion_qp => collect_motion
#endif
   use test_motion_sp, only : collect_motion_sp => collect_motion
   use test_nome_dp, only : collect_nome_dp => collect_nome
#ifdef FURIKO_REAL128
   use test_nome_qp, only : collect_nome_qp => collect_nome
#endif
   use test_nome_sp, only : collect_nome_sp => collect_nome
   use test_notes, only : collect_notes
   use test_pendulum_cli, only : collect_pendulum_cli
   use test_number, only : collect_number
   use test_plot, only : collect_plot
   use test_rounding, only : collect_rounding
   use test_second_inverse_dp, only : collect_second_inverse_dp => collect_second_inverse
#ifdef FURIKO_REAL128
   use test_second_inverse_qp, only : collect_second_inverse_qp => collect_second_inverse
#endif
   use test_second_inverse_sp, only : collect_second_inverse_sp => collect_second_inverse
   use test_special_dp, only : collect_special_dp => collect_special
#ifdef FURIKO_REAL128
   use test_special_qp, only : collect_special_qp => collect_special
#endif
   use test_special_sp, only : collect_special_sp => collect_special
   use test_table, only : collect_table
   use test_word_arithmetic, only : collect_word_arithmetic
   use testdrive, only : error_type, get_argument, get_variable, new_testsuite, testsuite_type, &
      unittest_type
   implicit none
   interface
      !> C's exit: `error stop` prints a backtrace, and `stop` its code and the flags that are raised
      subroutine c_exit(code) bind(c, name='exit')
         import :: c_int
         implicit none
         integer(c_int), value :: code
      end subroutine c_exit
   end interface
   !> What skip_test leaves in an error's stat
   integer, parameter :: skip = 77
   type(testsuite_type), allocatable :: suites(:)
   type(unittest_type), allocatable :: tests(:)
   !> What failed, a line each: the end of a long log is what one sees
   character(len=:), allocatable :: failures
   character(len=:), allocatable :: folder, suite, test
   integer :: failed, i, j, passed, skipped

   suites = [ &
      new_testsuite('known-values', collect_known_values), &
      new_testsuite('table', collect_table), &
      new_testsuite('catalogue', collect_catalogue), &
      new_testsuite('number', collect_number), &
      new_testsuite('cli', collect_cli), &
      new_testsuite('eval', collect_eval), &
      new_testsuite('files', collect_files), &
      new_testsuite('pendulum-cli', collect_pendulum_cli), &
      new_testsuite('plot', collect_plot), &
      new_testsuite('notes', collect_notes), &
      new_testsuite('animate', collect_animate), &
      new_testsuite('word-arithmetic', collect_word_arithmetic), &
      new_testsuite('complete-real32', collect_complete_sp), &
      new_testsuite('complete-real64', collect_complete_dp), &
      new_testsuite('rounding', collect_rounding), &
      new_testsuite('incomplete-real32', collect_incomplete_sp), &
      new_testsuite('incomplete-real64', collect_incomplete_dp), &
      new_testsuite('classics-real32', collect_classics_sp), &
      new_testsuite('classics-real64', collect_classics_dp), &
      new_testsuite('integrators-real32', collect_integrators_sp), &
      new_testsuite('integrators-real64', collect_integrators_dp), &
      new_testsuite('jacobi-real32', collect_jacobi_sp), &
      new_testsuite('jacobi-real64', collect_jacobi_dp), &
      new_testsuite('motion-real32', collect_motion_sp), &
      new_testsuite('motion-real64', collect_motion_dp), &
      new_testsuite('nome-real32', collect_nome_sp), &
      new_testsuite('nome-real64', collect_nome_dp), &
      new_testsuite('second-inverse-real32', collect_second_inverse_sp), &
      new_testsuite('second-inverse-real64', collect_second_inverse_dp), &
      new_testsuite('special-real32', collect_special_sp), &
      new_testsuite('special-real64', collect_special_dp), &
      new_testsuite('fuzz-real32', collect_fuzz_sp), &
      new_testsuite('fuzz-real64', collect_fuzz_dp), &
      new_testsuite('driven', collect_driven), &
      new_testsuite('edges', collect_edges), &
      new_testsuite('accuracy', collect_accuracy), &
      new_testsuite('fgsl', collect_fgsl)]
#ifdef FURIKO_REAL128
   suites = [suites, new_testsuite('complete-real128', collect_complete_qp), &
      new_testsuite('incomplete-real128', collect_incomplete_qp), &
      new_testsuite('second-inverse-real128', collect_second_inverse_qp), &
      new_testsuite('classics-real128', collect_classics_qp), &
      new_testsuite('integrators-real128', collect_integrators_qp), &
      new_testsuite('jacobi-real128', collect_jacobi_qp), &
      new_testsuite('nome-real128', collect_nome_qp), &
      new_testsuite('special-real128', collect_special_qp), &
      new_testsuite('fuzz-real128', collect_fuzz_qp), &
      new_testsuite('motion-real128', collect_motion_qp)]
#endif

   call get_argument(1, suite)
   call get_argument(2, test)
   if (allocated(suite) .and. allocated(test)) then
      if (suite == 'report') then
         ! A file is named from where the user stands: with ./fpmw that is not here.
         call get_variable('FPMW_FROM', folder)
         if (allocated(folder) .and. index(test, '/') /= 1) test = folder // '/' // test
         call write_report(test)
         stop
      end if
   end if

   if (allocated(suite)) then
      if (suite == 'fuzz') call fuzz_for_a_while()
   end if

   passed = 0
   failed = 0
   failures = ''
   skipped = 0
   do i = 1, size(suites)
      if (allocated(suite)) then
         if (suites(i)%name /= suite) cycle
      end if
      write(error_unit, '(2a)') '# ', suites(i)%name
      call suites(i)%collect(tests)
      do j = 1, size(tests)
         if (allocated(test)) then
            if (tests(j)%name /= test) cycle
         end if
         write(error_unit, '(3a, 2(i0, a))') '  Starting ', tests(j)%name, ' ... (', j, '/', size(tests), ')'
         call run(suites(i)%name, tests(j))
      end do
   end do
   if (passed + failed + skipped == 0) call refuse()

   write(output_unit, '(a)', advance='no') failures
   write(output_unit, '(3(i0, a))') passed, ' passed, ', failed, ' failed, ', skipped, ' skipped'
   if (failed > 0) call fail()


contains


   !> Run a test, as test-drive's run_testsuite does, which does not tell how many were skipped.
   subroutine run(suite, test)
      character(len=*), intent(in) :: suite
      type(unittest_type), intent(in) :: test
      type(error_type), allocatable :: error
      character(len=:), allocatable :: message, verdict

      ! The same numbers by chance in every run, and whatever ran before
      call seed_chance(1)
      call test%test(error)
      message = ''
      if (.not. allocated(error)) then
         verdict = trim(merge('UNEXPECTED PASS', 'PASSED         ', test%should_fail))
      else
         verdict = trim(merge('EXPECTED FAIL', 'FAILED       ', test%should_fail))
         if (error%stat == skip) verdict = 'SKIPPED'
         if (allocated(error%message)) message = new_line('a') // '  Message: ' // error%message
         ! test-drive stops the program where a failure is forgotten; this one has been read.
         error%stat = 0
      end if
      select case (verdict)
      case ('SKIPPED')
         skipped = skipped + 1
      case ('PASSED', 'EXPECTED FAIL')
         passed = passed + 1
      case default
         failed = failed + 1
         failures = failures // suite // ' ' // test%name // message // new_line('a')
      end select
      write(error_unit, '(6a)') '       ... ', test%name, ' [', verdict, ']', message
      flush(error_unit)
   end subroutine run


   !> All functions at random bits until time is up, after which nothing is left to do.
   subroutine fuzz_for_a_while()
      character(len=:), allocatable :: word
      integer :: broken, first, now, per_second, seconds, seed, tried(3)

      seconds = 60
      seed = 7
      if (allocated(test)) read(test, *) seconds
      call get_argument(3, word)
      if (allocated(word)) read(word, *) seed
      call seed_chance(seed)
      tried = 0
      broken = 0
      call system_clock(first, per_second)
      do
         call fuzz_sp(tried(1), broken)
         call fuzz_dp(tried(2), broken)
#ifdef FURIKO_REAL128
         call fuzz_qp(tried(3), broken)
#endif
         call system_clock(now)
         if ((now - first)/per_second >= seconds) exit
      end do
      write(output_unit, '(4(i0, a))') tried(1), ' rows of arguments in real32, ', tried(2), ' in real64, ', &
         tried(3), ' in real128; ', broken, ' faults'
      if (broken > 0) call fail()
      flush(output_unit)
      call c_exit(0_c_int)
   end subroutine fuzz_for_a_while


   !> Say in a line that there is no such suite, or no such test in it, and which there are, and stop.
   subroutine refuse()
      character(len=:), allocatable :: line

      line = 'no suite ' // suite // '; there are'
      do i = 1, size(suites)
         if (suites(i)%name == suite) exit
         line = line // ' ' // suites(i)%name
      end do
      if (i <= size(suites)) then
         line = 'no test'
         if (allocated(test)) line = line // ' ' // test
         line = line // ' in the suite ' // suite // '; there are'
         call suites(i)%collect(tests)
         do j = 1, size(tests)
            line = line // ' ' // tests(j)%name
         end do
      end if
      write(error_unit, '(2a)') 'test: ', line
      call fail()
   end subroutine refuse


   subroutine fail()
      flush(output_unit)
      flush(error_unit)
      call c_exit(1_c_int)
   end subroutine fail

end program main
! rooms: 3759241635
