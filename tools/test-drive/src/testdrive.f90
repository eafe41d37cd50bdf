! SPDX-License-Identifier: MIT

!> furiko's offline stand-in for fortran-lang/test-drive v0.6.1.
!>
!> A test reports through `error`: unallocated means passed. The caller counts:
!>
!>     testsuites = [new_testsuite("agm", collect_agm), new_testsuite("jacobi", collect_jacobi)]
!>     do is = 1, size(testsuites)
!>        call run_testsuite(testsuites(is)%collect, error_unit, stat)
!>     end do
!>     if (stat > 0) error stop 1
module testdrive
   use, intrinsic :: iso_fortran_env, only : error_unit, i1 => int8, i2 => int16, i4 => int32, &
      i8 => int64, sp => real32, dp => real64
   implicit none
   private

   public :: error_type, unittest_type, testsuite_type, test_interface, collect_interface
   public :: new_unittest, new_testsuite, select_test, select_suite, run_testsuite, run_selected
   public :: check, test_failed, skip_test, to_string, get_argument, get_variable

   integer, parameter :: success = 0, fatal = 1, skipped = 77
   integer(i8), parameter :: infinity = ishft(2047_i8, 52)
   character(len=*), parameter :: mismatch = "Floating point value mismatch"
   character(len=*), parameter :: next_line = new_line("a")//repeat(" ", 11)

   !> Failure (or skip) of a test; one that is lost unread stops the program
   type :: error_type
      !> 0 success, 77 skipped, else failed
      integer :: stat = success
      !> What went wrong
      character(len=:), allocatable :: message
   contains
      final :: escalate
   end type error_type

   !> A named test; with `should_fail` it passes when it reports a failure
   type :: unittest_type
      character(len=:), allocatable :: name
      procedure(test_interface), pointer, nopass :: test => null()
      logical :: should_fail = .false.
   end type unittest_type

   !> A named collection of tests
   type :: testsuite_type
      character(len=:), allocatable :: name
      procedure(collect_interface), pointer, nopass :: collect => null()
   end type testsuite_type

   abstract interface
      !> A test
      subroutine test_interface(error)
         import :: error_type
         implicit none
         type(error_type), allocatable, intent(out) :: error
      end subroutine test_interface

      !> Lists the tests of a suite
      subroutine collect_interface(testsuite)
         import :: unittest_type
         implicit none
         type(unittest_type), allocatable, intent(out) :: testsuite(:)
      end subroutine collect_interface
   end interface

   !> Sets `error` unless
   !>
   !> - `check(error, stat)`: stat is 0; `check(error, condition)`: condition is true;
   !> - `check(error, x)`: the real or complex x is not NaN;
   !> - `check(error, actual, expected)`: integers, logicals or strings agree;
   !> - `check(error, actual, expected, thr=, rel=)`: numbers differ by at most `thr` or epsilon,
   !>   relative to `expected` if `rel`; NaN never matches, an infinity only itself;
   !> - `check(error, actual, expected, thr_abs, thr_rel)`: the laxer of both bounds holds.
   !>
   !> `message` replaces the report, `more` adds a line to it. The first failure in `error` is kept.
   interface check
      module procedure :: check_stat, check_logical, check_bool, check_string
      module procedure :: check_int_i1, check_int_i2, check_int_i4, check_int_i8
      module procedure :: check_number_sp, check_number_dp, check_number_csp, check_number_cdp
      module procedure :: check_real_sp, check_real_dp, check_complex_sp, check_complex_dp
      module procedure :: check_absrel_sp, check_absrel_dp
   end interface check

   !> A number as text without blanks around it
   interface to_string
      module procedure :: string_i1, string_i2, string_i4, string_i8
      module procedure :: string_sp, string_dp, string_csp, string_cdp
   end interface to_string

