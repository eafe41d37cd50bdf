! SPDX-License-Identifier: MIT

!> One process, without MPI: `mpi/` has the same names for many.
module furiko_ensemble_communicator
   use, intrinsic :: iso_fortran_env, only : int64
   use hdf5, only : hid_t
   use furiko_ensemble_system, only : end_system
   implicit none
   private
   public :: access_together, begin_processes, broadcast, end_processes, give_up, highest, process, &
      processes, transfer_together, wait_for_all


contains


   subroutine begin_processes()
   end subroutine begin_processes


   !> After all is well
   subroutine end_processes()
   end subroutine end_processes


   !> Ends all processes, since one of them cannot go on
   subroutine give_up(code)
      integer, intent(in) :: code

      call end_system(code)
   end subroutine give_up


   !> Which one this is, from 0 on
   pure function process() result(number)
      integer :: number

      number = 0
   end function process


   pure function processes() result(number)
      integer :: number

      number = 1
   end function processes


   !> The first process's number becomes everybody's.
   subroutine broadcast(number)
      integer, intent(inout) :: number

      number = number
   end subroutine broadcast


   !> The highest of all processes' numbers
   pure function highest(number) result(most)
      integer(int64), intent(in) :: number
      integer(int64) :: most

      most = number
   end function highest


   subroutine wait_for_all()
   end subroutine wait_for_all


   !> How a file is opened: by all processes
   subroutine access_together(properties, failed)
      integer(hid_t), intent(in) :: properties
      integer, intent(out) :: failed

      failed = merge(0, -1, properties >= 0)
   end subroutine access_together


   !> How data are written: by all processes in one go
   subroutine transfer_together(properties, failed)
      integer(hid_t), intent(in) :: properties
      integer, intent(out) :: failed

      failed = merge(0, -1, properties >= 0)
   end subroutine transfer_together
end module furiko_ensemble_communicator
