! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> A pendulum's exact motion for C: the object lies in the caller's storage, as numbers that mean nothing to
!> anybody else; the text is in furiko_c_motion.inc.
module furiko_c_motion
   use, intrinsic :: iso_c_binding, only : c_double, c_int, c_int64_t, c_size_t
   use furiko_motion, only : object => motion, pendulum
   implicit none
   private
   include 'furiko_c_motion.inc'
end module furiko_c_motion
! rooms: 1890783513
