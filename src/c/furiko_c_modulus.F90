! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> One modulus and many u for C: the object lies in the caller's storage, as numbers that mean nothing to
!> anybody else; the text is in furiko_c_modulus.inc.
module furiko_c_modulus
   use, intrinsic :: iso_c_binding, only : c_double, c_int64_t, c_size_t
   use furiko_modulus, only : object => modulus, modulus_from_alpha, modulus_from_amplitude, modulus_from_k, &
      modulus_from_m, modulus_from_mc
   implicit none
   private
   include 'furiko_c_modulus.inc'
end module furiko_c_modulus
! rooms: 2255914961
