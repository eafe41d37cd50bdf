! SPDX-License-Identifier: MIT

!> How a new file looks: every dataset with its place and its room on the disk, every attribute, and all
!> numbers that are known before anything is computed. From then on only numbers are put into places that
!> are there.
module furiko_ensemble_layout
   use, intrinsic :: iso_c_binding, only : c_int
   use, intrinsic :: iso_fortran_env, only : int64
   use furiko_ensemble_attractors, only : given_attractors
   use furiko_ensemble_facts, only : fact, facts_of
   use furiko_ensemble_hdf5, only : kind_in_file, move_numbers, put_dataset, put_fact, put_text, run
   use furiko_ensemble_sweep, only : chunks, first_member, member_extents, members_of, quantities, quantity, &
      scales, sweep
   use furiko_ensemble_system, only : file_reserve
   use h5ds, only : h5dsattach_scale_f, h5dsset_scale_f
   use hdf5, only : h5dclose_f, h5dget_offset_f, h5f_acc_trunc_f, h5fclose_f, h5fcreate_f, h5gclose_f, &
      h5gcreate_f, h5p_default_f, h5t_ieee_f64le, h5t_std_i8le, hid_t
   implicit none
   private
   public :: done_name, fill_new, session_name


   character(len=*), parameter :: done_name = 'progress/done', session_name = 'progress/session'


