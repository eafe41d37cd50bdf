! SPDX-License-Identifier: MIT

!> The peers' C functions: GSL's (mode 0 is full double precision) and, through boost_peer.cpp and
!> scipy_peer.cpp, Boost's and SciPy's. GSL and Boost take the modulus k (gsl_elljac m), SciPy takes m;
!> GSL's n has the opposite sign.
module bench_peers
   use, intrinsic :: iso_c_binding, only : c_double, c_int
   implicit none
   private
   public :: gsl_k, boost_k, scipy_k
   public :: gsl_e, boost_e, scipy_e
   public :: gsl_d, boost_d
   public :: gsl_pi, boost_pi
   public :: gsl_f, boost_f, scipy_f
   public :: gsl_einc, boost_einc, scipy_einc
   public :: gsl_dinc, boost_dinc
   public :: gsl_piinc, boost_piinc
   public :: gsl_rf, boost_rf, scipy_rf
   public :: gsl_rc, boost_rc, scipy_rc
   public :: gsl_rd, boost_rd, scipy_rd
   public :: gsl_rj, boost_rj, scipy_rj
   public :: boost_rg, scipy_rg
   public :: gsl_elljac, boost_jacobi, scipy_jacobi
   public :: boost_zeta, boost_lambda
   public :: has_boost, has_scipy


   interface
      function gsl_k(k, mode) result(value) bind(c, name='gsl_sf_ellint_Kcomp')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: k
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_k

      function boost_k(k) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: k
         real(c_double) :: value
      end function boost_k

      function gsl_e(k, mode) result(value) bind(c, name='gsl_sf_ellint_Ecomp')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: k
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_e

      function boost_e(k) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: k
         real(c_double) :: value
      end function boost_e

      function gsl_d(k, mode) result(value) bind(c, name='gsl_sf_ellint_Dcomp')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: k
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_d

      function boost_d(k) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: k
         real(c_double) :: value
      end function boost_d

      function gsl_pi(k, n, mode) result(value) bind(c, name='gsl_sf_ellint_Pcomp')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: k, n
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_pi

      function boost_pi(k, n) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: k, n
         real(c_double) :: value
      end function boost_pi

      function gsl_f(phi, k, mode) result(value) bind(c, name='gsl_sf_ellint_F')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: phi, k
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_f

      function boost_f(phi, k) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: phi, k
         real(c_double) :: value
      end function boost_f

      function gsl_einc(phi, k, mode) result(value) bind(c, name='gsl_sf_ellint_E')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: phi, k
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_einc

      function boost_einc(phi, k) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: phi, k
         real(c_double) :: value
      end function boost_einc

      function gsl_dinc(phi, k, mode) result(value) bind(c, name='gsl_sf_ellint_D')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: phi, k
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_dinc

      function boost_dinc(phi, k) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: phi, k
         real(c_double) :: value
      end function boost_dinc

      function gsl_piinc(phi, k, n, mode) result(value) bind(c, name='gsl_sf_ellint_P')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: phi, k, n
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_piinc

      function boost_piinc(phi, k, n) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: phi, k, n
         real(c_double) :: value
      end function boost_piinc

      function gsl_rf(x, y, z, mode) result(value) bind(c, name='gsl_sf_ellint_RF')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: x, y, z
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_rf

      function boost_rf(x, y, z) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: x, y, z
         real(c_double) :: value
      end function boost_rf

      function gsl_rc(x, y, mode) result(value) bind(c, name='gsl_sf_ellint_RC')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: x, y
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_rc

      function boost_rc(x, y) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: x, y
         real(c_double) :: value
      end function boost_rc

      function gsl_rd(x, y, z, mode) result(value) bind(c, name='gsl_sf_ellint_RD')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: x, y, z
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_rd

      function boost_rd(x, y, z) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: x, y, z
         real(c_double) :: value
      end function boost_rd

      function gsl_rj(x, y, z, p, mode) result(value) bind(c, name='gsl_sf_ellint_RJ')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: x, y, z, p
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_rj

      function boost_rj(x, y, z, p) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: x, y, z, p
         real(c_double) :: value
      end function boost_rj

      !> Takes m = k^2
      function gsl_elljac(u, m, sn, cn, dn) result(stat) bind(c, name='gsl_sf_elljac_e')
         import :: c_double, c_int
         implicit none
         real(c_double), value :: u
         real(c_double), value :: m
         real(c_double), intent(out) :: sn
         real(c_double), intent(out) :: cn
         real(c_double), intent(out) :: dn
         integer(c_int) :: stat
      end function gsl_elljac

      function boost_jacobi(k, u, cn, dn) result(sn) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: k
         real(c_double), value :: u
         real(c_double), intent(out) :: cn
         real(c_double), intent(out) :: dn
         real(c_double) :: sn
      end function boost_jacobi

      function boost_rg(x, y, z) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: x, y, z
         real(c_double) :: value
      end function boost_rg

      function boost_zeta(phi, k) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: phi, k
         real(c_double) :: value
      end function boost_zeta

      function boost_lambda(phi, k) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: phi, k
         real(c_double) :: value
      end function boost_lambda

      function scipy_k(m) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: m
         real(c_double) :: value
      end function scipy_k

      function scipy_e(m) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: m
         real(c_double) :: value
      end function scipy_e

      function scipy_f(phi, m) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: phi, m
         real(c_double) :: value
      end function scipy_f

      function scipy_einc(phi, m) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: phi, m
         real(c_double) :: value
      end function scipy_einc

      function scipy_rc(x, y) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: x, y
         real(c_double) :: value
      end function scipy_rc

      function scipy_rf(x, y, z) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: x, y, z
         real(c_double) :: value
      end function scipy_rf

      function scipy_rd(x, y, z) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: x, y, z
         real(c_double) :: value
      end function scipy_rd

      function scipy_rg(x, y, z) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: x, y, z
         real(c_double) :: value
      end function scipy_rg

      function scipy_rj(x, y, z, p) result(value) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: x, y, z, p
         real(c_double) :: value
      end function scipy_rj

      !> The amplitude, too
      subroutine scipy_jacobi(u, m, sn, cn, dn, am) bind(c)
         import :: c_double
         implicit none
         real(c_double), value :: u, m
         real(c_double), intent(out) :: sn, cn, dn, am
      end subroutine scipy_jacobi

      function scipy_is_there() result(yes) bind(c)
         import :: c_int
         implicit none
         integer(c_int) :: yes
      end function scipy_is_there
   end interface


contains


   !> Whether Boost is installed: without it all its functions are NaN
   function has_boost()
      logical :: has_boost

      has_boost = boost_k(0.5_c_double) > 0.0_c_double
   end function has_boost


   !> Whether SciPy was asked for and is there: without it none of its functions may be called
   function has_scipy()
      logical :: has_scipy

      has_scipy = scipy_is_there() /= 0_c_int
   end function has_scipy

end module bench_peers
