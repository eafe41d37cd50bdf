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
   public :: fgsl_sf_ellint_pcomp, fgsl_sf_ellint_f, fgsl_sf_ellint_e, fgsl_sf_ellint_p
   public :: fgsl_sf_ellint_d, fgsl_sf_ellint_rc, fgsl_sf_ellint_rd, fgsl_sf_ellint_rf
   public :: fgsl_sf_ellint_rj, fgsl_sf_elljac_e


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

      function gsl_sf_ellint_pcomp(k, n, mode) bind(c, name='gsl_sf_ellint_Pcomp')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: k, n
         integer(c_int), value :: mode
         real(c_double) :: gsl_sf_ellint_pcomp
      end function gsl_sf_ellint_pcomp

      function gsl_sf_ellint_f(phi, k, mode) bind(c, name='gsl_sf_ellint_F')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: phi, k
         integer(c_int), value :: mode
         real(c_double) :: gsl_sf_ellint_f
      end function gsl_sf_ellint_f

      function gsl_sf_ellint_e(phi, k, mode) bind(c, name='gsl_sf_ellint_E')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: phi, k
         integer(c_int), value :: mode
         real(c_double) :: gsl_sf_ellint_e
      end function gsl_sf_ellint_e

      function gsl_sf_ellint_p(phi, k, n, mode) bind(c, name='gsl_sf_ellint_P')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: phi, k, n
         integer(c_int), value :: mode
         real(c_double) :: gsl_sf_ellint_p
      end function gsl_sf_ellint_p

      function gsl_sf_ellint_d(phi, k, mode) bind(c, name='gsl_sf_ellint_D')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: phi, k
         integer(c_int), value :: mode
         real(c_double) :: gsl_sf_ellint_d
      end function gsl_sf_ellint_d

      function gsl_sf_ellint_rc(x, y, mode) bind(c, name='gsl_sf_ellint_RC')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: x, y
         integer(c_int), value :: mode
         real(c_double) :: gsl_sf_ellint_rc
      end function gsl_sf_ellint_rc

      function gsl_sf_ellint_rd(x, y, z, mode) bind(c, name='gsl_sf_ellint_RD')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: x, y, z
         integer(c_int), value :: mode
         real(c_double) :: gsl_sf_ellint_rd
      end function gsl_sf_ellint_rd

      function gsl_sf_ellint_rf(x, y, z, mode) bind(c, name='gsl_sf_ellint_RF')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: x, y, z
         integer(c_int), value :: mode
         real(c_double) :: gsl_sf_ellint_rf
      end function gsl_sf_ellint_rf

      function gsl_sf_ellint_rj(x, y, z, p, mode) bind(c, name='gsl_sf_ellint_RJ')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: x, y, z, p
         integer(c_int), value :: mode
         real(c_double) :: gsl_sf_ellint_rj
      end function gsl_sf_ellint_rj

      function gsl_sf_elljac_e(u, m, sn, cn, dn) bind(c)
         import :: c_double, c_int
         implicit none
         real(c_double), value :: u, m
         real(c_double), intent(out) :: sn, cn, dn
         integer(c_int) :: gsl_sf_elljac_e
      end function gsl_sf_elljac_e
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


   function fgsl_sf_ellint_pcomp(k, n, mode) result(value)
      real(fgsl_double), intent(in) :: k
      real(fgsl_double), intent(in) :: n
      type(fgsl_mode_t), intent(in) :: mode
      real(fgsl_double) :: value

      value = gsl_sf_ellint_pcomp(k, n, mode%gsl_mode)
   end function fgsl_sf_ellint_pcomp


   function fgsl_sf_ellint_f(phi, k, mode) result(value)
      real(fgsl_double), intent(in) :: phi
      real(fgsl_double), intent(in) :: k
      type(fgsl_mode_t), intent(in) :: mode
      real(fgsl_double) :: value

      value = gsl_sf_ellint_f(phi, k, mode%gsl_mode)
   end function fgsl_sf_ellint_f


   function fgsl_sf_ellint_e(phi, k, mode) result(value)
      real(fgsl_double), intent(in) :: phi
      real(fgsl_double), intent(in) :: k
      type(fgsl_mode_t), intent(in) :: mode
      real(fgsl_double) :: value

      value = gsl_sf_ellint_e(phi, k, mode%gsl_mode)
   end function fgsl_sf_ellint_e


   function fgsl_sf_ellint_p(phi, k, n, mode) result(value)
      real(fgsl_double), intent(in) :: phi
      real(fgsl_double), intent(in) :: k
      real(fgsl_double), intent(in) :: n
      type(fgsl_mode_t), intent(in) :: mode
      real(fgsl_double) :: value

      value = gsl_sf_ellint_p(phi, k, n, mode%gsl_mode)
   end function fgsl_sf_ellint_p


   function fgsl_sf_ellint_d(phi, k, mode) result(value)
      real(fgsl_double), intent(in) :: phi
      real(fgsl_double), intent(in) :: k
      type(fgsl_mode_t), intent(in) :: mode
      real(fgsl_double) :: value

      value = gsl_sf_ellint_d(phi, k, mode%gsl_mode)
   end function fgsl_sf_ellint_d


   function fgsl_sf_ellint_rc(x, y, mode) result(value)
      real(fgsl_double), intent(in) :: x
      real(fgsl_double), intent(in) :: y
      type(fgsl_mode_t), intent(in) :: mode
      real(fgsl_double) :: value

      value = gsl_sf_ellint_rc(x, y, mode%gsl_mode)
   end function fgsl_sf_ellint_rc


   function fgsl_sf_ellint_rd(x, y, z, mode) result(value)
      real(fgsl_double), intent(in) :: x
      real(fgsl_double), intent(in) :: y
      real(fgsl_double), intent(in) :: z
      type(fgsl_mode_t), intent(in) :: mode
      real(fgsl_double) :: value

      value = gsl_sf_ellint_rd(x, y, z, mode%gsl_mode)
   end function fgsl_sf_ellint_rd


   function fgsl_sf_ellint_rf(x, y, z, mode) result(value)
      real(fgsl_double), intent(in) :: x
      real(fgsl_double), intent(in) :: y
      real(fgsl_double), intent(in) :: z
      type(fgsl_mode_t), intent(in) :: mode
      real(fgsl_double) :: value

      value = gsl_sf_ellint_rf(x, y, z, mode%gsl_mode)
   end function fgsl_sf_ellint_rf


   function fgsl_sf_ellint_rj(x, y, z, p, mode) result(value)
      real(fgsl_double), intent(in) :: x
      real(fgsl_double), intent(in) :: y
      real(fgsl_double), intent(in) :: z
      real(fgsl_double), intent(in) :: p
      type(fgsl_mode_t), intent(in) :: mode
      real(fgsl_double) :: value

      value = gsl_sf_ellint_rj(x, y, z, p, mode%gsl_mode)
   end function fgsl_sf_ellint_rj


   !> m is the parameter here
   function fgsl_sf_elljac_e(u, m, sn, cn, dn) result(status)
      real(fgsl_double), intent(in) :: u
      real(fgsl_double), intent(in) :: m
      real(fgsl_double), intent(out) :: sn
      real(fgsl_double), intent(out) :: cn
      real(fgsl_double), intent(out) :: dn
      integer(fgsl_int) :: status

      status = gsl_sf_elljac_e(u, m, sn, cn, dn)
   end function fgsl_sf_elljac_e

end module fgsl