contains

   !> Run all tests of a suite and add the failures to `stat`
   recursive subroutine run_testsuite(collect, unit, stat, parallel)
      procedure(collect_interface) :: collect
      integer, intent(in) :: unit
      integer, intent(inout) :: stat
      logical, intent(in), optional :: parallel
      type(unittest_type), allocatable :: testsuite(:)
      logical :: threads
      integer :: it, total

      threads = .true.
      if (present(parallel)) threads = parallel
      allocate(testsuite(0))
      call collect(testsuite)
      total = size(testsuite)
      !$omp parallel do schedule(dynamic) reduction(+:stat) if (threads)
      do it = 1, size(testsuite)
         call show(unit, "  Starting "//testsuite(it)%name// &
            " ... ("//to_string(it)//"/"//to_string(total)//")")
         call run_unittest(testsuite(it), unit, stat)
      end do
   end subroutine run_testsuite

   !> Run one test by name and add its failure to `stat`; an unknown name makes `stat` negative
   recursive subroutine run_selected(collect, name, unit, stat)
      procedure(collect_interface) :: collect
      character(len=*), intent(in) :: name
      integer, intent(in) :: unit
      integer, intent(inout) :: stat
      type(unittest_type), allocatable :: testsuite(:)
      integer :: it

      allocate(testsuite(0))
      call collect(testsuite)
      it = select_test(testsuite, name)
      if (it > 0) then
         call run_unittest(testsuite(it), unit, stat)
      else
         call show(unit, "  Available tests:")
         do it = 1, size(testsuite)
            call show(unit, "  - "//testsuite(it)%name)
         end do
         stat = -huge(stat)
      end if
   end subroutine run_selected

   !> Run a test, show its verdict and count a failure
   recursive subroutine run_unittest(test, unit, stat)
      type(unittest_type), intent(in) :: test
      integer, intent(in) :: unit
      integer, intent(inout) :: stat
      type(error_type), allocatable :: error
      character(len=:), allocatable :: verdict, message

      message = ""
      call test%test(error)
      verdict = merge("UNEXPECTED PASS", "PASSED         ", test%should_fail)
      if (allocated(error)) then
         verdict = merge("EXPECTED FAIL", "FAILED       ", test%should_fail)
         if (error%stat == skipped) verdict = "SKIPPED"
         message = new_line("a")//"  Message:"
         if (allocated(error%message)) message = message//" "//error%message
         error%stat = success
      end if
      if (any(verdict == ["FAILED         ", "UNEXPECTED PASS"])) stat = stat + 1
      call show(unit, "       ... "//test%name//" ["//trim(verdict)//"]"//message)
   end subroutine run_unittest

   !> Write a line at once, whole even from threads
   subroutine show(unit, line)
      integer, intent(in) :: unit
      character(len=*), intent(in) :: line
      !$omp critical(testdrive_show)
      write(unit, '(a)') line
      flush(unit)
      !$omp end critical(testdrive_show)
   end subroutine show

   !> Position of the test with this name, 0 if there is none
   function select_test(tests, name) result(pos)
      type(unittest_type), intent(in) :: tests(:)
      character(len=*), intent(in) :: name
      integer :: pos
      do pos = 1, size(tests)
         if (tests(pos)%name == name) return
      end do
      pos = 0
   end function select_test

   !> Position of the suite with this name, 0 if there is none
   function select_suite(suites, name) result(pos)
      type(testsuite_type), intent(in) :: suites(:)
      character(len=*), intent(in) :: name
      integer :: pos
      do pos = 1, size(suites)
         if (suites(pos)%name == name) return
      end do
      pos = 0
   end function select_suite

   !> A test for the list of a suite
   function new_unittest(name, test, should_fail) result(self)
      character(len=*), intent(in) :: name
      procedure(test_interface) :: test
      logical, intent(in), optional :: should_fail
      type(unittest_type) :: self
      self%name = name
      self%test => test
      if (present(should_fail)) self%should_fail = should_fail
   end function new_unittest

   !> A suite for the list of a test program
   function new_testsuite(name, collect) result(self)
      character(len=*), intent(in) :: name
      procedure(collect_interface) :: collect
      type(testsuite_type) :: self
      self%name = name
      self%collect => collect
   end function new_testsuite

   !> Report a failure; an earlier failure stays, a skip gives way
   subroutine test_failed(error, message, more, and_more)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: message
      character(len=*), intent(in), optional :: more, and_more
      call report(error, fatal, message, more, and_more)
   end subroutine test_failed

   !> Leave a test without a verdict, for lack of something it needs
   subroutine skip_test(error, message, more, and_more)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: message
      character(len=*), intent(in), optional :: more, and_more
      call report(error, skipped, message, more, and_more)
   end subroutine skip_test

   !> Fill `error` unless it holds a failure already
   subroutine report(error, stat, message, more, and_more)
      type(error_type), allocatable, intent(inout) :: error
      integer, intent(in) :: stat
      character(len=*), intent(in) :: message
      character(len=*), intent(in), optional :: more, and_more
      if (.not. allocated(error)) allocate(error)
      if (all(error%stat /= [success, skipped])) return
      error%stat = stat
      error%message = message
      if (present(more)) error%message = error%message//next_line//more
      if (present(and_more)) error%message = error%message//next_line//and_more
   end subroutine report

   !> Report a failed check in the caller's words or else in ours
   subroutine reject(error, message, more, what, detail)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in), optional :: message, more
      character(len=*), intent(in) :: what
      character(len=*), intent(in), optional :: detail
      if (present(message)) then
         call test_failed(error, message, more)
      else
         call test_failed(error, what, detail, more)
      end if
   end subroutine reject

   !> Stop loudly when a failure is about to be forgotten
   subroutine escalate(error)
      type(error_type), intent(inout) :: error
      if (error%stat == success) return
      write(error_unit, '(a, 1x, i0)') "[Fatal] Uncaught error, code", error%stat
      if (allocated(error%message)) write(error_unit, '(a)') error%message
      error stop 1
   end subroutine escalate

   subroutine check_stat(error, stat, message, more)
      type(error_type), allocatable, intent(inout) :: error
      integer, intent(in) :: stat
      character(len=*), intent(in), optional :: message, more
      if (stat /= success) call reject(error, message, more, "Nonzero status "//to_string(stat))
   end subroutine check_stat

   subroutine check_logical(error, expression, message, more)
      type(error_type), allocatable, intent(inout) :: error
      logical, intent(in) :: expression
      character(len=*), intent(in), optional :: message, more
      if (.not. expression) call reject(error, message, more, "Condition not fulfilled")
   end subroutine check_logical

   subroutine check_bool(error, actual, expected, message, more)
      type(error_type), allocatable, intent(inout) :: error
      logical, intent(in) :: actual, expected
      character(len=*), intent(in), optional :: message, more
      if (actual .neqv. expected) call reject(error, message, more, "Logical value mismatch", &
         "expected "//merge("T", "F", expected)//" but got "//merge("T", "F", actual))
   end subroutine check_bool

   subroutine check_string(error, actual, expected, message, more)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: actual, expected
      character(len=*), intent(in), optional :: message, more
      if (actual /= expected) call reject(error, message, more, "Character value mismatch", &
         "expected '"//expected//"' but got '"//actual//"'")
   end subroutine check_string

   subroutine check_int_i1(error, actual, expected, message, more)
      type(error_type), allocatable, intent(inout) :: error
      integer(i1), intent(in) :: actual, expected
      character(len=*), intent(in), optional :: message, more
      call check(error, int(actual, i8), int(expected, i8), message, more)
   end subroutine check_int_i1

   subroutine check_int_i2(error, actual, expected, message, more)
      type(error_type), allocatable, intent(inout) :: error
      integer(i2), intent(in) :: actual, expected
      character(len=*), intent(in), optional :: message, more
      call check(error, int(actual, i8), int(expected, i8), message, more)
   end subroutine check_int_i2

   subroutine check_int_i4(error, actual, expected, message, more)
      type(error_type), allocatable, intent(inout) :: error
      integer(i4), intent(in) :: actual, expected
      character(len=*), intent(in), optional :: message, more
      call check(error, int(actual, i8), int(expected, i8), message, more)
   end subroutine check_int_i4

   subroutine check_int_i8(error, actual, expected, message, more)
      type(error_type), allocatable, intent(inout) :: error
      integer(i8), intent(in) :: actual, expected
      character(len=*), intent(in), optional :: message, more
      if (actual /= expected) call reject(error, message, more, "Integer value mismatch", &
         "expected "//to_string(expected)//" but got "//to_string(actual))
   end subroutine check_int_i8

   subroutine check_number_sp(error, actual, message, more)
      type(error_type), allocatable, intent(inout) :: error
      real(sp), intent(in) :: actual
      character(len=*), intent(in), optional :: message, more
      call check(error, real(actual, dp), message, more)
   end subroutine check_number_sp

   subroutine check_number_dp(error, actual, message, more)
      type(error_type), allocatable, intent(inout) :: error
      real(dp), intent(in) :: actual
      character(len=*), intent(in), optional :: message, more
      if (is_nan(actual)) call reject(error, message, more, "Unexpected NaN")
   end subroutine check_number_dp

   subroutine check_number_csp(error, actual, message, more)
      type(error_type), allocatable, intent(inout) :: error
      complex(sp), intent(in) :: actual
      character(len=*), intent(in), optional :: message, more
      call check(error, cmplx(actual, kind=dp), message, more)
   end subroutine check_number_csp

   subroutine check_number_cdp(error, actual, message, more)
      type(error_type), allocatable, intent(inout) :: error
      complex(dp), intent(in) :: actual
      character(len=*), intent(in), optional :: message, more
      call check(error, merge(real(actual), aimag(actual), is_nan(real(actual))), message, more)
   end subroutine check_number_cdp

   subroutine check_real_sp(error, actual, expected, message, more, thr, rel)
      type(error_type), allocatable, intent(inout) :: error
      real(sp), intent(in) :: actual, expected
      character(len=*), intent(in), optional :: message, more
      real(sp), intent(in), optional :: thr
      logical, intent(in), optional :: rel
      real(sp) :: off, allowed
      allowed = epsilon(allowed)
      if (present(thr)) allowed = thr
      off = real(gap(real(actual, dp), real(expected, dp)), sp)
      if (chosen(rel) .and. off > 0) off = off/abs(expected)
      if (within(real(off, dp), real(allowed, dp))) return
      call reject(error, message, more, mismatch, differ(to_string(actual), &
         to_string(expected), to_string(off), to_string(allowed), chosen(rel)))
   end subroutine check_real_sp

   subroutine check_real_dp(error, actual, expected, message, more, thr, rel)
      type(error_type), allocatable, intent(inout) :: error
      real(dp), intent(in) :: actual, expected
      character(len=*), intent(in), optional :: message, more
      real(dp), intent(in), optional :: thr
      logical, intent(in), optional :: rel
      real(dp) :: off, allowed
      allowed = epsilon(allowed)
      if (present(thr)) allowed = thr
      off = gap(actual, expected)
      if (chosen(rel) .and. off > 0) off = off/abs(expected)
      if (within(off, allowed)) return
      call reject(error, message, more, mismatch, differ(to_string(actual), &
         to_string(expected), to_string(off), to_string(allowed), chosen(rel)))
   end subroutine check_real_dp

   subroutine check_complex_sp(error, actual, expected, message, more, thr, rel)
      type(error_type), allocatable, intent(inout) :: error
      complex(sp), intent(in) :: actual, expected
      character(len=*), intent(in), optional :: message, more
      real(sp), intent(in), optional :: thr
      logical, intent(in), optional :: rel
      real(sp) :: allowed
      allowed = epsilon(allowed)
      if (present(thr)) allowed = thr
      call check(error, cmplx(actual, kind=dp), cmplx(expected, kind=dp), message, more, &
         real(allowed, dp), rel)
   end subroutine check_complex_sp

   subroutine check_complex_dp(error, actual, expected, message, more, thr, rel)
      type(error_type), allocatable, intent(inout) :: error
      complex(dp), intent(in) :: actual, expected
      character(len=*), intent(in), optional :: message, more
      real(dp), intent(in), optional :: thr
      logical, intent(in), optional :: rel
      real(dp) :: off, allowed
      allowed = epsilon(allowed)
      if (present(thr)) allowed = thr
      off = hypot(gap(real(actual), real(expected)), gap(aimag(actual), aimag(expected)))
      if (chosen(rel) .and. off > 0) off = off/abs(expected)
      if (within(off, allowed)) return
      call reject(error, message, more, mismatch, differ(to_string(actual), &
         to_string(expected), to_string(off), to_string(allowed), chosen(rel)))
   end subroutine check_complex_dp

   subroutine check_absrel_sp(error, actual, expected, thr_abs, thr_rel, message, more)
      type(error_type), allocatable, intent(inout) :: error
      real(sp), intent(in) :: actual, expected, thr_abs, thr_rel
      character(len=*), intent(in), optional :: message, more
      call check(error, actual, expected, message, more, max(thr_abs, abs(thr_rel*expected)))
   end subroutine check_absrel_sp

   subroutine check_absrel_dp(error, actual, expected, thr_abs, thr_rel, message, more)
      type(error_type), allocatable, intent(inout) :: error
      real(dp), intent(in) :: actual, expected, thr_abs, thr_rel
      character(len=*), intent(in), optional :: message, more
      call check(error, actual, expected, message, more, max(thr_abs, abs(thr_rel*expected)))
   end subroutine check_absrel_dp

   !> Distance of two reals: 0 between equal infinities, NaN if either is NaN
   elemental function gap(actual, expected)
      real(dp), intent(in) :: actual, expected
      real(dp) :: gap
      gap = 0
      if (is_nan(actual) .or. bits(actual) /= bits(expected)) gap = abs(actual - expected)
   end function gap

   !> The finite deviation `off` is allowed; NaN and infinity never are
   elemental function within(off, allowed) result(ok)
      real(dp), intent(in) :: off, allowed
      logical :: ok
      ok = ibclr(bits(off), 63) < infinity .and. off <= allowed
   end function within

   elemental function is_nan(x) result(nan)
      real(dp), intent(in) :: x
      logical :: nan
      nan = ibclr(bits(x), 63) > infinity
   end function is_nan

   !> Without the sign the bits order numbers, infinity, NaN, and no -ffast-math folds that away
   elemental function bits(x)
      real(dp), intent(in) :: x
      integer(i8) :: bits
      bits = transfer(x, bits)
   end function bits

   !> An optional switch, off by default
   pure function chosen(switch) result(on)
      logical, intent(in), optional :: switch
      logical :: on
      on = .false.
      if (present(switch)) on = switch
   end function chosen

   pure function differ(actual, expected, off, allowed, rel) result(text)
      character(len=*), intent(in) :: actual, expected, off, allowed
      logical, intent(in) :: rel
      character(len=:), allocatable :: text
      text = "difference: "//off//", allowed: "//allowed//")"
      if (rel) text = "relative "//text
      text = "expected "//expected//" but got "//actual//" ("//text
   end function differ

   pure function string_i1(val) result(string)
      integer(i1), intent(in) :: val
      character(len=:), allocatable :: string
      string = to_string(int(val, i8))
   end function string_i1

   pure function string_i2(val) result(string)
      integer(i2), intent(in) :: val
      character(len=:), allocatable :: string
      string = to_string(int(val, i8))
   end function string_i2

   pure function string_i4(val) result(string)
      integer(i4), intent(in) :: val
      character(len=:), allocatable :: string
      string = to_string(int(val, i8))
   end function string_i4

   pure function string_i8(val) result(string)
      integer(i8), intent(in) :: val
      character(len=:), allocatable :: string
      character(len=20) :: buffer
      write(buffer, '(i0)') val
      string = trim(buffer)
   end function string_i8

   pure function string_sp(val) result(string)
      real(sp), intent(in) :: val
      character(len=:), allocatable :: string
      character(len=64) :: buffer
      write(buffer, '(g0)') val
      string = trim(adjustl(buffer))
   end function string_sp

   pure function string_dp(val) result(string)
      real(dp), intent(in) :: val
      character(len=:), allocatable :: string
      character(len=64) :: buffer
      write(buffer, '(g0)') val
      string = trim(adjustl(buffer))
   end function string_dp

   pure function string_csp(val) result(string)
      complex(sp), intent(in) :: val
      character(len=:), allocatable :: string
      string = "("//to_string(real(val))//", "//to_string(aimag(val))//")"
   end function string_csp

   pure function string_cdp(val) result(string)
      complex(dp), intent(in) :: val
      character(len=:), allocatable :: string
      string = "("//to_string(real(val))//", "//to_string(aimag(val))//")"
   end function string_cdp

   !> Command line argument `idx`; unallocated if there is none
   subroutine get_argument(idx, arg)
      integer, intent(in) :: idx
      character(len=:), allocatable, intent(out) :: arg
      integer :: length
      if (idx < 0 .or. idx > command_argument_count()) return
      call get_command_argument(idx, length=length)
      allocate(character(len=length) :: arg)
      if (length > 0) call get_command_argument(idx, arg)
   end subroutine get_argument

   !> Value of an environment variable; unallocated if it is not set
   subroutine get_variable(var, val)
      character(len=*), intent(in) :: var
      character(len=:), allocatable, intent(out) :: val
      integer :: length, stat
      call get_environment_variable(var, length=length, status=stat)
      if (stat /= success) return
      allocate(character(len=length) :: val)
      if (length > 0) call get_environment_variable(var, val)
   end subroutine get_variable

end module testdrive
