! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

! Right-hand sides to hand to [[rk4]]: one module for each kind of real, and none over them, since a
! generic name cannot be an actual argument. `use furiko_pendulum_rates_dp, only : pendulum_rates`.

module furiko_pendulum_rates_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   implicit none
   private
   include 'furiko_pendulum_rates.inc'
end module furiko_pendulum_rates_sp


module furiko_pendulum_rates_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   include 'furiko_pendulum_rates.inc'
end module furiko_pendulum_rates_dp


#ifdef FURIKO_REAL128
module furiko_pendulum_rates_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   implicit none
   private
   include 'furiko_pendulum_rates.inc'
end module furiko_pendulum_rates_qp
#endif
! rooms: 2726342783
