! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> Steps of many pendulums for C, in float; the text is in furiko_c_pendulum_steps.inc.
module furiko_c_pendulum_steps_sp
   use, intrinsic :: iso_c_binding, only : c_int, c_size_t, wp => c_float
   use furiko_pendulum_steps, only : pendulum_forest_ruth, pendulum_rk4, pendulum_verlet
   implicit none
   private
   ! What C's names end in, and how many of an array are worked on at once
   character(len=*), parameter :: suffix = 'f'
   integer(c_size_t), parameter :: most = 4096
   include 'furiko_c_pendulum_steps.inc'
end module furiko_c_pendulum_steps_sp


!> Steps of many pendulums for C, in double; the text is in furiko_c_pendulum_steps.inc.
module furiko_c_pendulum_steps_dp
   use, intrinsic :: iso_c_binding, only : c_int, c_size_t, wp => c_double
   use furiko_pendulum_steps, only : pendulum_forest_ruth, pendulum_rk4, pendulum_verlet
   implicit none
   private
   ! What C's names end in, and how many of an array are worked on at once
   character(len=*), parameter :: suffix = ''
   integer(c_size_t), parameter :: most = 4096
   include 'furiko_c_pendulum_steps.inc'
end module furiko_c_pendulum_steps_dp
! rooms: 4258310681
