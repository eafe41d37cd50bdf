! SPDX-License-Identifier: MIT

!> What each check must accept and reject, judged without the help of `check` itself
program verdicts
   use, intrinsic :: ieee_arithmetic, only : ieee_value, ieee_quiet_nan, ieee_positive_inf, &
      ieee_negative_inf
   use, intrinsic :: iso_fortran_env, only : int8, int16, int32, int64, sp => real32, dp => real64
   use testdrive, only : error_type, check, test_failed, skip_test, to_string, get_argument, get_variable
   implicit none
   character(len=*), parameter :: indent = new_line("a")//"           "
   type(error_type), allocatable :: error
   character(len=:), allocatable :: text
   real(sp) :: nan_s, inf_s
   real(dp) :: nan, inf, minus_inf, x
   integer :: passed, failed

   passed = 0
   failed = 0
   nan_s = ieee_value(nan_s, ieee_quiet_nan)
   inf_s = ieee_value(inf_s, ieee_positive_inf)
   nan = ieee_value(nan, ieee_quiet_nan)
   inf = ieee_value(inf, ieee_positive_inf)
   minus_inf = ieee_value(inf, ieee_negative_inf)
   x = 3.0_dp

   call plain_checks()
   call integer_checks()
   call real64_checks()
   call real32_checks()
   call complex_checks()
   call messages()
   call order_of_events()
   call texts()

   print '(a, i0, a, i0, a)', "verdicts: ", passed, " passed, ", failed, " failed"
   if (failed > 0) error stop 1

