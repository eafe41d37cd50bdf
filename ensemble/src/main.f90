! SPDX-License-Identifier: MIT

!> ensemble: driven, damped pendulums by the million, in chunks, into one HDF5 file; doc/ensemble.md.
program main
   use, intrinsic :: iso_fortran_env, only : error_unit, int64, output_unit, wp => real64
   use furiko, only : driven_scheme
   use furiko_ensemble_attractors, only : same_attractors
   use furiko_ensemble_communicator, only : begin_processes, broadcast, end_processes, give_up, highest, &
      process, processes
   use furiko_ensemble_compute, only : compute
   use furiko_ensemble_file, only : close_file, difference, ensemble_file, hold_file, mark_chunk, open_file, &
      open_to_look, read_chunk, read_session, write_chunk, write_session
   use furiko_ensemble_hdf5, only : begin_hdf5
   use furiko_ensemble_options, only : read_request, request, usage
   use furiko_ensemble_progress, only : progress, progress_line
   use furiko_ensemble_shares, only : count_chunks, count_done, source_of, take_next
   use furiko_ensemble_sweep, only : chunks_of, quantities, quantity, scheme_of, sweep
   use furiko_ensemble_system, only : begin_system, end_system, seconds
   use furiko_ensemble_table, only : write_table
   implicit none
   !> Exit codes: not understood; refused or failed
   integer, parameter :: misuse = 2, refusal = 1
   type(request) :: wanted

   call begin_system()
   call begin_processes()
   call begin_hdf5()
   call read_request(wanted)
   if (wanted%trouble /= '') call refuse_all(wanted%trouble, misuse)
   select case (wanted%command)
   case ('help')
      if (process() == 0) call usage(output_unit)
   case ('status')
      if (process() == 0) call tell(wanted%path)
   case ('table')
      if (process() == 0) call show_table(wanted%path)
   case ('join')
      call join()
   case default
      call run(wanted)
   end select
   call end_processes()


