! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Carlson's and Legendre's integrals in long numbers, for the arguments where words do not do:
!> next to poles and edges, and spread over the exponent range. A tenth of a millisecond each. Internal.
module furiko_edges_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_bits_sp, only : infinity, nan
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_long_sp, only : long, words_bits, to_long, value, magnitude, sign_of, fold, sqrt, scale, &
      operator(+), operator(-), operator(*), operator(/), operator(<)
   implicit none
   private
   include 'furiko_edges.inc'
end module furiko_edges_sp


module furiko_edges_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_bits_dp, only : infinity, nan
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_long_dp, only : long, words_bits, to_long, value, magnitude, sign_of, fold, sqrt, scale, &
      operator(+), operator(-), operator(*), operator(/), operator(<)
   implicit none
   private
   include 'furiko_edges.inc'
end module furiko_edges_dp


#ifdef FURIKO_REAL128
module furiko_edges_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : infinity, nan
   use furiko_forms, only : by_k, by_m, by_mc
   use furiko_long_qp, only : long, words_bits, to_long, value, magnitude, sign_of, fold, sqrt, scale, &
      operator(+), operator(-), operator(*), operator(/), operator(<)
   implicit none
   private
   include 'furiko_edges.inc'
end module furiko_edges_qp
#endif
! rooms: 2329321306
