! SPDX-License-Identifier: MIT

!> An independent check: GSL, within its domain and its accuracy. Its integrals take the modulus k,
!> -1 < k < 1, and lose digits next to 1: for k^2 >= 1 - 1.5e-8 they are good to 2e-8 only.
module test_fgsl
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use fgsl, only : fgsl_edom, fgsl_error_handler_t, fgsl_prec_double, fgsl_set_error_handler_off, &
      fgsl_sf_ellint_ecomp, fgsl_sf_ellint_kcomp, fgsl_sf_ellint_kcomp_e, fgsl_sf_result, &
      fgsl_success
   use furiko, only : ellipe_k, ellipk_k, ellipk_m
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   public :: collect_fgsl


contains


   subroutine collect_fgsl(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('first-kind', test_first_kind), &
         new_unittest('second-kind', test_second_kind), &
         new_unittest('next-to-1', test_next_to_1), &
         new_unittest('takes-k-not-m', test_modulus), &
         new_unittest('domain', test_domain)]
   end subroutine collect_fgsl


   !> 1e-13 up to k = 0.99; GSL errs by up to 11000 ulp beyond
   subroutine test_first_kind(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: k
      integer :: i

      do i = -990, 990
         k = 0.001_wp*i
         call check(error, abs(fgsl_sf_ellint_kcomp(k, fgsl_prec_double)/ellipk_k(k) - 1) < 1e-13_wp)
         if (allocated(error)) return
      end do
   end subroutine test_first_kind


   subroutine test_second_kind(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: k
      integer :: i

      do i = -990, 990
         k = 0.001_wp*i
         call check(error, abs(fgsl_sf_ellint_ecomp(k, fgsl_prec_double)/ellipe_k(k) - 1) < 1e-13_wp)
         if (allocated(error)) return
      end do
   end subroutine test_second_kind


   !> GSL's error grows with eps/(1 - k) until its short polynomials take over
   subroutine test_next_to_1(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: gap, k, tolerance
      integer :: i

      do i = 2, 15
         gap = 10.0_wp**(-i)
         k = 1 - gap
         tolerance = merge(4*epsilon(k)/gap, 1e-7_wp, gap > 1e-8_wp)
         call check(error, abs(fgsl_sf_ellint_kcomp(k, fgsl_prec_double)/ellipk_k(k) - 1) < tolerance)
         if (allocated(error)) return
         call check(error, abs(fgsl_sf_ellint_ecomp(k, fgsl_prec_double)/ellipe_k(k) - 1) < tolerance)
         if (allocated(error)) return
      end do
   end subroutine test_next_to_1


   !> The first note's 2012 correction says that GSL's integrals take m: they take k (only its
   !> Jacobi functions take m)
   subroutine test_modulus(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: gsl

      gsl = fgsl_sf_ellint_kcomp(0.5_wp, fgsl_prec_double)
      call check(error, abs(gsl - ellipk_k(0.5_wp)) < 1e-14_wp)
      if (allocated(error)) return
      call check(error, abs(gsl - ellipk_m(0.5_wp)) > 0.1_wp)
   end subroutine test_modulus


   !> Where GSL refuses: at |k| = 1 already
   subroutine test_domain(error)
      type(error_type), allocatable, intent(out) :: error
      type(fgsl_error_handler_t) :: previous
      type(fgsl_sf_result) :: value

      previous = fgsl_set_error_handler_off()
      call check(error, fgsl_sf_ellint_kcomp_e(0.5_wp, fgsl_prec_double, value), fgsl_success)
      if (allocated(error)) return
      call check(error, fgsl_sf_ellint_kcomp_e(1.0_wp, fgsl_prec_double, value), fgsl_edom)
   end subroutine test_domain

end module test_fgsl
