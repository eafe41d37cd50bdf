! SPDX-License-Identifier: MIT

!> The part of FGSL 1.6.0 that the tests call, over libgsl itself: the same names and signatures,
!> so that the tests compile unchanged where a full FGSL is installed (see CONTRIBUTING.md).
module fgsl
   use, intrinsic :: iso_c_binding, only : c_double, c_funptr, c_int
   implicit none
   private
   public :: fgsl_double, fgsl_int
   public :: fgsl_mode_t, fgsl_prec_double, fgsl_prec_single, fgsl_prec_approx
   public :: fgsl_sf_result, fgsl_error_handler_t, fgsl_success, fgsl_edom
   public :: fgsl_set_error_handler_off
   public :: fgsl_sf_ellint_kcomp, fgsl_sf_ellint_kcomp_e
   public :: fgsl_sf_ellint_ecomp, fgsl_sf_ellint_ecomp_e


   integer, parameter :: fgsl_double = c_double
   integer, parameter :: fgsl_int = c_int

   !> How many digits GSL is to give
   type :: fgsl_mode_t
      integer(c_int) :: gsl_mode = 0
   end type fgsl_mode_t

   type(fgsl_mode_t), parameter :: fgsl_prec_double = fgsl_mode_t(0)
   type(fgsl_mode_t), parameter :: fgsl_prec_single = fgsl_mode_t(1)
   type(fgsl_mode_t), parameter :: fgsl_prec_approx = fgsl_mode_t(2)

   !> A value with GSL's estimate of its error
   type, bind(c) :: fgsl_sf_result
      real(c_double) :: val
      real(c_double) :: err
   end type fgsl_sf_result

   type :: fgsl_error_handler_t
      private
      type(c_funptr) :: gsl_error_handler
   end type fgsl_error_handler_t

   integer(fgsl_int), parameter :: fgsl_success = 0
   integer(fgsl_int), parameter :: fgsl_edom = 1


   interface
      function gsl_set_error_handler_off() bind(c)
         import :: c_funptr
         implicit none
         type(c_funptr) :: gsl_set_error_handler_off
      end function gsl_set_error_handler_off

      function gsl_sf_ellint_kcomp(k, mode) bind(c, name='gsl_sf_ellint_Kcomp')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: k
         integer(c_int), value :: mode
         real(c_double) :: gsl_sf_ellint_kcomp
      end function gsl_sf_ellint_kcomp

      function gsl_sf_ellint_kcomp_e(k, mode, result) bind(c, name='gsl_sf_ellint_Kcomp_e')
         import :: c_double, c_int, fgsl_sf_result
         implicit none
         real(c_double), value :: k
         integer(c_int), value :: mode
         type(fgsl_sf_result), intent(out) :: result
         integer(c_int) :: gsl_sf_ellint_kcomp_e
      end function gsl_sf_ellint_kcomp_e

      function gsl_sf_ellint_ecomp(k, mode) bind(c, name='gsl_sf_ellint_Ecomp')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: k
         integer(c_int), value :: mode
         real(c_double) :: gsl_sf_ellint_ecomp
      end function gsl_sf_ellint_ecomp

      function gsl_sf_ellint_ecomp_e(k, mode, result) bind(c, name='gsl_sf_ellint_Ecomp_e')
         import :: c_double, c_int, fgsl_sf_result
         implicit none
         real(c_double), value :: k
         integer(c_int), value :: mode
         type(fgsl_sf_result), intent(out) :: result
         integer(c_int) :: gsl_sf_ellint_ecomp_e
      end function gsl_sf_ellint_ecomp_e
   end interface


contains


   !> GSL's default handler aborts the program at the first domain error.
   function fgsl_set_error_handler_off() result(previous)
      type(fgsl_error_handler_t) :: previous

      previous%gsl_error_handler = gsl_set_error_handler_off()
   end function fgsl_set_error_handler_off


   function fgsl_sf_ellint_kcomp(k, mode) result(value)
      real(fgsl_double), intent(in) :: k
      type(fgsl_mode_t), intent(in) :: mode
      real(fgsl_double) :: value

      value = gsl_sf_ellint_kcomp(k, mode%gsl_mode)
   end function fgsl_sf_ellint_kcomp


   function fgsl_sf_ellint_kcomp_e(k, mode, result) result(status)
      real(fgsl_double), intent(in) :: k
      type(fgsl_mode_t), intent(in) :: mode
      type(fgsl_sf_result), intent(out) :: result
      integer(fgsl_int) :: status

      status = gsl_sf_ellint_kcomp_e(k, mode%gsl_mode, result)
   end function fgsl_sf_ellint_kcomp_e


   function fgsl_sf_ellint_ecomp(k, mode) result(value)
      real(fgsl_double), intent(in) :: k
      type(fgsl_mode_t), intent(in) :: mode
      real(fgsl_double) :: value

      value = gsl_sf_ellint_ecomp(k, mode%gsl_mode)
   end function fgsl_sf_ellint_ecomp


   function fgsl_sf_ellint_ecomp_e(k, mode, result) result(status)
      real(fgsl_double), intent(in) :: k
      type(fgsl_mode_t), intent(in) :: mode
      type(fgsl_sf_result), intent(out) :: result
      integer(fgsl_int) :: status

      status = gsl_sf_ellint_ecomp_e(k, mode%gsl_mode, result)
   end function fgsl_sf_ellint_ecomp_e

end module fgsl
