! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Legendre integrals in words from words, for blocks of lanes. Internal.
module furiko_legendre_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64, ip => int64
   use furiko_bits_dp, only : infinity, nan
   use furiko_edges_dp, only : legendre_at_edge, legendre_far => legendre_at_edge, &
      complete_third_far => complete_third_at_edge, &
      first, second, second_d, third, by_k, by_m, by_mc
   use furiko_fold_dp, only : fold
   use furiko_duplication_dp, only : lanes, rf_of_roots, rd_of_roots, rj_of_roots
   implicit none
   private
   include 'furiko_legendre.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_is_nan.inc'
end module furiko_legendre_dp


module furiko_legendre_sp
   use, intrinsic :: iso_fortran_env, only : real64, wp => real32, ip => int32
   use furiko_bits_sp, only : infinity, nan
   use furiko_edges_sp, only : legendre_at_edge, &
      first, second, second_d, third, by_k, by_m, by_mc
   use furiko_fold_sp, only : fold
   use furiko_legendre_dp, only : double_integral => integral_of_one, double_third => complete_third_of_one
   use furiko_duplication_sp, only : lanes, rf_of_roots, rd_of_roots, rj_of_roots
   implicit none
   private
   include 'furiko_legendre.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_head.inc'
   include '../arithmetic/furiko_is_nan.inc'


   !> Arguments too far out for single words, but for those that may be next to an edge, are nothing
   !> special in double precision
   elemental function legendre_far(which, form, phi, x, v) result(f)
      integer, intent(in) :: which, form
      real(wp), intent(in) :: phi, x, v
      real(wp) :: f
      if (complement(form, x) < 0.0_wp .or. v > 1.0_wp) then
         f = legendre_at_edge(which, form, phi, x, v)
      else
         f = real(double_integral(which, form, real(phi, real64), real(x, real64), real(v, real64)), wp)
      end if
   end function legendre_far


   elemental function complete_third_far(form, v, x) result(f)
      integer, intent(in) :: form
      real(wp), intent(in) :: v, x
      real(wp) :: f
      f = real(double_third(form, real(v, real64), real(x, real64)), wp)
   end function complete_third_far
end module furiko_legendre_sp


#ifdef FURIKO_REAL128
module furiko_legendre_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : head, infinity, is_nan, nan
   use furiko_edges_qp, only : legendre_at_edge, legendre_far => legendre_at_edge, &
      complete_third_far => complete_third_at_edge, &
      first, second, second_d, third, by_k, by_m, by_mc
   use furiko_fold_qp, only : fold
   use furiko_duplication_qp, only : lanes, rf_of_roots, rd_of_roots, rj_of_roots
   implicit none
   private
   include 'furiko_legendre.inc'
end module furiko_legendre_qp
#endif
! rooms: 3229838482
