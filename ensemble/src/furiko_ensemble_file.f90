! SPDX-License-Identifier: MIT

!> The file of a sweep, HDF5. It is made whole at the beginning, under another name. From then on only numbers
!> are put into places that are there, so that no moment is one at which the file cannot be opened.
module furiko_ensemble_file
   use, intrinsic :: iso_c_binding, only : c_int, c_loc
   use, intrinsic :: iso_fortran_env, only : int8, int64, wp => real64
   use furiko_ensemble_attractors, only : attractor_quantities, find_attractors, take_attractors
   use furiko_ensemble_communicator, only : access_together, process, transfer_together, wait_for_all
   use furiko_ensemble_facts, only : fact, fact_text, facts_of, take_fact
   use furiko_ensemble_hdf5, only : get_fact, move_numbers, move_run, run
   use furiko_ensemble_layout, only : done_name, fill_new, session_name
   use furiko_ensemble_sweep, only : chunks, first_member, member_extents, members_of, quantities, quantity, &
      sweep
   use furiko_ensemble_system, only : exists, file_lock, file_open, file_remove, file_rename, file_sync, &
      is_locked, reason, to_make, to_read, to_write
   use hdf5, only : h5_integer_kind, h5_real_kind, h5dclose_f, h5dget_space_f, h5dopen_f, &
      h5f_acc_rdonly_f, h5f_acc_rdwr_f, h5f_scope_global_f, h5fclose_f, h5fflush_f, h5fopen_f, &
      h5kind_to_type, h5p_dataset_xfer_f, h5p_default_f, h5p_file_access_f, h5pclose_f, h5pcreate_f, &
      h5pset_sieve_buf_size_f, h5sclose_f, h5sget_simple_extent_npoints_f, hid_t, hsize_t, size_t
   implicit none
   private
   public :: ensemble_file, close_file, difference, hold_file, is_done, mark_chunk, open_file, open_to_look, &
      read_chunk, read_session, write_chunk, write_session


   !> Marks that are in memory at a time
   integer(int64), parameter :: piece = 2_int64**13


   !> An open file
   type :: ensemble_file
      character(len=:), allocatable :: path
      !> As the system and as HDF5 know it
      integer(c_int) :: descriptor = -1
      integer(hid_t) :: id = -1
      !> Datasets: of each quantity, of the marks, of how long the run has taken
      integer(hid_t), allocatable :: numbers(:)
      integer(hid_t) :: done = -1
      integer(hid_t) :: session = -1
      !> How they are written
      integer(hid_t) :: transfer = -1
      !> How many chunks there are; the marks from the chunk `first_mark` on, and whether they could be read
      integer(int64) :: chunks = 0
      integer(int64) :: first_mark = -1
      integer(int8) :: marks(piece) = 0_int8
      logical :: unreadable = .false.
   end type ensemble_file