contains

   subroutine plain_checks()
      call check(error, 0); call accepted("stat 0")
      call check(error, 7); call rejected("stat 7")
      call check(error, -1, "text", more="text"); call rejected("stat -1")
      call check(error, .true.); call accepted("condition true")
      call check(error, .false.); call rejected("condition false")
      call check(error, .false., .false.); call accepted("logical F F")
      call check(error, .true., .false.); call rejected("logical T F")
      call check(error, .false., .true.); call rejected("logical F T")
      call check(error, "agm", "agm"); call accepted("string equal")
      call check(error, "agm", "agn"); call rejected("string differs")
      call check(error, "agm", "ag"); call rejected("string longer")
      call check(error, "", "ag"); call rejected("string empty")
   end subroutine plain_checks

   subroutine integer_checks()
      call check(error, 5_int8, 5_int8); call accepted("int8 equal")
      call check(error, 5_int8, -5_int8); call rejected("int8 differs")
      call check(error, 5_int16, 5_int16); call accepted("int16 equal")
      call check(error, 5_int16, 261_int16); call rejected("int16 differs above 8 bits")
      call check(error, 5_int32, 5_int32); call accepted("int32 equal")
      call check(error, 5_int32, 65541_int32); call rejected("int32 differs above 16 bits")
      call check(error, huge(0_int64), huge(0_int64)); call accepted("int64 equal")
      call check(error, 5_int64, 4294967301_int64); call rejected("int64 differs above 32 bits")
   end subroutine integer_checks

   subroutine real64_checks()
      call check(error, x, 3.0_dp); call accepted("real64 equal")
      call check(error, 1 + epsilon(x), 1.0_dp); call accepted("real64 within default threshold")
      call check(error, 1 + 2*epsilon(x), 1.0_dp); call rejected("real64 beyond default threshold")
      call check(error, x, 3.25_dp, thr=0.25_dp); call accepted("real64 at thr")
      call check(error, x, 3.25_dp, thr=0.24_dp); call rejected("real64 beyond thr")
      call check(error, x, 2.75_dp, thr=0.24_dp); call rejected("real64 beyond thr, other side")
      call check(error, 100.0_dp, 101.0_dp, thr=0.01_dp, rel=.true.); call accepted("real64 within rel")
      call check(error, 100.0_dp, 102.0_dp, thr=0.01_dp, rel=.true.); call rejected("real64 beyond rel")
      call check(error, 100.0_dp, -100.0_dp, thr=0.01_dp, rel=.true.); call rejected("real64 rel, sign")
      call check(error, 100.0_dp, 101.0_dp, thr=0.01_dp, rel=.false.); call rejected("real64 rel off")
      call check(error, 1e-20_dp, 2e-20_dp, rel=.true.); call rejected("real64 rel, tiny")
      call check(error, 1e-20_dp, 2e-20_dp); call accepted("real64 abs, tiny")
      call check(error, 0.0_dp, 0.0_dp, rel=.true.); call accepted("real64 rel, 0 and 0")
      call check(error, -0.0_dp, 0.0_dp, rel=.true.); call accepted("real64 rel, -0 and 0")
      call check(error, 1e-300_dp, 0.0_dp, rel=.true.); call rejected("real64 rel, nonzero and 0")
      call check(error, 1.5_dp, 1.0_dp, 0.6_dp, 0.1_dp); call accepted("real64 absrel by abs")
      call check(error, 15.0_dp, 10.0_dp, 0.6_dp, 0.5_dp); call accepted("real64 absrel by rel")
      call check(error, 15.0_dp, 10.0_dp, 0.6_dp, 0.4_dp); call rejected("real64 absrel by none")
      call check(error, x); call accepted("real64 number")
      call check(error, inf); call accepted("real64 infinity is a number")
      call check(error, nan); call rejected("real64 NaN alone")
      call check(error, nan, x); call rejected("real64 NaN, 3")
      call check(error, x, nan); call rejected("real64 3, NaN")
      call check(error, nan, nan); call rejected("real64 NaN, NaN")
      call check(error, -nan, nan, rel=.true.); call rejected("real64 NaN, NaN, rel")
      call check(error, x, nan, rel=.true.); call rejected("real64 3, NaN, rel")
      call check(error, nan, x, thr=inf); call rejected("real64 NaN, thr infinite")
      call check(error, x, nan, 1.0_dp, 1.0_dp); call rejected("real64 3, NaN, absrel")
      call check(error, x, 4.0_dp, thr=nan); call rejected("real64 thr NaN")
      call check(error, inf, inf); call accepted("real64 Inf, Inf")
      call check(error, inf, inf, rel=.true.); call accepted("real64 Inf, Inf, rel")
      call check(error, minus_inf, inf); call rejected("real64 -Inf, Inf")
      call check(error, x, inf); call rejected("real64 3, Inf")
      call check(error, x, inf, rel=.true.); call rejected("real64 3, Inf, rel")
      call check(error, x, inf, 1.0_dp, 1.0_dp); call rejected("real64 3, Inf, absrel")
      call check(error, inf, x, rel=.true.); call rejected("real64 Inf, 3, rel")
   end subroutine real64_checks

   subroutine real32_checks()
      call check(error, 3.0_sp, 3.0_sp); call accepted("real32 equal")
      call check(error, 1 + epsilon(1.0_sp), 1.0_sp); call accepted("real32 within default threshold")
      call check(error, 1 + 2*epsilon(1.0_sp), 1.0_sp); call rejected("real32 beyond default threshold")
      call check(error, 3.0_sp, 3.25_sp, thr=0.25_sp); call accepted("real32 at thr")
      call check(error, 3.0_sp, 3.25_sp, thr=0.24_sp); call rejected("real32 beyond thr")
      call check(error, 100.0_sp, 101.0_sp, thr=0.01_sp, rel=.true.); call accepted("real32 within rel")
      call check(error, 100.0_sp, 102.0_sp, thr=0.01_sp, rel=.true.); call rejected("real32 beyond rel")
      call check(error, 1e-20_sp, 2e-20_sp, rel=.true.); call rejected("real32 rel, tiny")
      call check(error, 0.0_sp, 0.0_sp, rel=.true.); call accepted("real32 rel, 0 and 0")
      call check(error, 15.0_sp, 10.0_sp, 0.6_sp, 0.5_sp); call accepted("real32 absrel by rel")
      call check(error, 15.0_sp, 10.0_sp, 0.6_sp, 0.4_sp); call rejected("real32 absrel by none")
      call check(error, inf_s, inf_s); call accepted("real32 Inf, Inf")
      call check(error, 3.0_sp, inf_s, rel=.true.); call rejected("real32 3, Inf, rel")
      call check(error, 3.0_sp); call accepted("real32 number")
      call check(error, nan_s); call rejected("real32 NaN alone")
      call check(error, nan_s, 3.0_sp); call rejected("real32 NaN, 3")
      call check(error, 3.0_sp, nan_s); call rejected("real32 3, NaN")
      call check(error, nan_s, nan_s, rel=.true.); call rejected("real32 NaN, NaN, rel")
   end subroutine real32_checks

   subroutine complex_checks()
      complex(dp) :: z
      z = (3.0_dp, 4.0_dp)
      call check(error, z, z); call accepted("complex64 equal")
      call check(error, z, (3.0_dp, 5.0_dp)); call rejected("complex64 imaginary part differs")
      call check(error, z, (2.0_dp, 4.0_dp)); call rejected("complex64 real part differs")
      call check(error, z, z + 0.3_dp, thr=0.1_dp, rel=.true.); call accepted("complex64 within rel")
      call check(error, z, z + 0.9_dp, thr=0.1_dp, rel=.true.); call rejected("complex64 beyond rel")
      call check(error, z); call accepted("complex64 number")
      call check(error, cmplx(nan, 0, dp)); call rejected("complex64 NaN real part")
      call check(error, cmplx(0, nan, dp)); call rejected("complex64 NaN imaginary part")
      call check(error, z, cmplx(3, nan, dp)); call rejected("complex64 expected NaN")
      call check(error, cmplx(inf, nan, dp), cmplx(inf, nan, dp)); call rejected("complex64 Inf and NaN")
      call check(error, cmplx(inf, 1, dp), cmplx(inf, 1, dp)); call accepted("complex64 Inf")
      call check(error, (1.0_sp, 2.0_sp), (1.0_sp, 2.0_sp)); call accepted("complex32 equal")
      call check(error, (1.0_sp, 2.0_sp), (1.0_sp, 2.5_sp), thr=0.4_sp); call rejected("complex32 differs")
      call check(error, cmplx(0, nan_s, sp)); call rejected("complex32 NaN")
   end subroutine complex_checks

   subroutine messages()
      call test_failed(error, "what", "more", "and more")
      call says("test_failed", "what"//indent//"more"//indent//"and more")
      call skip_test(error, message="no GSL", more="here")
      call says("skip_test", "no GSL"//indent//"here")
      call check(error, 1, 2, message="mine", more="and this")
      call says("message and more", "mine"//indent//"and this")
      call check(error, 1, 2, more="and this")
      call says("more alone", "Integer value mismatch"//indent//"expected 2 but got 1"//indent//"and this")
      call check(error, .false., more="hint")
      call says("more without detail", "Condition not fulfilled"//indent//"hint")
      call check(error, 1.0_dp, 0.0_dp, rel=.true.)
      call judge("rel with 0 says so", index(error%message, "(relative difference: Inf") > 0)
      call forget()
      call check(error, 1 + 4*epsilon(x), 1.0_dp, rel=.true.)
      call judge("rel shows ulps", index(error%message, "888") > 0)
      call forget()
   end subroutine messages

   subroutine order_of_events()
      call test_failed(error, "first")
      call check(error, 2.0_dp, 1.0_dp, "second")
      call says("first failure stays", "first")
      call check(error, 1, 2, "first")
      call check(error, 0)
      call check(error, x, x)
      call says("a good check cures nothing", "first")
      call test_failed(error, "first")
      call skip_test(error, "skip")
      call judge("a skip cures nothing", error%stat /= 77)
      call forget()
      call skip_test(error, "skip")
      call judge("skip is 77", error%stat == 77)
      call check(error, .true.)
      call judge("a good check keeps the skip", error%stat == 77)
      call check(error, .false., "failure")
      call judge("a failure beats a skip", error%stat == 1)
      call says("a failure beats a skip, message", "failure")
   end subroutine order_of_events

   subroutine texts()
      call judge("to_string int8", to_string(-127_int8) == "-127")
      call judge("to_string int64", to_string(-huge(0_int64) - 1) == "-9223372036854775808")
      call judge("to_string 0", to_string(0) == "0" .and. len(to_string(0)) == 1)
      call judge("to_string real", index(to_string(0.5_dp), "5") > 0 .and. index(to_string(0.5_sp), " ") == 0)
      call judge("to_string complex", scan(to_string((1.0_dp, 2.0_dp)), "(,)") == 1)
      call get_argument(1, text)
      call judge("get_argument", allocated(text))
      if (allocated(text)) call judge("get_argument, blanks", text == " two words" .and. len(text) == 11)
      call get_argument(2, text)
      call judge("get_argument, empty", allocated(text))
      call get_argument(3, text)
      call judge("get_argument, none", .not. allocated(text))
      call get_variable("FURIKO_NO_SUCH_VARIABLE", text)
      call judge("get_variable, none", .not. allocated(text))
      call get_variable("PATH", text)
      call judge("get_variable", allocated(text))
   end subroutine texts

   subroutine accepted(name)
      character(len=*), intent(in) :: name
      call judge(name, .not. allocated(error))
      call forget()
   end subroutine accepted

   subroutine rejected(name)
      character(len=*), intent(in) :: name
      call judge(name, allocated(error))
      if (allocated(error)) call judge(name//", stat", error%stat == 1 .and. allocated(error%message))
      call forget()
   end subroutine rejected

   subroutine says(name, message)
      character(len=*), intent(in) :: name, message
      call judge(name, allocated(error))
      if (allocated(error)) call judge(name//", text", error%message == message)
      call forget()
   end subroutine says

   subroutine judge(name, good)
      character(len=*), intent(in) :: name
      logical, intent(in) :: good
      if (good) passed = passed + 1
      if (.not. good) failed = failed + 1
      if (.not. good) print '(2a)', "NOT OK ", name
   end subroutine judge

   subroutine forget()
      if (.not. allocated(error)) return
      error%stat = 0
      deallocate(error)
   end subroutine forget

end program verdicts
