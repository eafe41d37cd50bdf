! SPDX-License-Identifier: MIT

!> For Fortran 77: a pendulum's exact motion kept in the caller's array W(96), and what is asked of it.
module furiko_f77_motion
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_motion, only : motion, pendulum
   implicit none
   public
   !> Numbers of the caller's array: a mark, then the object's bits, some for what is to come
   integer, parameter :: room = 96
   !> Says that the array was filled; any bits would do
   integer(int64), parameter :: mark = 7885350463184921942_int64


contains


   !> The object's bits into an array of `lw` numbers; `ier` is 1 where these are too few, and nothing is
   !> written. A room too small for the object is found by strict compilers.
   pure subroutine keep(path, w, lw, ier)
      type(motion), intent(in) :: path
      real(wp), intent(inout) :: w(room)
      integer, intent(in) :: lw
      integer, intent(out) :: ier
      integer, parameter :: used = ceiling(storage_size(path)/64.0)
      ! Not an array, which would be allocated
      type :: image
         real(wp) :: numbers(used)
      end type image
      type(image) :: bits

      ier = merge(0, 1, lw >= room)
      if (ier /= 0) return
      bits = transfer(path, bits)
      w(1) = transfer(mark, 1.0_wp)
      w(2:used + 1) = bits%numbers
   end subroutine keep


   !> And back; what was never filled says NaN
   pure function kept(w) result(path)
      real(wp), intent(in) :: w(room)
      type(motion) :: path

      if (transfer(w(1), mark) == mark) path = transfer(w(2:room), path)
   end function kept

end module furiko_f77_motion


include 'furiko_f77_motion.inc'
! rooms: 2280040041
