! SPDX-License-Identifier: MIT

!> What `tools/count_instructions.py` counts the instructions of: valgrind writes what there were whenever one
!> of the procedures count_* ends. In real32, real64 and real128; objects in real64.
module bench_counts_sp
   use, intrinsic :: iso_fortran_env, only : dp => real64, wp => real32
   use furiko_by_name, only : evaluate
   implicit none
   private
   include 'bench_counts.inc'
end module bench_counts_sp


module bench_counts_dp
   use, intrinsic :: iso_fortran_env, only : dp => real64, wp => real64
   use furiko_by_name, only : evaluate
   implicit none
   private
   include 'bench_counts.inc'
end module bench_counts_dp


#ifdef __GFC_REAL_16__
module bench_counts_qp
   use, intrinsic :: iso_fortran_env, only : dp => real64, wp => real128
   use furiko_by_name, only : evaluate
   implicit none
   private
   include 'bench_counts.inc'
end module bench_counts_qp
#endif


module bench_counts_objects
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : modulus, modulus_from_amplitude, modulus_from_m, motion, pendulum, &
      pendulum_forest_ruth, pendulum_rk4, pendulum_verlet
   implicit none
   private
   public :: count_object, objects


   character(len=*), parameter :: objects(*) = [character(len=32) :: 'modulus_from_m', &
      'modulus_from_amplitude', 'modulus%jacobi', 'modulus%jacobi, arrays', 'pendulum%released', &
      'motion%angle', 'motion%angle, arrays', 'motion%rate, arrays', 'motion%tension, arrays', &
      'motion%time_to', 'pendulum_rk4', 'pendulum_rk4, many', 'pendulum_verlet, many', &
      'pendulum_forest_ruth, many']


contains


   !> One of them at each point: times or arguments u, parameters m
   subroutine count_object(which, p, path, u, m, y)
      integer, intent(in) :: which
      type(modulus), intent(in) :: p
      type(motion), intent(in) :: path
      real(wp), intent(in) :: u(:), m(:)
      real(wp), intent(out) :: y(:)
      type(modulus) :: other
      type(motion) :: swing
      type(pendulum) :: body
      real(wp), dimension(size(u)) :: second, third
      integer :: j

      y = u
      second = 0
      select case (which)
      case (1)
         do j = 1, size(u)
            other = modulus_from_m(m(j))
            y(j) = other%ellipk()
         end do
      case (2)
         do j = 1, size(u)
            other = modulus_from_amplitude(3*m(j))
            y(j) = other%ellipk()
         end do
      case (3)
         do j = 1, size(u)
            call p%jacobi(u(j), y(j), second(j), third(j))
         end do
      case (4)
         call p%jacobi(u, y, second, third)
      case (5)
         do j = 1, size(u)
            swing = body%released(3*m(j))
            y(j) = swing%period()
         end do
      case (6)
         do j = 1, size(u)
            y(j) = path%angle(u(j))
         end do
      case (7)
         y = path%angle(u)
      case (8)
         y = path%rate(u)
      case (9)
         y = path%tension(u)
      case (10)
         do j = 1, size(u)
            y(j) = path%time_to(m(j))
         end do
      case (11)
         do j = 1, size(u)
            call pendulum_rk4(1.0_wp, 0.01_wp, 10, y(j), second(j))
         end do
      case (12)
         call pendulum_rk4(1.0_wp, 0.01_wp, 10, y, second)
      case (13)
         call pendulum_verlet(1.0_wp, 0.01_wp, 10, y, second)
      case default
         call pendulum_forest_ruth(1.0_wp, 0.01_wp, 10, y, second)
      end select
   end subroutine count_object

end module bench_counts_objects
! rooms: 12117073
