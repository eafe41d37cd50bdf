! SPDX-License-Identifier: MIT

!> For Fortran 77: a modulus kept in the caller's array W(64), and what is asked of it.
module furiko_f77_modulus
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_modulus, only : modulus, modulus_from_alpha, modulus_from_k, modulus_from_m, modulus_from_mc, &
      object => modulus
   implicit none
   public
   integer, parameter :: room = 64
   integer(int64), parameter :: mark = 7885350463184921941_int64
   include 'furiko_f77_keep.inc'
end module furiko_f77_modulus


include 'furiko_f77_modulus.inc'
! rooms: 1998051352