contains


   !> All processes end, for a reason that all of them know; the first one tells it.
   subroutine refuse_all(trouble, code)
      character(len=*), intent(in) :: trouble
      integer, intent(in) :: code

      if (process() == 0) write(error_unit, '(a)') 'ensemble: ' // trouble
      call end_processes()
      call end_system(code)
   end subroutine refuse_all


   !> One process cannot go on, so none can.
   subroutine demand(trouble)
      character(len=*), intent(in) :: trouble

      if (trouble == '') return
      write(error_unit, '(a)') 'ensemble: ' // trouble
      call give_up(refusal)
   end subroutine demand


   !> Compute what a file does not have yet
   subroutine run(wanted)
      type(request), intent(inout) :: wanted
      type(ensemble_file) :: none(0)

      call prepare(wanted%path, wanted%asked, wanted%part, wanted%parts)
      call fill(wanted%path, wanted%asked, wanted%part, wanted%parts, none, .not. wanted%quiet)
   end subroutine run


   !> Copy what a file does not have yet from files of parts
   subroutine join()
      character(len=4096) :: word
      type(ensemble_file), allocatable :: parts(:)
      type(sweep) :: asked, other
      character(len=:), allocatable :: trouble
      logical :: running
      integer :: i

      allocate(parts(max(command_argument_count() - 2, 0)))
      if (size(parts) == 0) call refuse_all('join which files? ensemble join FILE PART ...', misuse)
      do i = size(parts), 1, -1
         call get_command_argument(i + 2, word)
         call open_to_look(trim(word), parts(i), other, running, trouble)
         if (trouble /= '') call refuse_all(trouble, refusal)
         if (i == size(parts)) asked = other
         ! Parts belong together only where all that decides about the numbers is the same.
         trouble = difference(parts(i)%path, asked)
         if (trouble == '' .and. .not. same_attractors(asked, other)) trouble = parts(i)%path // &
            ': its attractors are not those of the other parts'
         if (trouble /= '') call refuse_all(trouble, refusal)
      end do
      call get_command_argument(2, word)
      call prepare(trim(word), asked, 1, 1)
      call fill(trim(word), asked, 1, 1, parts, .true.)
   end subroutine join


   !> The first process makes or checks the file; all end where it cannot.
   subroutine prepare(path, asked, part, parts)
      character(len=*), intent(in) :: path
      type(sweep), intent(inout) :: asked
      integer, intent(in) :: part
      integer, intent(in) :: parts
      character(len=:), allocatable :: trouble
      integer :: refused

      trouble = ''
      refused = 0
      if (process() == 0) call hold_file(path, asked, part, parts, trouble)
      if (trouble /= '') refused = 1
      call broadcast(refused)
      if (refused /= 0) call refuse_all(trouble, refusal)
   end subroutine prepare


   !> Chunk after chunk: compute or copy, write, see it on the disk, mark. All processes do so in step, since
   !> they write together; who has no chunk left writes nothing.
   subroutine fill(path, asked, part, parts, sources, tells)
      character(len=*), intent(in) :: path
      type(sweep), intent(inout) :: asked
      integer, intent(in) :: part
      integer, intent(in) :: parts
      !> Files to copy from; none: compute
      type(ensemble_file), intent(inout) :: sources(:)
      logical, intent(in) :: tells
      type(ensemble_file) :: file
      type(progress) :: shown
      type(driven_scheme) :: scheme
      type(quantity), allocatable :: results(:)
      character(len=:), allocatable :: trouble
      integer(int64), allocatable :: of_each(:)
      integer(int64) :: all_of_part, before, chunk, found, mine, next, round, there
      integer :: many, this

      call open_file(path, asked, file, trouble)
      call demand(trouble)
      many = processes()
      this = process()
      allocate(of_each(many))
      call count_chunks(file, sources, part, parts, found, before, of_each, trouble)
      call demand(trouble)
      results = quantities(asked)
      scheme = scheme_of(asked)
      all_of_part = chunks_of(asked, part, parts)
      call shown%begin(tells .and. process() == 0)
      call write_session(file, [real(found, wp), 0.0_wp])
      mine = of_each(this + 1)
      next = part - 1 + int(parts, int64)*this
      do round = 1, highest(mine)
         chunk = -1
         if (round <= mine) call take_next(file, sources, int(parts, int64)*many, next, chunk)
         if (chunk >= 0 .and. size(sources) == 0) call compute(asked, scheme, chunk, results)
         if (chunk >= 0 .and. size(sources) > 0) then
            call read_chunk(sources(source_of(sources, chunk)), asked, chunk, results, trouble)
            call demand(trouble)
         end if
         call write_chunk(file, asked, chunk, results, trouble)
         call demand(trouble)
         call mark_chunk(file, chunk, trouble)
         call demand(trouble)
         call write_session(file, [real(found, wp), seconds() - shown%started])
         there = before + sum(min(of_each, round))
         call shown%show(progress_line(there, all_of_part, before, asked%chunk, &
            seconds() - shown%started), .false.)
      end do
      call write_session(file, [0.0_wp, 0.0_wp])
      call close_file(file, trouble)
      call demand(trouble)
      there = before + sum(of_each)
      call shown%show(path // ': ' // progress_line(there, all_of_part, before, asked%chunk, &
         seconds() - shown%started), .true.)
   end subroutine fill


   !> What a file says of itself: `ensemble status FILE`
   subroutine tell(path)
      character(len=*), intent(in) :: path
      type(ensemble_file) :: file
      type(sweep) :: asked
      character(len=:), allocatable :: line, trouble
      logical :: running
      real(wp) :: session(2)
      integer(int64) :: found

      call open_to_look(path, file, asked, running, trouble)
      call demand(trouble)
      call count_done(file, found, trouble)
      call demand(trouble)
      session = read_session(file)
      if (.not. running) session = 0.0_wp
      line = progress_line(found, file%chunks, int(session(1), int64), asked%chunk, session(2))
      if (found == file%chunks) then
         line = line // ', complete'
      else if (running) then
         line = line // ', running'
      else
         line = line // ', stopped: the same command again goes on'
      end if
      write(output_unit, '(a)') path // ': ' // asked%subject // ', ' // line
   end subroutine tell


   !> What a file has, as CSV: `ensemble table FILE`
   subroutine show_table(path)
      character(len=*), intent(in) :: path
      type(ensemble_file) :: file
      type(sweep) :: asked
      character(len=:), allocatable :: trouble
      logical :: running
      integer(int64) :: found

      call open_to_look(path, file, asked, running, trouble)
      call demand(trouble)
      call count_done(file, found, trouble)
      call demand(trouble)
      if (found < file%chunks) write(error_unit, '(a, i0, a, i0, a)') 'ensemble: ' // path // ': ', found, &
         ' of ', file%chunks, ' chunks are done; the table has these'
      call write_table(file, asked, trouble)
      call demand(trouble)
   end subroutine show_table
end program main
