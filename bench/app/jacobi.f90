! SPDX-License-Identifier: MIT

!> One modulus for many u, and the motion of the pendulum, beside GSL in one run: interleaved repeats, the
!> least and the median of each, in ns a value. Prints a Markdown table.
program jacobi
   use, intrinsic :: iso_c_binding, only : c_int
   use, intrinsic :: iso_fortran_env, only : error_unit, int64, wp => real64
   use bench_peers, only : gsl_elljac
   use bench_table, only : cell, median
   use furiko, only : jacobi_m, modulus, modulus_from_m, motion, pendulum
   implicit none
   integer, parameter :: points = 10000
   integer, parameter :: repeats = 21
   integer, parameter :: gsl_varying = 1, gsl_fixed = 3, gsl_motion = 7
   character(len=*), parameter :: names(8) = [character(len=44) :: &
      'varying m: GSL elljac', 'varying m: modulus_from_m, then scalar', &
      'm = 0.7: GSL elljac', 'm = 0.7: jacobi_m, u an array', 'm = 0.7: modulus, array', &
      'm = 0.7: modulus, scalar', 'furiko.c, 1 rad: GSL elljac and asin', &
      'furiko.c, 1 rad: motion, array']
   !> Which case each is compared with
   integer, parameter :: against(8) = [gsl_varying, gsl_varying, gsl_fixed, gsl_fixed, gsl_fixed, gsl_fixed, &
      gsl_motion, gsl_motion]
   real(wp), dimension(points) :: u, m, cn, dn
   real(wp) :: values(points, size(names)), times(repeats, size(names)), best(size(names))
   type(modulus) :: p
   type(motion) :: path
   type(pendulum) :: body
   integer :: i, j, repeat

   call random_number(u)
   call random_number(m)
   u = 6.0_wp*u
   p = modulus_from_m(0.7_wp)
   body%gravity = 9.8_wp
   path = body%swinging(1.0_wp)
   do repeat = 1, repeats
      do i = 1, size(names)
         times(repeat, i) = time_of(i, values(:, i))
      end do
   end do
   call check_values()
   best = minval(times, 1)
   print '(a)', '| | least | median | GSL / this, least | GSL / this, median |', '|---|---|---|---|---|'
   do i = 1, size(names)
      associate (numbers => [best(i), median(times(:, i)), best(against(i))/best(i), &
         median(times(:, against(i))/times(:, i))])
         print '(11a)', '| ', names(i), (' | ', cell(numbers(j), .true.), j=1, 4), ' |'
      end associate
   end do


contains


   !> ns a value of one pass over the points
   function time_of(case, value) result(time)
      integer, intent(in) :: case
      real(wp), intent(out) :: value(:)
      real(wp) :: time
      integer(int64) :: start, finish, rate

      call system_clock(start, rate)
      call compute(case, value)
      call system_clock(finish)
      time = real(finish - start, wp)/real(rate, wp)*1.0e9_wp/points
   end function time_of


   !> sn of all points, or angles
   subroutine compute(case, value)
      integer, intent(in) :: case
      real(wp), intent(out) :: value(:)
      type(modulus) :: q
      real(wp) :: k, omega
      integer(c_int) :: stat
      integer :: j

      stat = 0
      select case (case)
      case (1)
         do j = 1, points
            stat = gsl_elljac(u(j), m(j), value(j), cn(j), dn(j))
         end do
      case (2)
         do j = 1, points
            q = modulus_from_m(m(j))
            call q%jacobi(u(j), value(j), cn(j), dn(j))
         end do
      case (3)
         do j = 1, points
            stat = gsl_elljac(u(j), 0.7_wp, value(j), cn(j), dn(j))
         end do
      case (4)
         call jacobi_m(u, 0.7_wp, value, cn, dn)
      case (5)
         call p%jacobi(u, value, cn, dn)
      case (6)
         do j = 1, points
            call p%jacobi(u(j), value(j), cn(j), dn(j))
         end do
      case (7)
         k = sin(0.5_wp)
         omega = sqrt(9.8_wp)
         do j = 1, points
            stat = gsl_elljac(omega*u(j), k*k, value(j), cn(j), dn(j))
            value(j) = 2*asin(k*value(j))
         end do
      case default
         value = path%angle(u)
      end select
      if (stat /= 0) error stop 1
   end subroutine compute


   !> All must have computed the same, as far as GSL can.
   subroutine check_values()
      integer :: j

      do j = 1, size(names)
         if (.not. all(abs(values(:, j) - values(:, against(j))) <= 1.0e-10_wp)) then
            write(error_unit, '(2a)') 'bench: other values than GSL: ', names(j)
            error stop 1
         end if
      end do
   end subroutine check_values

end program jacobi