contains


   !> All that a file has but the numbers of its chunks
   subroutine fill_new(path, asked, descriptor, part, parts, failed)
      character(len=*), intent(in) :: path
      type(sweep), intent(in) :: asked
      integer(c_int), intent(in) :: descriptor
      !> Only these chunks are given room on the disk
      integer, intent(in) :: part
      integer, intent(in) :: parts
      integer(c_int), intent(out) :: failed
      type(quantity), allocatable :: all(:)
      type(fact), allocatable :: facts(:)
      integer(int64), allocatable :: offsets(:)
      integer(hid_t) :: file
      integer :: errors(3), i

      errors = 0
      all = quantities(asked)
      allocate(offsets(size(all)))
      facts = facts_of(asked)
      call h5fcreate_f(path, h5f_acc_trunc_f, file, errors(1))
      do i = 1, size(facts)
         call put_fact(file, facts(i))
      end do
      call put_progress(file, asked)
      if (asked%subject == 'basins') call put_attractors(file, asked, errors(2))
      call put_quantities(file, asked, all, offsets, errors(2))
      call h5fclose_f(file, errors(3))
      failed = -1
      if (any(errors < 0) .or. any(offsets < 0)) return
      failed = 0
      do i = 1, size(all)
         if (failed == 0) call reserve(asked, width_of(all(i)), offsets(i), descriptor, part, parts, failed)
      end do
   end subroutine fill_new


   !> Room for the numbers of a quantity
   subroutine reserve(asked, width, offset, descriptor, part, parts, failed)
      type(sweep), intent(in) :: asked
      !> Bytes a member
      integer(int64), intent(in) :: width
      !> Where they begin in the file
      integer(int64), intent(in) :: offset
      integer(c_int), intent(in) :: descriptor
      integer, intent(in) :: part
      integer, intent(in) :: parts
      integer(c_int), intent(out) :: failed
      integer(int64) :: chunk

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


   !> Bytes that a member has of a quantity
   pure function width_of(one) result(bytes)
      type(quantity), intent(in) :: one
      integer(int64) :: bytes

      bytes = one%rows*merge(4_int64, 8_int64, allocated(one%wholes))
   end function width_of


   subroutine put_progress(file, asked)
      integer(hid_t), intent(in) :: file
      type(sweep), intent(in) :: asked
      integer(hid_t) :: dataset
      integer :: failed

      call put_group(file, 'progress')
      call put_dataset(file, done_name, h5t_std_i8le, [chunks(asked)], dataset)
      call put_text(dataset, 'long_name', '1 where a chunk of members is computed and on the disk')
      call h5dclose_f(dataset, failed)
      call put_dataset(file, session_name, h5t_ieee_f64le, [2_int64], dataset)
      call put_text(dataset, 'long_name', 'chunks that were there when this run began; its seconds. 0: ended')
      call h5dclose_f(dataset, failed)
   end subroutine put_progress


   subroutine put_group(file, name)
      integer(hid_t), intent(in) :: file
      character(len=*), intent(in) :: name
      integer(hid_t) :: group
      integer :: failed

      call h5gcreate_f(file, name, group, failed)
      call h5gclose_f(group, failed)
   end subroutine put_group


   !> The points of all attractors, one after another
   subroutine put_attractors(file, asked, worst)
      integer(hid_t), intent(in) :: file
      type(sweep), intent(in) :: asked
      integer, intent(inout) :: worst
      type(quantity), allocatable :: all(:)
      integer(hid_t) :: dataset, direction
      integer :: failed, i

      call put_group(file, 'attractors')
      all = given_attractors(asked)
      call put_known(file, 'attractors/' // all(1)%name, all(1), direction, worst)
      call h5dsset_scale_f(direction, failed, all(1)%name)
      do i = 2, size(all)
         call put_known(file, 'attractors/' // all(i)%name, all(i), dataset, worst)
         call h5dsattach_scale_f(dataset, direction, 1, failed)
         call h5dclose_f(dataset, failed)
      end do
      call h5dclose_f(direction, failed)
   end subroutine put_attractors


   !> A dataset in one direction whose numbers are known
   subroutine put_known(file, name, one, dataset, worst)
      integer(hid_t), intent(in) :: file
      character(len=*), intent(in) :: name
      type(quantity), intent(in) :: one
      integer(hid_t), intent(out) :: dataset
      !> Below 0 from the first one on that cannot be written
      integer, intent(inout) :: worst
      type(quantity) :: copy
      integer(int64) :: n
      integer :: failed

      copy = one
      n = one%rows
      call put_dataset(file, name, kind_in_file(one), [n], dataset)
      call move_numbers(dataset, run([integer(int64) ::], [n], 0_int64, n), copy, .true., h5p_default_f, &
         failed)
      worst = min(worst, failed)
      call put_text(dataset, 'long_name', one%about)
      call put_text(dataset, 'units', one%units)
   end subroutine put_known


   !> The quantities, with names for their directions, and where in the file they begin. Directions are
   !> counted as C does, members first.
   subroutine put_quantities(file, asked, all, offsets, worst)
      integer(hid_t), intent(in) :: file
      type(sweep), intent(in) :: asked
      type(quantity), intent(in) :: all(:)
      integer(int64), intent(out) :: offsets(:)
      integer, intent(inout) :: worst
      type(quantity), allocatable :: known(:)
      integer(hid_t) :: dataset(size(all))
      integer(hid_t), allocatable :: directions(:)
      integer :: failed, i, j

      known = scales(asked)
      allocate(directions(size(known)))
      do i = 1, size(known)
         call put_known(file, known(i)%name, known(i), directions(i), worst)
         call h5dsset_scale_f(directions(i), failed, known(i)%name)
      end do
      do i = 1, size(all)
         call put_quantity(file, asked, all(i), dataset(i), offsets(i))
         if (i == 1 .and. asked%subject /= 'basins') then
            ! It tells the members apart, and so names their direction.
            call h5dsset_scale_f(dataset(i), failed, all(i)%name)
            directions = [dataset(i), directions]
         else
            do j = 1, size(member_extents(asked)) + merge(1, 0, all(i)%each_period)
               call h5dsattach_scale_f(dataset(i), directions(j), j, failed)
            end do
            call h5dclose_f(dataset(i), failed)
         end if
      end do
      do i = 1, size(directions)
         call h5dclose_f(directions(i), failed)
      end do
   end subroutine put_quantities


   subroutine put_quantity(file, asked, one, dataset, offset)
      integer(hid_t), intent(in) :: file
      type(sweep), intent(in) :: asked
      type(quantity), intent(in) :: one
      integer(hid_t), intent(out) :: dataset
      !> Where its numbers begin; -1 if it could not be made
      integer(int64), intent(out) :: offset
      integer(int64), allocatable :: extents(:)
      integer :: failed

      extents = member_extents(asked)
      if (one%each_period) extents = [int(one%rows, int64), extents]
      call put_dataset(file, one%name, kind_in_file(one), extents, dataset)
      call put_text(dataset, 'long_name', one%about)
      call put_text(dataset, 'units', one%units)
      call h5dget_offset_f(dataset, offset, failed)
      if (failed < 0) offset = -1
   end subroutine put_quantity
end module furiko_ensemble_layout
