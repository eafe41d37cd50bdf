! SPDX-License-Identifier: MIT

!> ensemble: driven, damped pendulums by the million, in chunks, into one HDF5 file; doc/ensemble.md.
program main
   use, intrinsic :: iso_fortran_env, only : error_unit, int64, output_unit, wp => real64
   use furiko, only : driven_scheme
   use furiko_ensemble_communicator, only : begin_processes, broadcast, end_processes, give_up, highest, &
      process, processes
   use furiko_ensemble_file, only : begin_files, close_file, difference, done_chunks, ensemble_file, &
      hold_file, mark_chunk, open_file, open_to_look, read_chunk, read_session, write_chunk, write_session
   use furiko_ensemble_options, only : read_request, request, usage
   use furiko_ensemble_progress, only : progress, progress_line
   use furiko_ensemble_sweep, only : chunks, compute, is_mine, quantities, quantity, scheme_of, sweep
   use furiko_ensemble_system, only : begin_system, end_system, seconds
   implicit none
   !> Exit codes: not understood; refused or failed
   integer, parameter :: misuse = 2, refusal = 1
   type(request) :: wanted

   call begin_system()
   call begin_processes()
   call begin_files()
   call read_request(wanted)
   if (wanted%trouble /= '') call refuse_all(wanted%trouble, misuse)
   select case (wanted%command)
   case ('help')
      if (process() == 0) call usage(output_unit)
   case ('status')
      if (process() == 0) call tell(wanted%path)
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
      type(request), intent(in) :: wanted
      type(ensemble_file) :: none(0)

      call prepare(wanted%path, wanted%asked, wanted%part, wanted%parts)
      call fill(wanted%path, wanted%asked, wanted%part, wanted%parts, none, .not. wanted%quiet)
   end subroutine run


   !> Copy what a file does not have yet from files of parts
   subroutine join()
      character(len=4096) :: word
      type(ensemble_file) :: parts(max(command_argument_count() - 2, 0))
      type(sweep) :: asked, other
      character(len=:), allocatable :: trouble
      logical :: running
      integer :: i

      if (size(parts) == 0) call refuse_all('join which files? ensemble join FILE PART ...', misuse)
      do i = size(parts), 1, -1
         call get_command_argument(i + 2, word)
         call open_to_look(trim(word), parts(i), other, running, trouble)
         if (trouble /= '') call refuse_all(trouble, refusal)
         if (i == size(parts)) asked = other
         ! Parts belong together only where all that decides about the numbers is the same.
         trouble = difference(parts(i)%path, asked)
         if (trouble /= '') call refuse_all(trouble, refusal)
      end do
      call get_command_argument(2, word)
      call prepare(trim(word), asked, 1, 1)
      call fill(trim(word), asked, 1, 1, parts, .true.)
   end subroutine join


   !> The first process makes or checks the file; all end where it cannot.
   subroutine prepare(path, asked, part, parts)
      character(len=*), intent(in) :: path
      type(sweep), intent(in) :: asked
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
      type(sweep), intent(in) :: asked
      integer, intent(in) :: part
      integer, intent(in) :: parts
      !> Files to copy from; none: compute
      type(ensemble_file), intent(in) :: sources(:)
      logical, intent(in) :: tells
      type(ensemble_file) :: file
      type(progress) :: shown
      type(driven_scheme) :: scheme
      type(quantity), allocatable :: results(:)
      integer(int64), allocatable :: to_do(:), of_each(:)
      integer, allocatable :: from(:)
      logical, allocatable :: done(:)
      character(len=:), allocatable :: trouble
      integer(int64) :: all_of_part, before, chunk, found, round, there

      call open_file(path, asked, file, trouble)
      call demand(trouble)
      call done_chunks(file, asked, done, trouble)
      call demand(trouble)
      call find_sources(asked, sources, from)
      found = count(done, kind=int64)
      all_of_part = count(is_mine([(chunk, chunk=0, chunks(asked) - 1)], part, parts), kind=int64)
      before = count(done .and. is_mine([(chunk, chunk=0, chunks(asked) - 1)], part, parts), kind=int64)
      call share(asked, done .or. from == 0, part, parts, to_do, of_each)
      results = quantities(asked)
      scheme = scheme_of(asked)
      call shown%begin(tells .and. process() == 0)
      call write_session(file, [real(found, wp), 0.0_wp])
      do round = 1, highest(size(to_do, kind=int64))
         chunk = -1
         if (round <= size(to_do)) chunk = to_do(round)
         if (chunk >= 0 .and. size(sources) == 0) call compute(asked, scheme, chunk, results)
         if (chunk >= 0 .and. size(sources) > 0) then
            call read_chunk(sources(from(chunk + 1)), asked, chunk, results, trouble)
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


   !> Chunks that this process has to do, and how many each process has
   subroutine share(asked, done, part, parts, to_do, of_each)
      type(sweep), intent(in) :: asked
      logical, intent(in) :: done(:)
      integer, intent(in) :: part
      integer, intent(in) :: parts
      integer(int64), allocatable, intent(out) :: to_do(:)
      integer(int64), allocatable, intent(out) :: of_each(:)
      integer(int64) :: chunk, mine(count(.not. done, kind=int64))
      integer :: last, owner, this

      last = processes()
      this = process()
      allocate(of_each(0:last - 1), source=0_int64)
      do chunk = 0, chunks(asked) - 1
         if (done(chunk + 1) .or. .not. is_mine(chunk, part, parts)) cycle
         ! The parts of a part: is_mine(chunk, part + parts*owner, parts*last)
         owner = int(modulo(chunk/parts, int(last, int64)))
         of_each(owner) = of_each(owner) + 1
         if (owner == this) mine(of_each(owner)) = chunk
      end do
      to_do = mine(:of_each(this))
   end subroutine share


   !> Which of the files has each chunk; 0 for none. Without files every chunk can be computed.
   subroutine find_sources(asked, sources, from)
      type(sweep), intent(in) :: asked
      type(ensemble_file), intent(in) :: sources(:)
      integer, allocatable, intent(out) :: from(:)
      logical, allocatable :: done(:)
      character(len=:), allocatable :: trouble
      integer :: i

      allocate(from(chunks(asked)), source=merge(1, 0, size(sources) == 0))
      do i = 1, size(sources)
         call done_chunks(sources(i), asked, done, trouble)
         call demand(trouble)
         where (done) from = i
      end do
   end subroutine find_sources


   !> What a file says of itself: `ensemble status FILE`
   subroutine tell(path)
      character(len=*), intent(in) :: path
      type(ensemble_file) :: file
      type(sweep) :: asked
      character(len=:), allocatable :: line, trouble
      logical, allocatable :: done(:)
      logical :: running
      real(wp) :: session(2)

      call open_to_look(path, file, asked, running, trouble)
      if (trouble == '') call done_chunks(file, asked, done, trouble)
      call demand(trouble)
      session = read_session(file)
      if (.not. running) session = 0.0_wp
      line = progress_line(count(done, kind=int64), size(done, kind=int64), int(session(1), int64), &
         asked%chunk, session(2))
      if (all(done)) then
         line = line // ', complete'
      else if (running) then
         line = line // ', running'
      else
         line = line // ', stopped: the same command again goes on'
      end if
      write(output_unit, '(a)') path // ': ' // asked%subject // ', ' // line
   end subroutine tell
end program main
