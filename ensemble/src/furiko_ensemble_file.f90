! SPDX-License-Identifier: MIT

!> The file of a sweep, HDF5. It is made whole at the beginning, under another name: every dataset has its
!> place and its room on the disk, and every attribute is written. From then on only numbers are put into
!> places that are there, so that no moment is one at which the file cannot be opened.
module furiko_ensemble_file
   use, intrinsic :: iso_c_binding, only : c_char, c_f_pointer, c_int, c_loc, c_null_char, c_ptr
   use, intrinsic :: iso_fortran_env, only : int8, int64, wp => real64
   use furiko_ensemble_communicator, only : access_together, process, transfer_together, wait_for_all
   use furiko_ensemble_facts, only : fact, fact_text, facts_of
   use furiko_ensemble_sweep, only : chunks, constants, first_member, is_mine, members_of, quantities, &
      quantity, sweep
   use furiko_ensemble_system, only : exists, file_lock, file_open, file_remove, file_rename, file_reserve, &
      file_sync, is_locked, reason, to_make, to_read, to_write
   use h5ds, only : h5dsattach_scale_f, h5dsset_scale_f
   use hdf5, only : h5_integer_kind, h5_real_kind, h5aclose_f, h5acreate_f, h5aopen_f, h5aread_f, &
      h5awrite_f, h5d_alloc_time_early_f, h5d_fill_time_never_f, h5dclose_f, h5dcreate_f, &
      h5dget_offset_f, h5dget_space_f, h5dopen_f, h5dread_f, h5dwrite_f, h5eset_auto_f, &
      h5f_acc_rdonly_f, h5f_acc_rdwr_f, h5f_acc_trunc_f, h5f_scope_global_f, h5fclose_f, h5fcreate_f, &
      h5fflush_f, h5fopen_f, h5gclose_f, h5gcreate_f, h5kind_to_type, h5open_f, h5p_dataset_create_f, &
      h5p_dataset_xfer_f, h5p_file_access_f, h5pclose_f, h5pcreate_f, h5pset_alloc_time_f, &
      h5pset_fill_time_f, h5pset_obj_track_times_f, h5pset_sieve_buf_size_f, h5s_scalar_f, &
      h5s_select_set_f, h5sclose_f, h5screate_f, h5screate_simple_f, h5sselect_hyperslab_f, &
      h5sselect_none_f, h5t_ieee_f64le, h5t_std_i64le, h5t_std_i8le, h5t_string, hid_t, hsize_t, size_t
   implicit none
   private
   public :: ensemble_file, begin_files, close_file, difference, done_chunks, hold_file, mark_chunk, &
      open_file, open_to_look, read_chunk, read_session, write_chunk, write_session


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
   end type ensemble_file


   character(len=*), parameter :: done_name = 'progress/done', session_name = 'progress/session'
   !> Bytes of a number
   integer(int64), parameter :: size_of_number = 8


