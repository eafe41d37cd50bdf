! SPDX-License-Identifier: MIT

!> GSL's Runge-Kutta of fixed step on the pendulum, theta'' = -sin(theta): by its driver, and by its
!> bare step function. Each of its steps is two half steps and, for the error estimate, a whole one.
module bench_odeiv2
   use, intrinsic :: iso_c_binding, only : c_double, c_funloc, c_funptr, c_int, c_long, c_null_ptr, &
      c_ptr, c_size_t
   implicit none
   private
   public :: gsl_driver, gsl_steps
   public :: gsl_rk4 ! were it private, gfortran would not look for GSL's


   type, bind(c) :: gsl_system
      type(c_funptr) :: rates
      type(c_ptr) :: jacobian
      integer(c_size_t) :: dimension
      type(c_ptr) :: parameters
   end type gsl_system

   type(c_ptr), bind(c, name='gsl_odeiv2_step_rk4') :: gsl_rk4

   interface
      function driver_alloc(system, method, h, absolute, relative) result(driver) &
         bind(c, name='gsl_odeiv2_driver_alloc_y_new')
         import :: c_double, c_ptr, gsl_system
         implicit none
         type(gsl_system), intent(in) :: system
         type(c_ptr), value :: method
         real(c_double), value :: h, absolute, relative
         type(c_ptr) :: driver
      end function driver_alloc

      function driver_apply(driver, t, h, steps, y) result(status) &
         bind(c, name='gsl_odeiv2_driver_apply_fixed_step')
         import :: c_double, c_int, c_long, c_ptr
         implicit none
         type(c_ptr), value :: driver
         real(c_double), intent(inout) :: t
         real(c_double), value :: h
         integer(c_long), value :: steps
         real(c_double), intent(inout) :: y(2)
         integer(c_int) :: status
      end function driver_apply

      subroutine driver_free(driver) bind(c, name='gsl_odeiv2_driver_free')
         import :: c_ptr
         implicit none
         type(c_ptr), value :: driver
      end subroutine driver_free

      function step_alloc(method, dimension) result(step) bind(c, name='gsl_odeiv2_step_alloc')
         import :: c_ptr, c_size_t
         implicit none
         type(c_ptr), value :: method
         integer(c_size_t), value :: dimension
         type(c_ptr) :: step
      end function step_alloc

      function step_apply(step, t, h, y, y_error, rate_in, rate_out, system) result(status) &
         bind(c, name='gsl_odeiv2_step_apply')
         import :: c_double, c_int, c_ptr, gsl_system
         implicit none
         type(c_ptr), value :: step
         real(c_double), value :: t, h
         real(c_double), intent(inout) :: y(2), y_error(2)
         type(c_ptr), value :: rate_in, rate_out
         type(gsl_system), intent(in) :: system
         integer(c_int) :: status
      end function step_apply

      subroutine step_free(step) bind(c, name='gsl_odeiv2_step_free')
         import :: c_ptr
         implicit none
         type(c_ptr), value :: step
      end subroutine step_free
   end interface


contains


   function pendulum(t, y, rate, parameters) result(status) bind(c)
      real(c_double), value :: t
      real(c_double), intent(in) :: y(2)
      real(c_double), intent(out) :: rate(2)
      type(c_ptr), value :: parameters
      integer(c_int) :: status

      rate(1) = y(2)
      rate(2) = -sin(y(1))
      status = 0
   end function pendulum


   !> `steps` steps of h by the driver
   subroutine gsl_driver(h, steps, y)
      real(c_double), intent(in) :: h
      integer, intent(in) :: steps
      real(c_double), intent(inout) :: y(2)
      type(gsl_system) :: system
      type(c_ptr) :: driver
      real(c_double) :: t

      system = gsl_system(c_funloc(pendulum), c_null_ptr, 2_c_size_t, c_null_ptr)
      driver = driver_alloc(system, gsl_rk4, h, 1.0_c_double, 0.0_c_double)
      t = 0
      if (driver_apply(driver, t, h, int(steps, c_long), y) /= 0) y = 0
      call driver_free(driver)
   end subroutine gsl_driver


   !> `steps` steps of h, one by one
   subroutine gsl_steps(h, steps, y)
      real(c_double), intent(in) :: h
      integer, intent(in) :: steps
      real(c_double), intent(inout) :: y(2)
      type(gsl_system) :: system
      type(c_ptr) :: step
      real(c_double) :: y_error(2)
      integer :: i

      system = gsl_system(c_funloc(pendulum), c_null_ptr, 2_c_size_t, c_null_ptr)
      step = step_alloc(gsl_rk4, 2_c_size_t)
      do i = 0, steps - 1
         if (step_apply(step, i*h, h, y, y_error, c_null_ptr, c_null_ptr, system) /= 0) y = 0
      end do
      call step_free(step)
   end subroutine gsl_steps

end module bench_odeiv2
