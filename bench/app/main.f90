! SPDX-License-Identifier: MIT

!> furiko beside GSL and Boost in one run: interleaved repeats, medians, in ns a value. Prints rows
!> of a Markdown table; `bench/run` makes doc/speed.md of them.
program main
   use, intrinsic :: iso_fortran_env, only : error_unit, int64, wp => real64
   ! allow(C121)
   use bench_peers
   use bench_table, only : cell, median
   ! allow(C121)
   use furiko
   implicit none
   integer, parameter :: points = 10000
   integer, parameter :: repeats = 15
   integer, parameter :: us = 1, us_scalar = 2, gsl = 3, boost = 4
   character(len=*), parameter :: names(*) = [character(len=14) :: 'K(m)', 'E(m)', 'K and E', &
      'D(m)', 'Pi(n, m)', 'F(phi, m)', 'E(phi, m)', 'D(phi, m)', 'Pi(n, phi, m)', 'RF(x, y, z)', &
      'RD(x, y, z)', 'RJ(x, y, z, p)']
   real(wp), dimension(points) :: m, k, n, phi, x, y, z, p
   real(wp) :: values(points, 4), other(points)
   real(wp) :: times(repeats, 4)
   logical :: there(4)
   integer :: i, peer, repeat

   there = .true.
   there(boost) = has_boost()
   call random_points()
   do i = 1, size(names)
      do repeat = 1, repeats
         do peer = us, boost
            times(repeat, peer) = time_of(i, peer, values(:, peer))
         end do
      end do
      call check_values(i)
      print '(15a)', '| ', names(i), (' | ', cell(median(times(:, peer)), there(peer)), peer=us, boost), &
         (' | ', cell(median(times(:, peer)/times(:, us)), there(peer)), peer=gsl, boost), ' |'
   end do


contains


   subroutine random_points()
      call random_number(m)
      k = sqrt(m)
      call random_number(n)
      n = 0.99_wp*n
      call random_number(phi)
      phi = phi*acos(-1.0_wp)/2
      call random_number(x)
      call random_number(y)
      call random_number(z)
      call random_number(p)
   end subroutine random_points


   !> ns a value of one pass over the points
   function time_of(case, peer, value) result(time)
      integer, intent(in) :: case
      integer, intent(in) :: peer
      real(wp), intent(out) :: value(:)
      real(wp) :: time
      integer(int64) :: start, finish, rate

      call system_clock(start, rate)
      select case (peer)
      case (us)
         call batch(case, value)
      case (us_scalar)
         call scalars(case, value)
      case (gsl)
         call gsl_values(case, value)
      case default
         call boost_values(case, value)
      end select
      call system_clock(finish)
      time = real(finish - start, wp)/real(rate, wp)*1.0e9_wp/points
   end function time_of


   subroutine batch(case, value)
      integer, intent(in) :: case
      real(wp), intent(out) :: value(:)

      select case (case)
      case (1)
         value = ellipk_m(m)
      case (2)
         value = ellipe_m(m)
      case (3)
         call ellipke_m(m, value, other)
      case (4)
         value = ellipd_m(m)
      case (5)
         value = ellippi_m(n, m)
      case (6)
         value = ellipf_m(phi, m)
      case (7)
         value = ellipeinc_m(phi, m)
      case (8)
         value = ellipdinc_m(phi, m)
      case (9)
         value = ellippiinc_m(n, phi, m)
      case (10)
         value = carlson_rf(x, y, z)
      case (11)
         value = carlson_rd(x, y, z)
      case default
         value = carlson_rj(x, y, z, p)
      end select
   end subroutine batch


   subroutine scalars(case, value)
      integer, intent(in) :: case
      real(wp), intent(out) :: value(:)
      integer :: j

      do j = 1, points
         select case (case)
         case (1)
            value(j) = ellipk_m(m(j))
         case (2)
            value(j) = ellipe_m(m(j))
         case (3)
            call ellipke_m(m(j), value(j), other(j))
         case (4)
            value(j) = ellipd_m(m(j))
         case (5)
            value(j) = ellippi_m(n(j), m(j))
         case (6)
            value(j) = ellipf_m(phi(j), m(j))
         case (7)
            value(j) = ellipeinc_m(phi(j), m(j))
         case (8)
            value(j) = ellipdinc_m(phi(j), m(j))
         case (9)
            value(j) = ellippiinc_m(n(j), phi(j), m(j))
         case (10)
            value(j) = carlson_rf(x(j), y(j), z(j))
         case (11)
            value(j) = carlson_rd(x(j), y(j), z(j))
         case default
            value(j) = carlson_rj(x(j), y(j), z(j), p(j))
         end select
      end do
   end subroutine scalars


   subroutine gsl_values(case, value)
      integer, intent(in) :: case
      real(wp), intent(out) :: value(:)
      integer :: j

      do j = 1, points
         select case (case)
         case (1)
            value(j) = gsl_k(k(j), 0)
         case (2)
            value(j) = gsl_e(k(j), 0)
         case (3)
            value(j) = gsl_k(k(j), 0)
            other(j) = gsl_e(k(j), 0)
         case (4)
            value(j) = gsl_d(k(j), 0)
         case (5)
            value(j) = gsl_pi(k(j), -n(j), 0)
         case (6)
            value(j) = gsl_f(phi(j), k(j), 0)
         case (7)
            value(j) = gsl_einc(phi(j), k(j), 0)
         case (8)
            value(j) = gsl_dinc(phi(j), k(j), 0)
         case (9)
            value(j) = gsl_piinc(phi(j), k(j), -n(j), 0)
         case (10)
            value(j) = gsl_rf(x(j), y(j), z(j), 0)
         case (11)
            value(j) = gsl_rd(x(j), y(j), z(j), 0)
         case default
            value(j) = gsl_rj(x(j), y(j), z(j), p(j), 0)
         end select
      end do
   end subroutine gsl_values


   subroutine boost_values(case, value)
      integer, intent(in) :: case
      real(wp), intent(out) :: value(:)
      integer :: j

      do j = 1, points
         select case (case)
         case (1)
            value(j) = boost_k(k(j))
         case (2)
            value(j) = boost_e(k(j))
         case (3)
            value(j) = boost_k(k(j))
            other(j) = boost_e(k(j))
         case (4)
            value(j) = boost_d(k(j))
         case (5)
            value(j) = boost_pi(k(j), n(j))
         case (6)
            value(j) = boost_f(phi(j), k(j))
         case (7)
            value(j) = boost_einc(phi(j), k(j))
         case (8)
            value(j) = boost_dinc(phi(j), k(j))
         case (9)
            value(j) = boost_piinc(phi(j), k(j), n(j))
         case (10)
            value(j) = boost_rf(x(j), y(j), z(j))
         case (11)
            value(j) = boost_rd(x(j), y(j), z(j))
         case default
            value(j) = boost_rj(x(j), y(j), z(j), p(j))
         end select
      end do
   end subroutine boost_values


   !> All must have computed the same, as far as GSL's and Boost's k = sqrt(m) allows: 1e-9, and
   !> nowhere next to m = 1.
   subroutine check_values(case)
      integer, intent(in) :: case
      integer :: peer
      logical :: same(points)

      do peer = us_scalar, boost
         if (.not. there(peer)) cycle
         same = abs(values(:, peer)/values(:, us) - 1) < 1.0e-9_wp .or. m > 0.9999_wp
         if (.not. all(same)) then
            write(error_unit, '(3a, i0)') 'bench: ', trim(names(case)), &
               ' differs from the peer number ', peer
            error stop 1
         end if
      end do
   end subroutine check_values

end program main