contains


   subroutine begin_files()
      integer :: failed

      call h5open_f(failed)
      call h5eset_auto_f(0, failed)
   end subroutine begin_files


   !> Make the file of a sweep, or make sure that what is there is its file; and lock it until the process
   !> ends. For one process of all.
   subroutine hold_file(path, asked, part, parts, trouble)
      character(len=*), intent(in) :: path
      type(sweep), intent(in) :: asked
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
      type(sweep), intent(in) :: asked
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


   !> All that a file has but its numbers
   subroutine fill_new(path, asked, descriptor, part, parts, failed)
      character(len=*), intent(in) :: path
      type(sweep), intent(in) :: asked
      integer(c_int), intent(in) :: descriptor
      integer, intent(in) :: part
      integer, intent(in) :: parts
      integer(c_int), intent(out) :: failed
      type(quantity), allocatable :: all(:)
      type(fact), allocatable :: facts(:)
      integer(int64), allocatable :: offsets(:)
      integer(hid_t) :: file, group
      integer :: errors(4), i

      errors = 0
      all = quantities(asked)
      allocate(offsets(size(all)), source=-1_int64)
      facts = facts_of(asked)
      call h5fcreate_f(path, h5f_acc_trunc_f, file, errors(1))
      do i = 1, size(facts)
         call put_fact(file, facts(i))
      end do
      call h5gcreate_f(file, 'progress', group, errors(2))
      call h5gclose_f(group, i)
      call put_progress(file, asked)
      call put_quantities(file, asked, all, offsets)
      call h5fclose_f(file, errors(3))
      failed = -1
      if (any(errors < 0) .or. any(offsets < 0)) return
      failed = 0
      do i = 1, size(all)
         if (failed == 0) call reserve(asked, all(i)%rows, offsets(i), descriptor, part, parts, failed)
      end do
   end subroutine fill_new


   !> Room for the numbers of a quantity
   subroutine reserve(asked, rows, offset, descriptor, part, parts, failed)
      type(sweep), intent(in) :: asked
      integer, intent(in) :: rows
      !> Where they begin in the file
      integer(int64), intent(in) :: offset
      integer(c_int), intent(in) :: descriptor
      integer, intent(in) :: part
      integer, intent(in) :: parts
      integer(c_int), intent(out) :: failed
      integer(int64) :: chunk, width

      width = rows*size_of_number
      if (parts == 1) then
         failed = file_reserve(descriptor, offset, asked%points*width)
         return
      end if
      failed = 0
      do chunk = part - 1, chunks(asked) - 1, parts
         failed = file_reserve(descriptor, offset + first_member(asked, chunk)*width, &
            members_of(asked, chunk)*width)
         if (failed /= 0) exit
      end do
   end subroutine reserve


   !> A dataset whose place in the file is settled at once, and which says no time
   subroutine put_dataset(file, name, kind, extents, dataset)
      integer(hid_t), intent(in) :: file
      character(len=*), intent(in) :: name
      integer(hid_t), intent(in) :: kind
      integer(int64), intent(in) :: extents(:)
      integer(hid_t), intent(out) :: dataset
      integer(hid_t) :: properties, space
      integer :: failed

      call h5pcreate_f(h5p_dataset_create_f, properties, failed)
      call h5pset_obj_track_times_f(properties, .false., failed)
      call h5pset_alloc_time_f(properties, h5d_alloc_time_early_f, failed)
      call h5pset_fill_time_f(properties, h5d_fill_time_never_f, failed)
      call h5screate_simple_f(size(extents), int(extents, hsize_t), space, failed)
      call h5dcreate_f(file, name, kind, space, dataset, failed, properties)
      call h5sclose_f(space, failed)
      call h5pclose_f(properties, failed)
   end subroutine put_dataset


   subroutine put_progress(file, asked)
      integer(hid_t), intent(in) :: file
      type(sweep), intent(in) :: asked
      integer(hid_t) :: dataset
      integer :: failed

      call put_dataset(file, done_name, h5t_std_i8le, [chunks(asked)], dataset)
      call put_text(dataset, 'long_name', '1 where a chunk of members is computed and on the disk')
      call h5dclose_f(dataset, failed)
      call put_dataset(file, session_name, h5t_ieee_f64le, [2_int64], dataset)
      call put_text(dataset, 'long_name', 'chunks that were there when this run began; its seconds. 0: ended')
      call h5dclose_f(dataset, failed)
   end subroutine put_progress


   !> The quantities, with names for their directions, and where in the file they begin. Directions are
   !> counted as C does, members first.
   subroutine put_quantities(file, asked, all, offsets)
      integer(hid_t), intent(in) :: file
      type(sweep), intent(in) :: asked
      type(quantity), intent(in) :: all(:)
      integer(int64), intent(out) :: offsets(:)
      integer(hid_t) :: dataset, kind, period, varied
      integer :: failed, i

      if (any(all%each_period)) call put_periods(file, asked, period)
      do i = 1, size(all)
         kind = h5t_ieee_f64le
         if (allocated(all(i)%wholes)) kind = h5t_std_i64le
         if (all(i)%each_period) then
            call put_dataset(file, all(i)%name, kind, [int(all(i)%rows, int64), asked%points], dataset)
            call h5dsattach_scale_f(dataset, period, 2, failed)
         else
            call put_dataset(file, all(i)%name, kind, [asked%points], dataset)
         end if
         call put_text(dataset, 'long_name', all(i)%about)
         call put_text(dataset, 'units', all(i)%units)
         call h5dget_offset_f(dataset, offsets(i), failed)
         if (failed < 0) offsets(i) = -1
         if (i == 1) then
            varied = dataset
            call h5dsset_scale_f(varied, failed, all(1)%name)
         else
            call h5dsattach_scale_f(dataset, varied, 1, failed)
            call h5dclose_f(dataset, failed)
         end if
      end do
      call h5dclose_f(varied, failed)
      if (any(all%each_period)) call h5dclose_f(period, failed)
   end subroutine put_quantities


   !> The periods that are stored, by number
   subroutine put_periods(file, asked, dataset)
      integer(hid_t), intent(in) :: file
      type(sweep), intent(in) :: asked
      integer(hid_t), intent(out) :: dataset
      integer(int64), target :: number(asked%periods)
      integer :: failed, i

      number = [(int(asked%transient, int64) + i, i=1, asked%periods)]
      call put_dataset(file, 'period', h5t_std_i64le, [size(number, kind=int64)], dataset)
      call h5dwrite_f(dataset, h5kind_to_type(int64, h5_integer_kind), c_loc(number), failed)
      call put_text(dataset, 'long_name', 'periods of the drive since the start')
      call put_text(dataset, 'units', '1')
      call h5dsset_scale_f(dataset, failed, 'period')
   end subroutine put_periods


   subroutine put_text(object, name, text)
      integer(hid_t), intent(in) :: object
      character(len=*), intent(in) :: name
      character(len=*), intent(in) :: text
      type(fact) :: one

      one%name = name
      one%text = text
      call put_fact(object, one)
   end subroutine put_text


   subroutine put_fact(object, one)
      integer(hid_t), intent(in) :: object
      type(fact), intent(in), target :: one
      character(len=:, kind=c_char), allocatable, target :: text
      type(c_ptr), target :: place
      integer(hid_t) :: attribute, space
      integer :: failed

      call h5screate_f(h5s_scalar_f, space, failed)
      if (allocated(one%text)) then
         text = one%text // c_null_char
         place = c_loc(text)
         call h5acreate_f(object, one%name, h5t_string, space, attribute, failed)
         call h5awrite_f(attribute, h5t_string, c_loc(place), failed)
      else if (allocated(one%whole)) then
         call h5acreate_f(object, one%name, h5t_std_i64le, space, attribute, failed)
         call h5awrite_f(attribute, h5kind_to_type(int64, h5_integer_kind), c_loc(one%whole), failed)
      else
         call h5acreate_f(object, one%name, h5t_ieee_f64le, space, attribute, failed)
         call h5awrite_f(attribute, h5kind_to_type(wp, h5_real_kind), c_loc(one%number), failed)
      end if
      call h5aclose_f(attribute, failed)
      call h5sclose_f(space, failed)
   end subroutine put_fact


   !> Read a fact of the same name and kind; its value becomes that of the file
   subroutine get_fact(file, one, found)
      integer(hid_t), intent(in) :: file
      type(fact), intent(inout), target :: one
      logical, intent(out) :: found
      type(c_ptr) :: place
      type(c_ptr), target :: text
      integer(hid_t) :: attribute
      integer :: failed

      call h5aopen_f(file, one%name, attribute, failed)
      found = failed >= 0
      if (.not. found) return
      if (allocated(one%text)) then
         place = c_loc(text)
         call h5aread_f(attribute, h5t_string, place, failed)
         if (failed >= 0) one%text = text_at(text)
      else if (allocated(one%whole)) then
         place = c_loc(one%whole)
         call h5aread_f(attribute, h5kind_to_type(int64, h5_integer_kind), place, failed)
      else
         place = c_loc(one%number)
         call h5aread_f(attribute, h5kind_to_type(wp, h5_real_kind), place, failed)
      end if
      found = failed >= 0
      call h5aclose_f(attribute, failed)
   end subroutine get_fact


   !> What C has as a text, up to a length that no fact of ours has
   function text_at(place) result(text)
      type(c_ptr), intent(in) :: place
      character(len=:), allocatable :: text
      integer, parameter :: longest = 10000
      character(kind=c_char), pointer :: bytes(:)
      integer :: i

      call c_f_pointer(place, bytes, [longest])
      text = ''
      do i = 1, longest
         if (bytes(i) == c_null_char) exit
         text = text // bytes(i)
      end do
   end function text_at


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

      asked = sweep('bifurcation', '', 0, 0.0_wp, 0.0_wp, 0.0_wp, 1, 0.0_wp, 0.0_wp, 1_int64, 0, 1, 1)
      facts = facts_of(asked)
      do i = 1, size(facts)
         call get_fact(file, facts(i), good)
         if (.not. good) return
         call take(facts(i), asked)
      end do
      good = asked%vary > 0 .and. asked%points > 0 .and. asked%chunk > 0 .and. asked%periods > 0
   end subroutine read_sweep


   !> What a fact says of a sweep; compiler, version and the like say nothing
   subroutine take(given, asked)
      type(fact), intent(in) :: given
      type(sweep), intent(inout) :: asked

      select case (given%name)
      case ('subject')
         asked%subject = given%text
      case ('method')
         asked%method = given%text
      case ('vary')
         asked%vary = findloc(constants == given%text, .true., 1)
      case ('steps')
         asked%steps = int(given%whole)
      case ('points')
         asked%points = given%whole
      case ('transient')
         asked%transient = int(given%whole)
      case ('periods')
         asked%periods = int(given%whole)
      case ('chunk')
         asked%chunk = int(given%whole)
      case ('start_angle_degrees')
         asked%angle = given%number
      case ('start_rate')
         asked%rate = given%number
      case ('from')
         asked%from = given%number
      case ('to')
         asked%to = given%number
      case default
         if (.not. allocated(given%number)) return
         where (constants == given%name(:index(given%name // '_', '_') - 1)) asked%constant = given%number
      end select
   end subroutine take


   !> Open the file of a sweep to write numbers, all processes together
   subroutine open_file(path, asked, file, trouble)
      character(len=*), intent(in) :: path
      type(sweep), intent(in) :: asked
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
      type(sweep), intent(in) :: asked
      character(len=:), allocatable, intent(out) :: trouble
      type(quantity), allocatable :: all(:)
      integer :: failed, i, worst

      all = quantities(asked)
      allocate(file%numbers(size(all)))
      worst = 0
      do i = 1, size(all)
         call h5dopen_f(file%id, all(i)%name, file%numbers(i), failed)
         worst = min(worst, failed)
      end do
      call h5dopen_f(file%id, done_name, file%done, failed)
      worst = min(worst, failed)
      call h5dopen_f(file%id, session_name, file%session, failed)
      trouble = ''
      if (min(worst, failed) < 0) trouble = file%path // ': not a file of this program'
   end subroutine open_datasets


   !> Which chunks are there
   subroutine done_chunks(file, asked, done, trouble)
      type(ensemble_file), intent(in) :: file
      type(sweep), intent(in) :: asked
      logical, allocatable, intent(out) :: done(:)
      character(len=:), allocatable, intent(out) :: trouble
      integer(int8), allocatable, target :: marks(:)
      type(c_ptr) :: place
      integer :: failed

      allocate(marks(chunks(asked)), source=0_int8)
      place = c_loc(marks)
      call h5dread_f(file%done, h5kind_to_type(int8, h5_integer_kind), place, failed)
      trouble = ''
      if (failed < 0) trouble = file%path // ': cannot be read'
      done = marks == 1
   end subroutine done_chunks


   !> Spaces that pick the place of a chunk, or nothing, in memory and in the file
   subroutine pick(dataset, start, extents, something, memory, space)
      integer(hid_t), intent(in) :: dataset
      integer(int64), intent(in) :: start(:)
      integer(int64), intent(in) :: extents(:)
      logical, intent(in) :: something
      integer(hid_t), intent(out) :: memory
      integer(hid_t), intent(out) :: space
      integer :: failed

      call h5dget_space_f(dataset, space, failed)
      call h5screate_simple_f(size(extents), int(extents, hsize_t), memory, failed)
      if (something) then
         call h5sselect_hyperslab_f(space, h5s_select_set_f, int(start, hsize_t), &
            int(extents, hsize_t), failed)
      else
         call h5sselect_none_f(space, failed)
         call h5sselect_none_f(memory, failed)
      end if
   end subroutine pick


   !> Numbers of a quantity to the file, or from it
   subroutine move(file, which, asked, chunk, one, writes, failed)
      type(ensemble_file), intent(in) :: file
      integer, intent(in) :: which
      type(sweep), intent(in) :: asked
      integer(int64), intent(in) :: chunk
      type(quantity), intent(inout), target :: one
      logical, intent(in) :: writes
      integer, intent(out) :: failed
      integer(hid_t) :: kind, memory, space
      integer(int64) :: extents(2), start(2)
      type(c_ptr) :: place
      integer :: first, ignored

      if (allocated(one%reals)) then
         kind = h5kind_to_type(wp, h5_real_kind)
         place = c_loc(one%reals)
      else
         kind = h5kind_to_type(int64, h5_integer_kind)
         place = c_loc(one%wholes)
      end if
      start = 0
      extents = 1
      if (chunk >= 0) start(2) = first_member(asked, chunk)
      if (chunk >= 0) extents = [int(one%rows, int64), int(members_of(asked, chunk), int64)]
      first = merge(1, 2, one%each_period)
      call pick(file%numbers(which), start(first:), extents(first:), chunk >= 0, memory, space)
      if (writes) then
         call h5dwrite_f(file%numbers(which), kind, place, failed, memory, space, file%transfer)
      else
         call h5dread_f(file%numbers(which), kind, place, failed, memory, space, file%transfer)
      end if
      call h5sclose_f(memory, ignored)
      call h5sclose_f(space, ignored)
   end subroutine move


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
         call move(file, i, asked, chunk, results(i), .true., failed)
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
         call move(file, i, asked, chunk, results(i), .false., failed)
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
      integer(hid_t) :: memory, space
      integer :: failed, ignored

      mark = 1_int8
      call pick(file%done, [max(chunk, 0_int64)], [1_int64], chunk >= 0, memory, space)
      call h5dwrite_f(file%done, h5kind_to_type(int8, h5_integer_kind), c_loc(mark), failed, memory, space, &
         file%transfer)
      trouble = ''
      if (failed < 0) trouble = file%path // ': cannot be written; is the disk full?'
      call h5sclose_f(memory, ignored)
      call h5sclose_f(space, ignored)
   end subroutine mark_chunk


   !> How many chunks there were when the run began, and how long it has taken: for `status`. Process 0
   !> writes, the others are there.
   subroutine write_session(file, session)
      type(ensemble_file), intent(in) :: file
      real(wp), intent(in), target :: session(2)
      integer(hid_t) :: memory, space
      integer :: failed, number

      number = process()
      call pick(file%session, [0_int64], [2_int64], number == 0, memory, space)
      call h5dwrite_f(file%session, h5kind_to_type(wp, h5_real_kind), c_loc(session), failed, memory, space, &
         file%transfer)
      call h5sclose_f(memory, failed)
      call h5sclose_f(space, failed)
   end subroutine write_session


   function read_session(file) result(session)
      type(ensemble_file), intent(in) :: file
      real(wp), target :: session(2)
      type(c_ptr) :: place
      integer :: failed

      session = 0.0_wp
      place = c_loc(session)
      call h5dread_f(file%session, h5kind_to_type(wp, h5_real_kind), place, failed)
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
