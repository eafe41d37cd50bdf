! SPDX-License-Identifier: MIT

!> What the program needs of HDF5: datasets that have their place at once, attributes, and runs of members
!> to and from a dataset.
module furiko_ensemble_hdf5
   use, intrinsic :: iso_c_binding, only : c_char, c_f_pointer, c_loc, c_null_char, c_ptr
   use, intrinsic :: iso_fortran_env, only : int32, int64, wp => real64
   use furiko_ensemble_facts, only : fact, text_fact
   use furiko_ensemble_sweep, only : quantity
   use hdf5, only : h5_integer_kind, h5_real_kind, h5aclose_f, h5acreate_f, h5aopen_f, h5aread_f, &
      h5awrite_f, h5d_alloc_time_early_f, h5d_fill_time_never_f, h5dcreate_f, h5dget_space_f, h5dread_f, &
      h5dwrite_f, h5eset_auto_f, h5kind_to_type, h5open_f, h5p_dataset_create_f, h5pclose_f, h5pcreate_f, &
      h5pset_alloc_time_f, h5pset_fill_time_f, h5pset_obj_track_times_f, h5s_scalar_f, h5s_select_or_f, &
      h5sclose_f, h5screate_f, h5screate_simple_f, h5sselect_hyperslab_f, h5sselect_none_f, &
      h5t_ieee_f64le, h5t_std_i32le, h5t_std_i64le, h5t_string, hid_t, hsize_t
   implicit none
   private
   public :: begin_hdf5, get_fact, kind_in_file, move_numbers, move_run, put_dataset, put_fact, put_text, run


   !> Members one after another in a dataset, whose directions are, the quickest first, those of `prefix`
   !> (periods, or none), all of them, and those of the members: one, or the two of a plane.
   type :: run
      integer(int64), allocatable :: prefix(:)
      integer(int64), allocatable :: extents(:)
      integer(int64) :: first = 0
      !> 0: nothing is moved, by a process that has to be there when others move theirs
      integer(int64) :: count = 0
   end type run


contains


   subroutine begin_hdf5()
      integer :: failed

      call h5open_f(failed)
      call h5eset_auto_f(0, failed)
   end subroutine begin_hdf5


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


   function kind_in_file(one) result(kind)
      type(quantity), intent(in) :: one
      integer(hid_t) :: kind

      kind = h5t_ieee_f64le
      if (allocated(one%wholes)) kind = h5t_std_i32le
   end function kind_in_file


   !> Numbers of a quantity to a dataset, or from it
   subroutine move_numbers(dataset, where, one, writes, transfer, failed)
      integer(hid_t), intent(in) :: dataset
      type(run), intent(in) :: where
      type(quantity), intent(inout), target :: one
      logical, intent(in) :: writes
      integer(hid_t), intent(in) :: transfer
      integer, intent(out) :: failed

      if (allocated(one%reals)) then
         call move_run(dataset, where, h5kind_to_type(wp, h5_real_kind), c_loc(one%reals), writes, transfer, &
            failed)
      else
         call move_run(dataset, where, h5kind_to_type(int32, h5_integer_kind), c_loc(one%wholes), writes, &
            transfer, failed)
      end if
   end subroutine move_numbers


   !> Numbers that lie at a place in memory to a dataset, or from it
   subroutine move_run(dataset, where, kind, place, writes, transfer, failed)
      integer(hid_t), intent(in) :: dataset
      type(run), intent(in) :: where
      integer(hid_t), intent(in) :: kind
      type(c_ptr), value :: place
      logical, intent(in) :: writes
      integer(hid_t), intent(in) :: transfer
      integer, intent(out) :: failed
      integer(hid_t) :: memory, space
      integer :: ignored

      call h5dget_space_f(dataset, space, failed)
      call select_run(space, where)
      call h5screate_simple_f(1, [max(product(where%prefix)*where%count, 1_int64)], memory, failed)
      if (where%count == 0) call h5sselect_none_f(memory, failed)
      if (writes) then
         call h5dwrite_f(dataset, kind, place, failed, memory, space, transfer)
      else
         call h5dread_f(dataset, kind, place, failed, memory, space, transfer)
      end if
      call h5sclose_f(memory, ignored)
      call h5sclose_f(space, ignored)
   end subroutine move_run


   !> In a plane a run is what is left of a row, whole rows, and the beginning of a row.
   subroutine select_run(space, where)
      integer(hid_t), intent(in) :: space
      type(run), intent(in) :: where
      integer(int64) :: at, block(2), left, start(2)
      integer :: failed, n

      call h5sselect_none_f(space, failed)
      n = size(where%extents)
      at = where%first
      left = where%count
      do while (left > 0)
         associate (width => where%extents(1))
            start = [modulo(at, width), at/width]
            block = [min(left, width - start(1)), 1_int64]
            if (block(1) == width) block(2) = left/width
         end associate
         call h5sselect_hyperslab_f(space, h5s_select_or_f, int([0*where%prefix, start(:n)], hsize_t), &
            int([where%prefix, block(:n)], hsize_t), failed)
         at = at + product(block)
         left = left - product(block)
      end do
   end subroutine select_run


   subroutine put_text(object, name, text)
      integer(hid_t), intent(in) :: object
      character(len=*), intent(in) :: name
      character(len=*), intent(in) :: text

      call put_fact(object, text_fact(name, text))
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
end module furiko_ensemble_hdf5
