! SPDX-License-Identifier: MIT

!> Many processes, by MPI: `serial/` has the same names for one.
module furiko_ensemble_communicator
   use, intrinsic :: iso_c_binding, only : c_int
   use, intrinsic :: iso_fortran_env, only : int64
   use hdf5, only : h5pset_dxpl_mpio_f, h5pset_fapl_mpio_f, h5fd_mpio_collective_f, hid_t
   use mpi_f08, only : mpi_abort, mpi_allreduce, mpi_barrier, mpi_bcast, mpi_comm_rank, mpi_comm_size, &
      mpi_comm_world, mpi_finalize, mpi_info_null, mpi_init_thread, mpi_integer, mpi_integer8, mpi_max, &
      mpi_thread_funneled
   implicit none
   private
   public :: access_together, begin_processes, broadcast, end_processes, give_up, highest, process, &
      processes, transfer_together, wait_for_all


   interface
      !> HDF5 has no Fortran name for this.
      function set_collective_option(properties, option) result(failed) &
         bind(c, name='H5Pset_dxpl_mpio_collective_opt')
         import :: c_int, hid_t
         implicit none
         integer(hid_t), value :: properties
         integer(c_int), value :: option
         integer(c_int) :: failed
      end function set_collective_option
   end interface


contains


   !> Threads of a process compute; only the first of them calls MPI.
   subroutine begin_processes()
      integer :: provided

      call mpi_init_thread(mpi_thread_funneled, provided)
   end subroutine begin_processes


   !> After all is well
   subroutine end_processes()
      call mpi_finalize()
   end subroutine end_processes


   !> Ends all processes, since one of them cannot go on
   subroutine give_up(code)
      integer, intent(in) :: code

      call mpi_abort(mpi_comm_world, code)
   end subroutine give_up


   !> Which one this is, from 0 on
   function process() result(number)
      integer :: number

      call mpi_comm_rank(mpi_comm_world, number)
   end function process


   function processes() result(number)
      integer :: number

      call mpi_comm_size(mpi_comm_world, number)
   end function processes


   !> The first process's number becomes everybody's.
   subroutine broadcast(number)
      integer, intent(inout) :: number

      call mpi_bcast(number, 1, mpi_integer, 0, mpi_comm_world)
   end subroutine broadcast


   !> The highest of all processes' numbers
   function highest(number) result(most)
      integer(int64), intent(in) :: number
      integer(int64) :: most

      call mpi_allreduce(number, most, 1, mpi_integer8, mpi_max, mpi_comm_world)
   end function highest


   subroutine wait_for_all()
      call mpi_barrier(mpi_comm_world)
   end subroutine wait_for_all


   !> How a file is opened: by all processes
   subroutine access_together(properties, failed)
      integer(hid_t), intent(in) :: properties
      integer, intent(out) :: failed

      call h5pset_fapl_mpio_f(properties, mpi_comm_world%mpi_val, mpi_info_null%mpi_val, failed)
   end subroutine access_together


   !> How data are written: by all processes in one go, each its own, which lie side by side. Else MPI would
   !> send them to a few processes, or to one, that write for all.
   subroutine transfer_together(properties, failed)
      integer(hid_t), intent(in) :: properties
      integer, intent(out) :: failed
      ! H5FD_MPIO_INDIVIDUAL_IO
      integer(c_int), parameter :: each_its_own = 1_c_int

      call h5pset_dxpl_mpio_f(properties, h5fd_mpio_collective_f, failed)
      if (failed == 0) failed = set_collective_option(properties, each_its_own)
   end subroutine transfer_together
end module furiko_ensemble_communicator
