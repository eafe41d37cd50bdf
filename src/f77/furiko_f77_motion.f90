! SPDX-License-Identifier: MIT

!> For Fortran 77: a pendulum's exact motion kept in the caller's array W(96), and what is asked of it.
module furiko_f77_motion
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_motion, only : motion, object => motion, pendulum
   implicit none
   public
   integer, parameter :: room = 96
   integer(int64), parameter :: mark = 7885350463184921942_int64
   include 'furiko_f77_keep.inc'
end module furiko_f77_motion


include 'furiko_f77_motion.inc'
! rooms: 1725508836