contains


   !> Make the file of a sweep, or make sure that what is there is its file; and lock it until the process
   !> ends. For one process of all.
   subroutine hold_file(path, asked, part, parts, trouble)
      character(len=*), intent(in) :: path
      type(sweep), intent(inout) :: asked
      !> Only these chunks are given room on the disk
      integer, intent(in) :: part
      integer, intent(in) :: parts
      !> Why it cannot be; empty if all is well
      character(len=:), allocatable, intent(out) :: trouble
      integer(c_int) :: descriptor
      logical :: made

      trouble = ''
      made = .false.
      if (.not. exists(path)) call make_file(path, asked, part, parts, made, trouble)
      if (made .or. trouble /= '') return
      call lock(path, to_write, descriptor, trouble)
      if (trouble == '') trouble = difference(path, asked)
   end subroutine hold_file


   !> Open and lock, until the process ends
   subroutine lock(path, purpose, descriptor, trouble)
      character(len=*), intent(in) :: path
      integer, intent(in) :: purpose
      integer(c_int), intent(out) :: descriptor
      character(len=:), allocatable, intent(out) :: trouble
      integer(c_int) :: failed

      trouble = ''
      failed = file_open(path, purpose, descriptor)
      if (failed == 0) failed = file_lock(descriptor)
      if (failed > 0) trouble = path // ': ' // reason(failed)
      if (failed < 0) trouble = path // ': another process is writing it'
   end subroutine lock


   !> A new file appears under its name when it is complete and on the disk.
   subroutine make_file(path, asked, part, parts, made, trouble)
      character(len=*), intent(in) :: path
      type(sweep), intent(inout) :: asked
      integer, intent(in) :: part
      integer, intent(in) :: parts
      logical, intent(out) :: made
      character(len=:), allocatable, intent(out) :: trouble
      character(len=:), allocatable :: begun
      integer(c_int) :: descriptor, failed

      made = .false.
      begun = path // '.begun'
      call lock(begun, to_make, descriptor, trouble)
      if (trouble /= '') return
      ! Somebody else may have been quicker.
      if (exists(path)) then
         call file_remove(begun)
         return
      end if
      ! A file that is joined has those of its parts.
      if (asked%subject == 'basins' .and. .not. allocated(asked%attractor)) call find_attractors(asked)
      if (asked%subject == 'basins' .and. size(asked%attractor) == 0) then
         call file_remove(begun)
         trouble = 'no start comes to a cycle of so many periods: try a longer --transient or --cycle; ' // &
            'chaos has none'
         return
      end if
      call fill_new(begun, asked, descriptor, part, parts, failed)
      if (failed == 0) failed = file_sync(descriptor)
      if (failed == 0) failed = file_rename(begun, path)
      made = failed == 0
      if (.not. made) then
         call file_remove(begun)
         trouble = path // ': ' // reason(failed)
         if (failed < 0) trouble = path // ': HDF5 cannot make it here'
      end if
   end subroutine make_file


   !> In what a file is not that of a sweep; empty if it is
   function difference(path, asked) result(trouble)
      character(len=*), intent(in) :: path
      type(sweep), intent(in) :: asked
      character(len=:), allocatable :: trouble
      type(fact), allocatable :: facts(:)
      type(fact) :: there
      integer(hid_t) :: file
      integer :: failed, i
      logical :: found

      trouble = ''
      facts = facts_of(asked)
      call h5fopen_f(path, h5f_acc_rdonly_f, file, failed)
      if (failed < 0) then
         trouble = path // ': not a whole HDF5 file'
         return
      end if
      do i = 1, size(facts)
         there = facts(i)
         call get_fact(file, there, found)
         if (.not. found) then
            trouble = path // ': not a file of this program'
         else if (fact_text(there) /= fact_text(facts(i))) then
            trouble = path // ': a file of another run, whose ' // there%name // ' is ' // &
               fact_text(there) // ' and not ' // fact_text(facts(i))
         end if
         if (trouble /= '') exit
      end do
      call h5fclose_f(file, failed)
   end function difference


   !> The sweep whose file it is
   subroutine read_sweep(file, asked, good)
      integer(hid_t), intent(in) :: file
      type(sweep), intent(out) :: asked
      logical, intent(out) :: good
      type(fact), allocatable :: facts(:)
      integer :: i

      asked%subject = ''
      asked%method = ''
      facts = facts_of(asked)
      call get_fact(file, facts(1), good)
      if (.not. good) return
      call take_fact(facts(1), asked)
      facts = facts_of(asked)
      do i = 1, size(facts)
         call get_fact(file, facts(i), good)
         if (.not. good) return
         call take_fact(facts(i), asked)
      end do
      good = asked%vary > 0 .and. asked%points > 0 .and. asked%chunk > 0 .and. asked%periods > 0
   end subroutine read_sweep


   !> Open the file of a sweep to write numbers, all processes together
   subroutine open_file(path, asked, file, trouble)
      character(len=*), intent(in) :: path
      type(sweep), intent(inout) :: asked
      type(ensemble_file), intent(out) :: file
      character(len=:), allocatable, intent(out) :: trouble
      integer(hid_t) :: properties
      integer(c_int) :: failed_open
      integer :: failed

      trouble = path // ': cannot be opened'
      file%path = path
      failed_open = file_open(path, to_write, file%descriptor)
      if (failed_open /= 0) return
      call h5pcreate_f(h5p_file_access_f, properties, failed)
      ! What is written goes to the file at once, and nothing but what is written
      call h5pset_sieve_buf_size_f(properties, 0_size_t, failed)
      call access_together(properties, failed)
      if (failed < 0) return
      call h5fopen_f(path, h5f_acc_rdwr_f, file%id, failed, properties)
      if (failed < 0) return
      call h5pcreate_f(h5p_dataset_xfer_f, file%transfer, failed)
      call transfer_together(file%transfer, failed)
      if (failed < 0) return
      call open_datasets(file, asked, trouble)
   end subroutine open_file


   !> Open a file to read it, whose sweep is not known yet
   subroutine open_to_look(path, file, asked, running, trouble)
      character(len=*), intent(in) :: path
      type(ensemble_file), intent(out) :: file
      type(sweep), intent(out) :: asked
      !> Whether a process is writing it now, on this machine
      logical, intent(out) :: running
      character(len=:), allocatable, intent(out) :: trouble
      integer(c_int) :: failed_open
      integer :: failed
      logical :: good

      running = .false.
      file%path = path
      failed_open = file_open(path, to_read, file%descriptor)
      if (failed_open /= 0) then
         trouble = path // ': ' // reason(failed_open)
         return
      end if
      running = is_locked(file%descriptor)
      trouble = path // ': not a whole HDF5 file'
      call h5fopen_f(path, h5f_acc_rdonly_f, file%id, failed)
      if (failed < 0) return
      trouble = path // ': not a file of this program'
      call read_sweep(file%id, asked, good)
      if (.not. good) return
      call h5pcreate_f(h5p_dataset_xfer_f, file%transfer, failed)
      call open_datasets(file, asked, trouble)
   end subroutine open_to_look


   subroutine open_datasets(file, asked, trouble)
      type(ensemble_file), intent(inout) :: file
      type(sweep), intent(inout) :: asked
      character(len=:), allocatable, intent(out) :: trouble
      type(quantity), allocatable :: all(:)
      integer :: failed, i, worst

      all = quantities(asked)
      allocate(file%numbers(size(all)))
      file%chunks = chunks(asked)
      worst = 0
      do i = 1, size(all)
         call h5dopen_f(file%id, all(i)%name, file%numbers(i), failed)
         worst = min(worst, failed)
      end do
      call h5dopen_f(file%id, done_name, file%done, failed)
      worst = min(worst, failed)
      call h5dopen_f(file%id, session_name, file%session, failed)
      worst = min(worst, failed)
      if (asked%subject == 'basins') call read_attractors(file%id, asked, failed)
      trouble = ''
      if (min(worst, failed) < 0) trouble = file%path // ': not a file of this program'
   end subroutine open_datasets


   !> The attractors that were found when the file was made
   subroutine read_attractors(file, asked, worst)
      integer(hid_t), intent(in) :: file
      type(sweep), intent(inout) :: asked
      !> Below 0: they cannot be read
      integer, intent(out) :: worst
      type(quantity), allocatable :: all(:)
      integer(hid_t) :: dataset, space
      integer(hsize_t) :: n
      integer :: failed, i

      call h5dopen_f(file, 'attractors/label', dataset, worst)
      if (worst < 0) return
      call h5dget_space_f(dataset, space, failed)
      call h5sget_simple_extent_npoints_f(space, n, failed)
      call h5sclose_f(space, failed)
      call h5dclose_f(dataset, failed)
      all = attractor_quantities(int(n))
      do i = 1, size(all)
         call h5dopen_f(file, 'attractors/' // all(i)%name, dataset, failed)
         worst = min(worst, failed)
         if (failed < 0) cycle
         call move_numbers(dataset, run([integer(int64) ::], [n], 0_int64, n), all(i), .false., &
            h5p_default_f, failed)
         worst = min(worst, failed)
         call h5dclose_f(dataset, failed)
      end do
      call take_attractors(all, asked)
   end subroutine read_attractors


   !> Whether a chunk is marked. Marks are read in pieces, however many there are; ask in rising order.
   function is_done(file, chunk) result(done)
      type(ensemble_file), intent(inout), target :: file
      integer(int64), intent(in) :: chunk
      logical :: done
      integer :: failed

      if (file%first_mark < 0 .or. chunk < file%first_mark .or. chunk >= file%first_mark + piece) then
         file%first_mark = chunk - modulo(chunk, piece)
         call move_run(file%done, run([integer(int64) ::], [file%chunks], file%first_mark, &
            min(piece, file%chunks - file%first_mark)), h5kind_to_type(int8, h5_integer_kind), &
            c_loc(file%marks), .false., h5p_default_f, failed)
         if (failed < 0) file%unreadable = .true.
      end if
      done = file%marks(chunk - file%first_mark + 1) == 1_int8
   end function is_done


   !> Where the numbers of a quantity lie; nowhere for the chunk -1
   function run_of(asked, chunk, one) result(where)
      type(sweep), intent(in) :: asked
      integer(int64), intent(in) :: chunk
      type(quantity), intent(in) :: one
      type(run) :: where

      allocate(where%prefix(merge(1, 0, one%each_period)))
      where%prefix = one%rows
      where%extents = member_extents(asked)
      if (chunk < 0) return
      where%first = first_member(asked, chunk)
      where%count = members_of(asked, chunk)
   end function run_of


   !> Put a chunk's numbers into the file and onto the disk, of all processes together; a process that has
   !> none gives the chunk -1.
   subroutine write_chunk(file, asked, chunk, results, trouble)
      type(ensemble_file), intent(in) :: file
      type(sweep), intent(in) :: asked
      integer(int64), intent(in) :: chunk
      type(quantity), intent(inout) :: results(:)
      character(len=:), allocatable, intent(out) :: trouble
      integer :: failed, i, worst

      worst = 0
      do i = 1, size(results)
         call move_numbers(file%numbers(i), run_of(asked, chunk, results(i)), results(i), .true., &
            file%transfer, failed)
         worst = min(worst, failed)
      end do
      trouble = ''
      if (worst == 0) then
         call settle(file, trouble)
      else
         trouble = file%path // ': cannot be written; is the disk full?'
      end if
   end subroutine write_chunk


   subroutine read_chunk(file, asked, chunk, results, trouble)
      type(ensemble_file), intent(in) :: file
      type(sweep), intent(in) :: asked
      integer(int64), intent(in) :: chunk
      type(quantity), intent(inout) :: results(:)
      character(len=:), allocatable, intent(out) :: trouble
      integer :: failed, i

      trouble = ''
      do i = 1, size(results)
         call move_numbers(file%numbers(i), run_of(asked, chunk, results(i)), results(i), .false., &
            file%transfer, failed)
         if (failed < 0) trouble = file%path // ': cannot be read'
      end do
   end subroutine read_chunk


   !> What all processes have written is on the disk when they come back.
   subroutine settle(file, trouble)
      type(ensemble_file), intent(in) :: file
      character(len=:), allocatable, intent(out) :: trouble
      integer(c_int) :: failed
      integer :: failed_flush

      trouble = ''
      call h5fflush_f(file%id, h5f_scope_global_f, failed_flush)
      failed = file_sync(file%descriptor)
      if (failed_flush < 0) trouble = file%path // ': cannot be written; is the disk full?'
      if (failed /= 0) trouble = file%path // ': ' // reason(failed)
      if (trouble == '') call wait_for_all()
   end subroutine settle


   !> Mark a chunk as done, after `write_chunk`
   subroutine mark_chunk(file, chunk, trouble)
      type(ensemble_file), intent(in) :: file
      integer(int64), intent(in) :: chunk
      character(len=:), allocatable, intent(out) :: trouble
      integer(int8), target :: mark
      integer :: failed

      mark = 1_int8
      call move_run(file%done, run([integer(int64) ::], [file%chunks], max(chunk, 0_int64), &
         merge(1_int64, 0_int64, chunk >= 0)), h5kind_to_type(int8, h5_integer_kind), c_loc(mark), .true., &
         file%transfer, failed)
      trouble = ''
      if (failed < 0) trouble = file%path // ': cannot be written; is the disk full?'
   end subroutine mark_chunk


   !> How many chunks there were when the run began, and how long it has taken: for `status`. Process 0
   !> writes, the others are there.
   subroutine write_session(file, session)
      type(ensemble_file), intent(in) :: file
      real(wp), intent(in), target :: session(2)
      integer :: failed, number

      number = process()
      call move_run(file%session, run([integer(int64) ::], [2_int64], 0_int64, &
         merge(2_int64, 0_int64, number == 0)), h5kind_to_type(wp, h5_real_kind), c_loc(session), .true., &
         file%transfer, failed)
   end subroutine write_session


   function read_session(file) result(session)
      type(ensemble_file), intent(in) :: file
      real(wp), target :: session(2)
      integer :: failed

      session = 0.0_wp
      call move_run(file%session, run([integer(int64) ::], [2_int64], 0_int64, 2_int64), &
         h5kind_to_type(wp, h5_real_kind), c_loc(session), .false., h5p_default_f, failed)
   end function read_session


   !> After the last chunk, all processes together
   subroutine close_file(file, trouble)
      type(ensemble_file), intent(inout) :: file
      character(len=:), allocatable, intent(out) :: trouble
      integer :: failed, i

      call settle(file, trouble)
      do i = 1, size(file%numbers)
         call h5dclose_f(file%numbers(i), failed)
      end do
      call h5dclose_f(file%done, failed)
      call h5dclose_f(file%session, failed)
      call h5pclose_f(file%transfer, failed)
      call h5fclose_f(file%id, failed)
      if (failed < 0) trouble = file%path // ': cannot be closed'
   end subroutine close_file
end module furiko_ensemble_file
