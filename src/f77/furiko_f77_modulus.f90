! SPDX-License-Identifier: MIT

!> For Fortran 77: a modulus kept in the caller's array W(64), and what is asked of it.
module furiko_f77_modulus
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko_modulus, only : modulus, modulus_from_alpha, modulus_from_k, modulus_from_m, modulus_from_mc
   implicit none
   public
   !> Numbers of the caller's array: a mark, then the object's bits, some for what is to come
   integer, parameter :: room = 64
   !> Says that the array was filled; any bits would do
   integer(int64), parameter :: mark = 7885350463184921941_int64


contains


   !> The object's bits into an array of `lw` numbers; `ier` is 1 where these are too few, and nothing is
   !> written. A room too small for the object is found by strict compilers.
   pure subroutine keep(p, w, lw, ier)
      type(modulus), intent(in) :: p
      real(wp), intent(inout) :: w(room)
      integer, intent(in) :: lw
      integer, intent(out) :: ier
      integer, parameter :: used = ceiling(storage_size(p)/64.0)
      ! Not an array, which would be allocated
      type :: image
         real(wp) :: numbers(used)
      end type image
      type(image) :: bits

      ier = merge(0, 1, lw >= room)
      if (ier /= 0) return
      bits = transfer(p, bits)
      w(1) = transfer(mark, 1.0_wp)
      w(2:used + 1) = bits%numbers
   end subroutine keep


   !> And back; what was never filled says NaN
   pure function kept(w) result(p)
      real(wp), intent(in) :: w(room)
      type(modulus) :: p

      if (transfer(w(1), mark) == mark) p = transfer(w(2:room), p)
   end function kept

end module furiko_f77_modulus


include 'furiko_f77_modulus.inc'
! rooms: 2552582557
