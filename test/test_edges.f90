! SPDX-License-Identifier: MIT

!> Single values at the edges of the integrals, in real64: each stands for a kind of argument that the
!> reference data have many of. By 60-digit arithmetic (python-flint).
module test_edges
   use, intrinsic :: iso_fortran_env, only : compiler_version, wp => real64
   use, intrinsic :: ieee_exceptions, only : ieee_all, ieee_get_flag, ieee_inexact, ieee_overflow, &
      ieee_set_flag, ieee_underflow, ieee_usual
   use furiko, only : agm, agm_steps_m, carlson_rc, carlson_rd, carlson_rj, ellipdinc_m, ellipeinc_m, &
      ellipeinc_mc, ellipf_k, ellipf_m, ellipk_series_k, ellippi_mc, ellippiinc_m, &
      modulus, modulus_from_m, period_ratio_series
   use testdrive, only : check, error_type, new_unittest, skip_test, unittest_type
   implicit none
   private
   public :: collect_edges

   real(wp), parameter :: least = 4.94065645841246544e-324_wp


contains


   subroutine collect_edges(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('next-to-a-pole', test_poles), &
         new_unittest('where-m-sin-phi-squared-is-1', test_edge), &
         new_unittest('over-the-exponent-range', test_spread), &
         new_unittest('overflow-is-infinity', test_overflow), &
         new_unittest('subnormal', test_subnormal), &
         new_unittest('agm', test_agm), &
         new_unittest('sums-of-many-terms', test_sums), &
         new_unittest('epsilon-above-1', test_epsilon)]
   end subroutine collect_edges


   subroutine test_poles(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: n(2) = [2.345411083421193_wp, 217.15665594467998_wp]
      real(wp), parameter :: phi(2) = [0.7114938442327101_wp, 0.06791212352997125_wp]
      real(wp), parameter :: m(2) = [-2.750515739974222_wp, -0.013094275332515615_wp]
      real(wp), parameter :: right(2) = [11.273996522088020_wp, 0.81927199063101159_wp]

      call check(error, near_to([ellippiinc_m(n(1), phi(1), m(1)), ellippiinc_m(n(2), phi(2), m(2))], right))
      if (allocated(error)) return
      call check(error, near_to(ellippiinc_m(n, phi, m), right))
   end subroutine test_poles


   subroutine test_edge(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: phi(2) = [0.5235987755982989_wp, -0.52359877559829882_wp]
      real(wp), parameter :: right(2) = [0.8428751774062980_wp, -0.84287516926376508_wp]

      call check(error, near_to([ellipf_m(phi(1), 4.0_wp), ellipf_k(phi(1), 2.0_wp)], right([1, 1])))
      if (allocated(error)) return
      call check(error, near_to(ellipf_m(phi(:1), [4.0_wp]), right(:1)))
      if (allocated(error)) return
      call check(error, abs(ellipf_m(phi(2), 4.0_wp) - right(2)) < 1.0e-15_wp)
   end subroutine test_edge


   subroutine test_spread(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: right(5) = [1.304347826086956576811e154_wp, -4.1105148998006157755e-205_wp, &
         3152.8472313118261_wp, 1.5281862067991718e-295_wp, 5.5817917312021381524e-152_wp]

      call check(error, near_to([carlson_rd(0.0_wp, 1.0e308_wp, 2.3e-308_wp), &
         carlson_rj(0.5_wp, 0.25_wp, 1.0_wp, -1.0e205_wp), carlson_rj(0.5_wp, 0.5_wp, 0.5_wp, -least), &
         carlson_rc(9.03392525287292e-298_wp, -1.9668080218969408e146_wp), &
         carlson_rc(1.7e308_wp, -least)], right))
      if (allocated(error)) return
      call check(error, near_to([carlson_rd([0.0_wp], [1.0e308_wp], [2.3e-308_wp]), &
         carlson_rj([0.5_wp, 0.5_wp], [0.25_wp, 0.5_wp], [1.0_wp, 0.5_wp], [-1.0e205_wp, -least]), &
         carlson_rc([9.03392525287292e-298_wp, 1.7e308_wp], [-1.9668080218969408e146_wp, -least])], right))
      if (allocated(error)) return
      ! n far from all: pi/(2 sqrt(-n)); for n > 0 the principal value
      call check(error, near_to([ellippi_mc(-1.0e300_wp, 1.0e-200_wp), ellippi_mc(-1.0e300_wp, 0.5_wp)], &
         acos(-1.0_wp)/2*[1.0e-150_wp, 1.0e-150_wp]))
      if (allocated(error)) return
      call check(error, near_to([ellippi_mc(1.0e200_wp, 1.0e-300_wp), &
         ellippi_mc([1.0e200_wp], [1.0e-300_wp])], &
         [-3.4577405831022675e-198_wp, -3.4577405831022675e-198_wp]))
   end subroutine test_spread


   !> +-Inf and the overflow flag, no other but of rounding
   subroutine test_overflow(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: f(5), g(5), phi
      logical :: raised(size(ieee_usual)), overflow

      if (index(compiler_version(), 'flang') > 0) then
         call skip_test(error, 'LLVM computes ahead as if nobody looked at the flags')
         return
      end if
      phi = huge(phi)
      call ieee_set_flag(ieee_all, .false.)
      f = [ellipf_m(phi, 0.5_wp), ellipeinc_m(phi, -1.0_wp), ellipdinc_m(phi, 0.99_wp), &
           ellippiinc_m(0.5_wp, phi, 0.5_wp), -ellipf_m(-phi, 0.5_wp)]
      g = [ellipf_m([phi], [0.5_wp]), ellipeinc_m([phi], [-1.0_wp]), ellipdinc_m([phi], [0.99_wp]), &
           ellippiinc_m([0.5_wp], [phi], [0.5_wp]), -ellipf_m([-phi], [0.5_wp])]
      call ieee_get_flag(ieee_usual, raised)
      call ieee_get_flag(ieee_overflow, overflow)
      call check(error, all([f, g] > huge(phi)) .and. count(raised) == 1 .and. overflow)
   end subroutine test_overflow


   subroutine test_subnormal(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: right = 32959025.101840762_wp

      ! the neighbours are 0.8 ulp off
      call check(error, all(abs([ellipeinc_mc(51771915.85997274_wp, 2.57e-322_wp), &
         ellipeinc_mc([51771915.85997274_wp], [2.57e-322_wp])] - right) <= 0.0_wp))
      if (allocated(error)) return
      call check(error, abs(ellipdinc_m(3.0e-107_wp, 0.5_wp) - 9.0e-321_wp) <= 0.0_wp)
   end subroutine test_subnormal


   subroutine test_agm(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: m
      integer :: i, j

      call check(error, near_to([agm(1.8011535984704893e-306_wp, 4*least), &
         agm(1.0_wp, 8.14050952975677e-12_wp)], &
         [6.9965952352053862e-308_wp, 0.058349529282354765_wp]))
      if (allocated(error)) return
      do i = 1, 20
         do j = 1, 20
            m = agm(i*least, j*least)
            call check(error, m >= min(i, j)*least .and. m <= max(i, j)*least)
            if (allocated(error)) return
         end do
      end do
   end subroutine test_agm


   subroutine test_sums(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), dimension(6) :: a, b, c, k, e

      call check(error, near_to([ellipk_series_k(-0.9990101241848863_wp, 400), &
         period_ratio_series(3.0_wp, 300), period_ratio_series(-3.1_wp, 100)], &
         [4.3429654330478564186_wp, 2.5395288944631557634_wp, 2.5180379683851199713_wp]))
      if (allocated(error)) return
      call agm_steps_m(0.9999999999840387_wp, a, b, c, k, e)
      call check(error, near_to([e(5)], [0.98742990701153088_wp]))
   end subroutine test_sums


   !> Between F - D and E - (1 - 1/m) F, each of which cancels somewhere: 5.6 ulp by the first one here
   subroutine test_epsilon(error)
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: u = 1.7935657516439865_wp, m = 1.2931188089670957_wp
      real(wp), parameter :: right = 0.792692122936902347911356214808417576_wp
      type(modulus) :: p

      p = modulus_from_m(m)
      call check(error, abs(p%epsilon(u) - right) <= 5*spacing(right))
      if (allocated(error)) return
      call check(error, all(abs(p%epsilon([u, u]) - right) <= 5*spacing(right)))
   end subroutine test_epsilon


   !> Within an epsilon, which is at least half an ulp and the rounding of what is right
   pure function near_to(f, right)
      real(wp), intent(in) :: f(:)
      real(wp), intent(in) :: right(:)
      logical :: near_to

      near_to = all(abs(f - right) <= epsilon(f)*abs(right))
   end function near_to

end module test_edges
