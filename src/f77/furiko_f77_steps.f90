! SPDX-License-Identifier: MIT

!> For Fortran 77: Runge-Kutta, Verlet and Forest-Ruth steps with the caller's EXTERNAL.
module furiko_f77_steps
   use, intrinsic :: iso_c_binding, only : c_f_procpointer, c_funloc, c_funptr, wp => c_double
   use furiko_rk4, only : rk4
   use furiko_symplectic, only : forest_ruth, verlet
   implicit none
   public

   ! `bind(c)` lets their addresses be taken; what goes by reference, as all does here, goes as in Fortran 77.
   abstract interface
      !> The caller's y' = f(t, y)
      subroutine caller_rates(t, y, dy) bind(c)
         import :: wp
         implicit none
         real(wp), intent(in) :: t
         real(wp), intent(in) :: y(*)
         real(wp), intent(out) :: dy(*)
      end subroutine caller_rates
      !> The caller's x'' = a(x)
      subroutine caller_acceleration(x, a) bind(c)
         import :: wp
         implicit none
         real(wp), intent(in) :: x(*)
         real(wp), intent(out) :: a(*)
      end subroutine caller_acceleration
   end interface


contains


   !> The right-hand side for [[rk4]]: the caller's, whose address comes as bits through `parameters`. No
   !> internal procedure is handed over, which would need code on the stack.
   subroutine call_rates(t, y, parameters, rate)
      real(wp), intent(in) :: t
      real(wp), intent(in) :: y(:)
      real(wp), intent(in) :: parameters(:)
      real(wp), intent(out) :: rate(:)
      procedure(caller_rates), pointer :: f
      type(c_funptr) :: address

      address = transfer(parameters, address)
      call c_f_procpointer(address, f)
      call f(t, y, rate)
   end subroutine call_rates


   !> The same for [[verlet]] and [[forest_ruth]]
   subroutine call_acceleration(x, parameters, a)
      real(wp), intent(in) :: x(:)
      real(wp), intent(in) :: parameters(:)
      real(wp), intent(out) :: a(:)
      procedure(caller_acceleration), pointer :: f
      type(c_funptr) :: address

      address = transfer(parameters, address)
      call c_f_procpointer(address, f)
      call f(x, a)
   end subroutine call_acceleration

end module furiko_f77_steps


include 'furiko_f77_steps.inc'
! rooms: 2885506967
