! SPDX-License-Identifier: MIT

!> The functions of the benchmark's table, called by their numbers: furiko's, one at a time and arrays, and
!> the peers'. Arguments: of Legendre's integrals phi, m (k for GSL and Boost), n; of Jacobi's functions u,
!> m; of Carlson's forms x, y, z, p.
module bench_calls
   use, intrinsic :: iso_c_binding, only : c_int
   use, intrinsic :: iso_fortran_env, only : wp => real64
   ! allow(C121)
   use bench_peers
   use furiko, only : carlson_rc, carlson_rd, carlson_rf, carlson_rg, carlson_rj, ellipb_m, ellipd_m, &
      ellipdinc_m, ellipe_m, ellipeinc_m, ellipf_m, ellipk_m, ellipke_m, ellippi_m, ellippiinc_m, &
      heuman_lambda_m, jacobi_am_m, jacobi_epsilon_m, jacobi_m, jacobi_zeta_m, nome_m
   implicit none
   private
   public :: arrays_of, call_of, can, classes, names
   public :: us, gsl, boost, scipy
   public :: complete, legendre, carlson, jacobi


   integer, parameter :: us = 1, gsl = 2, boost = 3, scipy = 4
   integer, parameter :: complete = 1, legendre = 2, carlson = 3, jacobi = 4
   character(len=*), parameter :: names(*) = [character(len=14) :: &
      'K(m)', 'E(m)', 'K and E', 'B(m)', 'D(m)', 'Pi(n, m)', 'nome(m)', &
      'F(phi, m)', 'E(phi, m)', 'D(phi, m)', 'Pi(n, phi, m)', 'zeta(phi, m)', 'lambda(phi, m)', &
      'RC(x, y)', 'RF(x, y, z)', 'RD(x, y, z)', 'RG(x, y, z)', 'RJ(x, y, z, p)', &
      'sn, cn, dn', 'am(u, m)', 'epsilon(u, m)']
   integer, parameter :: lambda = 13, amplitude = 20
   integer, parameter :: classes(*) = [ &
      complete, complete, complete, complete, complete, complete, complete, &
      legendre, legendre, legendre, legendre, legendre, legendre, &
      carlson, carlson, carlson, carlson, carlson, jacobi, jacobi, jacobi]
   !> Who has which: furiko, GSL, Boost, SciPy
   character(len=*), parameter :: owners(*) = [character(len=4) :: &
      'fgbs', 'fgbs', 'fgbs', 'f', 'fgb', 'fgb', 'f', &
      'fgbs', 'fgbs', 'fgb', 'fgb', 'fb', 'fb', &
      'fgbs', 'fgbs', 'fgbs', 'fbs', 'fgbs', 'fgbs', 'fs', 'f']


