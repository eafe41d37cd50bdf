! SPDX-License-Identifier: MIT

module check_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   ! allow(C121)
   use furiko, modulus_dp => modulus, modulus => modulus_real32, motion_dp => motion, &
      motion => motion_real32, pendulum_dp => pendulum, pendulum => pendulum_real32
   use furiko_by_name_sp, only : evaluate
   use furiko_catalogue, only : catalogue
   use test_ulp, only : ulps
   implicit none
   private
   character(len=*), parameter :: kind_name = 'real32'
   include 'check.inc'
end module check_sp


module check_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   ! allow(C121)
   use furiko
   use furiko_by_name_dp, only : evaluate
   use furiko_catalogue, only : catalogue
   use test_ulp, only : ulps
   implicit none
   private
   character(len=*), parameter :: kind_name = 'real64'
   include 'check.inc'
end module check_dp


#if defined __GFC_REAL_16__ && !defined FURIKO_NO_REAL128
module check_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   ! allow(C121)
   use furiko, modulus_dp => modulus, modulus => modulus_real128, motion_dp => motion, &
      motion => motion_real128, pendulum_dp => pendulum, pendulum => pendulum_real128
   use furiko_by_name_qp, only : evaluate
   use furiko_catalogue, only : catalogue
   use test_ulp, only : ulps
   implicit none
   private
   character(len=*), parameter :: kind_name = 'real128'
   include 'check.inc'
end module check_qp
#endif


!> Every function of the catalogue on stored references, and the rest of the library on identities:
!> `check FILE`, a file written by .ci/compilers/sample. Needs the library's objects and
!> test/test_ulp.F90; no fpm, no GSL, no test-drive.
program check
   use check_sp, only : judge_sp => judge
   use check_dp, only : judge_dp => judge
#if defined __GFC_REAL_16__ && !defined FURIKO_NO_REAL128
   use check_qp, only : judge_qp => judge
#endif
   implicit none
   character(len=1000) :: file
   logical :: good(3)

   call get_command_argument(1, file)
   good = .true.
   call judge_sp(trim(file), good(1))
   call judge_dp(trim(file), good(2))
#if defined __GFC_REAL_16__ && !defined FURIKO_NO_REAL128
   call judge_qp(trim(file), good(3))
#endif
   if (.not. all(good)) stop 1
end program check
