! SPDX-License-Identifier: MIT

!> An independent check: GSL, within its domain and its accuracy. Its integrals take the modulus k,
!> -1 < k < 1, and lose digits next to 1: for k^2 >= 1 - 1.5e-8 they are good to 2e-8 only.
module test_fgsl
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use fgsl, only : fgsl_edom, fgsl_error_handler_t, fgsl_prec_double, fgsl_set_error_handler_off, &
      fgsl_sf_elljac_e, fgsl_sf_ellint_d, fgsl_sf_ellint_e, fgsl_sf_ellint_ecomp, &
      fgsl_sf_ellint_f, &
      fgsl_sf_ellint_kcomp, fgsl_sf_ellint_kcomp_e, fgsl_sf_ellint_p, fgsl_sf_ellint_pcomp, &
      fgsl_sf_ellint_rc, fgsl_sf_ellint_rd, fgsl_sf_ellint_rf, fgsl_sf_ellint_rj, fgsl_sf_result, &
      fgsl_success
   use furiko, only : carlson_rc, carlson_rd, carlson_rf, carlson_rj, ellipdinc_k, ellipe_k, &
      ellipeinc_k, ellipf_k, ellipk_k, ellipk_m, ellippi_k, ellippiinc_k, jacobi_m
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
         new_unittest('third-kind-and-its-sign', test_third_kind), &
         new_unittest('incomplete', test_incomplete), &
         new_unittest('carlson', test_carlson), &
         new_unittest('jacobi', test_jacobi), &
         new_unittest('jacobi-next-to-1', test_jacobi_next_to_1), &
         new_unittest('jacobi-far-out', test_jacobi_far), &
         new_unittest('domain', test_domain)]
   end subroutine collect_fgsl


   !> 1e-13 up to k = 0.99; GSL errs by up to 11000 ulp beyond
   subroutine test_first_kind(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: k
      integer :: i

      do i = -990, 990
         k = 0.001_wp*i
         call check(error, abs(fgsl_sf_ellint_kcomp(k, &
            fgsl_prec_double)/ellipk_k(k) - 1) < 1e-13_wp)
         if (allocated(error)) return
      end do
   end subroutine test_first_kind


   subroutine test_second_kind(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: k
      integer :: i

      do i = -990, 990
         k = 0.001_wp*i
         call check(error, abs(fgsl_sf_ellint_ecomp(k, &
            fgsl_prec_double)/ellipe_k(k) - 1) < 1e-13_wp)
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
         call check(error, abs(fgsl_sf_ellint_kcomp(k, &
            fgsl_prec_double)/ellipk_k(k) - 1) < tolerance)
         if (allocated(error)) return
         call check(error, abs(fgsl_sf_ellint_ecomp(k, &
            fgsl_prec_double)/ellipe_k(k) - 1) < tolerance)
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


   !> GSL's n has the opposite sign
   subroutine test_third_kind(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: x(200, 3), gsl
      integer :: i

      call random_number(x)
      x(:, 1:2) = 0.9_wp*x(:, 1:2)
      do i = 1, size(x, 1)
         associate (n => x(i, 1), k => x(i, 2), phi => x(i, 3))
            gsl = fgsl_sf_ellint_pcomp(k, -n, fgsl_prec_double)
            call check(error, abs(gsl/ellippi_k(n, k) - 1) < 1e-12_wp)
            if (allocated(error)) return
            gsl = fgsl_sf_ellint_p(phi, k, -n, fgsl_prec_double)
            call check(error, abs(gsl/ellippiinc_k(n, phi, k) - 1) < 1e-12_wp)
         end associate
         if (allocated(error)) return
      end do
   end subroutine test_third_kind


   !> To phi = 1.4; GSL loses up to three digits between there and pi/2
   subroutine test_incomplete(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: x(200, 2)
      integer :: i

      call random_number(x)
      do i = 1, size(x, 1)
         associate (k => x(i, 1), phi => 1.4_wp*x(i, 2))
            call check(error, &
               abs(fgsl_sf_ellint_f(phi, k, fgsl_prec_double)/ellipf_k(phi, &
               k) - 1) < 1e-13_wp .and. &
               abs(fgsl_sf_ellint_e(phi, k, fgsl_prec_double)/ellipeinc_k(phi, &
               k) - 1) < 1e-13_wp .and. &
               abs(fgsl_sf_ellint_d(phi, k, fgsl_prec_double)/ellipdinc_k(phi, k) - 1) < 1e-13_wp)
         end associate
         if (allocated(error)) return
      end do
   end subroutine test_incomplete


   subroutine test_carlson(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: x(200, 4)
      integer :: i

      call random_number(x)
      do i = 1, size(x, 1)
         associate (a => x(i, 1), b => x(i, 2), c => x(i, 3), d => x(i, 4))
            call check(error, &
               abs(fgsl_sf_ellint_rf(a, b, c, fgsl_prec_double)/carlson_rf(a, b, &
               c) - 1) < 1e-14_wp .and. &
               abs(fgsl_sf_ellint_rc(a, b, fgsl_prec_double)/carlson_rc(a, &
               b) - 1) < 1e-14_wp .and. &
               abs(fgsl_sf_ellint_rd(a, b, c, fgsl_prec_double)/carlson_rd(a, b, &
               c) - 1) < 1e-14_wp .and. &
               abs(fgsl_sf_ellint_rj(a, b, c, d, fgsl_prec_double)/carlson_rj(a, b, c, &
               d) - 1) < 1e-14_wp)
         end associate
         if (allocated(error)) return
      end do
   end subroutine test_carlson


   !> GSL's Jacobi functions take m, |m| <= 1. Its error grows like 4 eps u, absolutely, to m = 1 - 1e-12.
   subroutine test_jacobi(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: x(300, 2), gsl(3), ours(3), m
      integer :: i

      call random_number(x)
      do i = 1, size(x, 1)
         associate (u => 100*x(i, 1)**3)
            m = merge(x(i, 2), 1 - 10.0_wp**(-12*x(i, 2)), modulo(i, 2) == 0)
            call jacobi_m(u, m, ours(1), ours(2), ours(3))
            call check(error, fgsl_sf_elljac_e(u, m, gsl(1), gsl(2), gsl(3)), fgsl_success)
            if (allocated(error)) return
            call check(error, all(abs(gsl - ours) <= 1e-14_wp*max(1.0_wp, u)))
         end associate
         if (allocated(error)) return
      end do
   end subroutine test_jacobi


   !> GSL is wrong: for 1 - m < 4e-16 it answers as for m = 1, where nothing ever comes back. At
   !> 1 - m = 2**-53 the period is 79. References: mpmath 1.4.1, 60 digits.
   subroutine test_jacobi_next_to_1(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: m = 1 - epsilon(1.0_wp)/2
      real(wp), parameter :: reference(3) = [-0.999354014197632359902_wp, &
         0.03593820122207592671338_wp, &
         0.03593820122207746934639_wp]
      real(wp) :: gsl(3), ours(3)

      call jacobi_m(75.0_wp, m, ours(1), ours(2), ours(3))
      call check(error, all(abs(ours/reference - 1) <= 4*epsilon(m)))
      if (allocated(error)) return
      call check(error, fgsl_sf_elljac_e(75.0_wp, m, gsl(1), gsl(2), gsl(3)), fgsl_success)
      if (allocated(error)) return
      call check(error, abs(gsl(1) - reference(1)) > 1.9_wp .and. gsl(2) < 1e-32_wp)
   end subroutine test_jacobi_next_to_1


   !> GSL is wrong by tens of thousands of eps at u = 1e5, where it keeps K to one word only, and says
   !> nothing; it refuses m < -1 and m > 1
   subroutine test_jacobi_far(error)
      type(error_type), allocatable, intent(out) :: error
      type(fgsl_error_handler_t) :: previous
      real(wp), parameter :: reference(3) = [-0.9402218551681907492811_wp, &
         0.3405625685011283479556_wp, &
         0.7469882405580712146763_wp]
      real(wp) :: gsl(3), ours(3)

      call jacobi_m(1.0e5_wp, 0.5_wp, ours(1), ours(2), ours(3))
      call check(error, all(abs(ours/reference - 1) <= 4*epsilon(ours)))
      if (allocated(error)) return
      call check(error, fgsl_sf_elljac_e(1.0e5_wp, 0.5_wp, gsl(1), gsl(2), gsl(3)), fgsl_success)
      if (allocated(error)) return
      call check(error, maxval(abs(gsl - reference)) > 1e-12_wp)
      if (allocated(error)) return
      previous = fgsl_set_error_handler_off()
      call check(error, fgsl_sf_elljac_e(1.0_wp, 1.5_wp, gsl(1), gsl(2), gsl(3)), fgsl_edom)
      if (allocated(error)) return
      call check(error, fgsl_sf_elljac_e(1.0_wp, -1.5_wp, gsl(1), gsl(2), gsl(3)), fgsl_edom)
   end subroutine test_jacobi_far


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