contains


   !> Whether one has this function, for all these parameters: GSL and Boost take k and so m >= 0, but for
   !> GSL's sn, cn, dn; SciPy's take m in [0, 1]; lambda is of m >= 0, Boost's ends in an exception next to 1
   pure function can(which, who, m)
      integer, intent(in) :: which, who
      real(wp), intent(in) :: m(:)
      logical :: can
      character(len=*), parameter :: letters = 'fgbs'

      can = index(owners(which), letters(who:who)) > 0
      if (classes(which) == carlson) return
      if (which == lambda) can = can .and. minval(m) >= 0
      if (who == us) return
      if (minval(m) < 0) can = can .and. merge(who == gsl, who == scipy, classes(which) == jacobi)
      if (which == lambda .and. maxval(m) > 1 - 1.0e-9_wp) can = .false.
   end function can


   function call_of(which, who, a, b, c, d) result(value)
      integer, intent(in) :: which, who
      real(wp), intent(in) :: a, b, c, d
      real(wp) :: value

      select case (who)
      case (us)
         value = ours(which, a, b, c, d)
      case (gsl)
         value = gsl_value(which, a, b, c, d)
      case (boost)
         value = boost_value(which, a, b, c, d)
      case default
         value = scipy_value(which, a, b, c, d)
      end select
   end function call_of


   function ours(which, a, b, c, d) result(value)
      integer, intent(in) :: which
      real(wp), intent(in) :: a, b, c, d
      real(wp) :: value
      real(wp) :: second, third

      include 'bench_calls.inc'
   end function ours


   subroutine arrays_of(which, a, b, c, d, value)
      integer, intent(in) :: which
      real(wp), dimension(:), contiguous, intent(in) :: a, b, c, d
      real(wp), contiguous, intent(out) :: value(:)
      real(wp), dimension(size(a)) :: second, third

      include 'bench_calls.inc'
   end subroutine arrays_of


   function gsl_value(which, a, b, c, d) result(value)
      integer, intent(in) :: which
      real(wp), intent(in) :: a, b, c, d
      real(wp) :: value
      real(wp) :: cn, dn
      integer(c_int) :: stat

      select case (which)
      case (1)
         value = gsl_k(b, 0)
      case (2)
         value = gsl_e(b, 0)
      case (3)
         value = gsl_k(b, 0) + gsl_e(b, 0)
      case (5)
         value = gsl_d(b, 0)
      case (6)
         value = gsl_pi(b, -c, 0)
      case (8)
         value = gsl_f(a, b, 0)
      case (9)
         value = gsl_einc(a, b, 0)
      case (10)
         value = gsl_dinc(a, b, 0)
      case (11)
         value = gsl_piinc(a, b, -c, 0)
      case (14)
         value = gsl_rc(a, b, 0)
      case (15)
         value = gsl_rf(a, b, c, 0)
      case (16)
         value = gsl_rd(a, b, c, 0)
      case (18)
         value = gsl_rj(a, b, c, d, 0)
      case default
         stat = gsl_elljac(a, b, value, cn, dn)
         value = value + cn + dn
         if (stat /= 0) value = 0
      end select
   end function gsl_value


   function boost_value(which, a, b, c, d) result(value)
      integer, intent(in) :: which
      real(wp), intent(in) :: a, b, c, d
      real(wp) :: value
      real(wp) :: cn, dn

      select case (which)
      case (1)
         value = boost_k(b)
      case (2)
         value = boost_e(b)
      case (3)
         value = boost_k(b) + boost_e(b)
      case (5)
         value = boost_d(b)
      case (6)
         value = boost_pi(b, c)
      case (8)
         value = boost_f(a, b)
      case (9)
         value = boost_einc(a, b)
      case (10)
         value = boost_dinc(a, b)
      case (11)
         value = boost_piinc(a, b, c)
      case (12)
         value = boost_zeta(a, b)
      case (13)
         value = boost_lambda(a, b)
      case (14)
         value = boost_rc(a, b)
      case (15)
         value = boost_rf(a, b, c)
      case (16)
         value = boost_rd(a, b, c)
      case (17)
         value = boost_rg(a, b, c)
      case (18)
         value = boost_rj(a, b, c, d)
      case default
         value = boost_jacobi(b, a, cn, dn)
         value = value + cn + dn
      end select
   end function boost_value


   function scipy_value(which, a, b, c, d) result(value)
      integer, intent(in) :: which
      real(wp), intent(in) :: a, b, c, d
      real(wp) :: value
      real(wp) :: cn, dn, am

      select case (which)
      case (1)
         value = scipy_k(b)
      case (2)
         value = scipy_e(b)
      case (3)
         value = scipy_k(b) + scipy_e(b)
      case (8)
         value = scipy_f(a, b)
      case (9)
         value = scipy_einc(a, b)
      case (14)
         value = scipy_rc(a, b)
      case (15)
         value = scipy_rf(a, b, c)
      case (16)
         value = scipy_rd(a, b, c)
      case (17)
         value = scipy_rg(a, b, c)
      case (18)
         value = scipy_rj(a, b, c, d)
      case default
         call scipy_jacobi(a, b, value, cn, dn, am)
         value = value + cn + dn
         if (which == amplitude) value = am
      end select
   end function scipy_value

end module bench_calls
! rooms: 117567037
