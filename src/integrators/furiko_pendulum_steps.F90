! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_pendulum_steps_sp
   use, intrinsic :: iso_fortran_env, only : ip => int32, wp => real32
   use furiko_bits_sp, only : nan
   implicit none
   private
   include 'furiko_pendulum_pi_sp.inc'
   ! Pendulums side by side, a few vectors of them (from 32 to 512 the time was the same but for noise); and
   ! steps from one look at them to the next, which is how many roundings of a sine turned along pile up. A
   ! look costs less than 1 % at 16 steps already
   integer, parameter :: block = 128, stretch = 64
   ! Angles up to here are reduced exactly
   real(wp), parameter :: far = 2.0_wp**8
   include 'furiko_symplectic_weights.inc'
   include 'furiko_pendulum_steps.inc'
   include 'furiko_pendulum_fast.inc'
   include 'furiko_pendulum_sine_sp.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_is_within.inc'
end module furiko_pendulum_steps_sp


module furiko_pendulum_steps_dp
   use, intrinsic :: iso_fortran_env, only : ip => int64, wp => real64
   use furiko_bits_dp, only : nan
   implicit none
   private
   include 'furiko_pendulum_pi_dp.inc'
   ! As in real32
   integer, parameter :: block = 64, stretch = 64
   ! Angles up to here are reduced exactly
   real(wp), parameter :: far = 2.0_wp**20
   include 'furiko_symplectic_weights.inc'
   include 'furiko_pendulum_steps.inc'
   include 'furiko_pendulum_fast.inc'
   include 'furiko_pendulum_sine_dp.inc'
#include "../arithmetic/furiko_bits.inc"
   include '../arithmetic/furiko_is_within.inc'
end module furiko_pendulum_steps_dp


#ifdef FURIKO_REAL128
module furiko_pendulum_steps_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_bits_qp, only : is_within, nan
   implicit none
   private
   include 'furiko_symplectic_weights.inc'
   include 'furiko_pendulum_steps.inc'
   include 'furiko_pendulum_plain.inc'
end module furiko_pendulum_steps_qp
#endif


!> Steps of the pendulum, one or many at once, in each kind of real.
! allow(C121)
module furiko_pendulum_steps
   use furiko_pendulum_steps_sp
   use furiko_pendulum_steps_dp
#ifdef FURIKO_REAL128
   use furiko_pendulum_steps_qp
#endif
   implicit none
   public
end module furiko_pendulum_steps
! rooms: 2396962788
