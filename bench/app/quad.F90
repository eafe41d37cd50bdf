! SPDX-License-Identifier: MIT

#ifdef __GFC_REAL_16__
!> K, F, sn/cn/dn and the pendulum's period in real128, beside what anyone would write in an hour: the
!> yardsticks. Interleaved repeats, the least of each, in ns a value. Prints rows of a Markdown table.
program quad
   use, intrinsic :: iso_fortran_env, only : dp => real64, int64, wp => real128
   use furiko, only : ellipf_m, ellipk_m, jacobi_m, period_ratio
   implicit none
   integer, parameter :: points = 200
   integer, parameter :: repeats = 15
   integer, parameter :: ways = 4
   character(len=*), parameter :: names(ways) = [character(len=36) :: &
      'K(m), AGM', 'F(phi, m), Carlson''s duplication', 'sn, cn, dn, descending Landen', 'period, AGM']
   real(wp), parameter :: half_pi = acos(-1.0_wp)/2
   real(wp), dimension(points) :: m, phi, u, x, y, c, d
   real(dp) :: random(points, 6), least(ways, 2), difference(ways)
   integer :: i, repeat

   call random_number(random)
   m = random(:, 1) + epsilon(random)*random(:, 2)
   phi = half_pi*(random(:, 3) + epsilon(random)*random(:, 4))
   u = 6*(random(:, 5) + epsilon(random)*random(:, 6))
   least = huge(least)
   do repeat = 1, repeats
      do i = 1, ways
         call try_furiko(i, x, least(i, 1))
         call try_yardstick(i, y, least(i, 2))
         difference(i) = real(maxval(abs(x/y - 1))/epsilon(1.0_wp), dp)
      end do
   end do
   print '(a)', '| | furiko | yardstick | furiko / yardstick | they differ by, epsilon |', &
      '|---|---|---|---|---|'
   do i = 1, ways
      print '(3a, 2(f8.0, a), f5.2, a, es9.1, a)', '| ', names(i), ' | ', least(i, 1), ' | ', least(i, 2), &
         ' | ', least(i, 1)/least(i, 2), ' | ', difference(i), ' |'
   end do


contains


   !> The library's values and their time
   subroutine try_furiko(way, value, time)
      integer, intent(in) :: way
      real(wp), intent(out) :: value(:)
      real(dp), intent(inout) :: time
      integer(int64) :: start
      integer :: j

      call system_clock(start)
      do j = 1, points
         select case (way)
         case (1)
            value(j) = ellipk_m(m(j))
         case (2)
            value(j) = ellipf_m(phi(j), m(j))
         case (3)
            call jacobi_m(u(j), m(j), value(j), c(j), d(j))
         case default
            value(j) = period_ratio(2*phi(j))
         end select
      end do
      time = min(time, since(start))
   end subroutine try_furiko


   !> The yardsticks' values and their time
   subroutine try_yardstick(way, value, time)
      integer, intent(in) :: way
      real(wp), intent(out) :: value(:)
      real(dp), intent(inout) :: time
      integer(int64) :: start
      integer :: j

      call system_clock(start)
      do j = 1, points
         select case (way)
         case (1)
            value(j) = half_pi/mean(sqrt(1 - m(j)))
         case (2)
            value(j) = f_by_duplication(phi(j), m(j))
         case (3)
            call landen(u(j), m(j), value(j), c(j), d(j))
         case default
            value(j) = 1/mean(cos(phi(j)))
         end select
      end do
      time = min(time, since(start))
   end subroutine try_yardstick


   !> ns a point since
   function since(start) result(time)
      integer(int64), intent(in) :: start
      real(dp) :: time
      integer(int64) :: finish, rate

      call system_clock(finish, rate)
      time = real(finish - start, dp)/real(rate, dp)*1.0e9_dp/points
   end function since


   !> The arithmetic-geometric mean M(1, b), its last step (a + b)/2 - (a - b)^2/(8 (a + b))
   pure function mean(b) result(a)
      real(wp), intent(in) :: b
      real(wp) :: a
      real(wp) :: g, next

      a = 1
      g = b
      do while (a - g > 1.0e-9_wp*a)
         next = (a + g)/2
         g = sqrt(a*g)
         a = next
      end do
      a = (a + g)/2 - (a - g)**2/(8*(a + g))
   end function mean


   !> F = s R_F(c^2, 1 - m s^2, 1) by duplication, DLMF 19.36.1, to order 7
   pure function f_by_duplication(phi, m) result(f)
      real(wp), intent(in) :: phi, m
      real(wp) :: f
      real(wp) :: s, x, y, z, a, lambda, e2, e3

      s = sin(phi)
      x = cos(phi)**2
      y = 1 - m*s**2
      z = 1
      do
         a = (x + y + z)/3
         ! the first terms left out are of order 8
         if (max(abs(a - x), abs(a - y), abs(a - z)) < 1.0e-4_wp*a) exit
         lambda = sqrt(x)*(sqrt(y) + sqrt(z)) + sqrt(y)*sqrt(z)
         x = (x + lambda)/4
         y = (y + lambda)/4
         z = (z + lambda)/4
      end do
      x = 1 - x/a
      y = 1 - y/a
      z = -x - y
      e2 = x*y - z**2
      e3 = x*y*z
      f = s/sqrt(a)*(1 - e2/10 + e3/14 + e2**2/24 - 3*e2*e3/44 - 5*e2**3/208 + 3*e3**2/104 + e2**2*e3/16)
   end function f_by_duplication


   !> The moduli by the AGM, DLMF 22.20(ii); the functions of the last, which is 0, and back by the descending
   !> Landen transformation, DLMF 22.7.2-4
   pure subroutine landen(u, m, sn, cn, dn)
      real(wp), intent(in) :: u, m
      real(wp), intent(out) :: sn, cn, dn
      integer, parameter :: most = 20
      real(wp) :: k(most), a, b, next, t
      integer :: i, n

      a = 1
      b = sqrt(1 - m)
      n = 0
      do while (a - b > 2*epsilon(a)*a)
         n = n + 1
         k(n) = (a - b)/(a + b)
         next = (a + b)/2
         b = sqrt(a*b)
         a = next
      end do
      sn = sin(a*u)
      cn = cos(a*u)
      dn = 1
      do i = n, 1, -1
         t = k(i)*sn**2
         sn = (1 + k(i))*sn/(1 + t)
         cn = cn*dn/(1 + t)
         dn = (1 - t)/(1 + t)
      end do
   end subroutine landen
end program quad
#else
!> The question is one of real128, which this compiler does not have.
program quad
   implicit none
end program quad
#endif
