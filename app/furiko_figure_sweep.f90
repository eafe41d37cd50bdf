! SPDX-License-Identifier: MIT

!> One number of a driven pendulum against a constant: the winding number, a devil's staircase, and the larger
!> Lyapunov exponent.
module furiko_figure_sweep
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : driven_exponents, driven_locking, driven_order8, driven_pendulum, driven_state, &
      driven_winding
   use furiko_cli_store, only : begin_store, store
   use furiko_figure, only : amplitude, black, blue, column, figure, orange, solid, to_text
   use furiko_figure_density, only : steps
   use furiko_figure_table, only : axis_of, extent_of, longest_name, padded, read_table
   implicit none
   private
   public :: exponents_figure, staircase_figure


   !> Winding numbers nearer to each other than that are those of one step
   real(wp), parameter :: same = 1.0e-7_wp


contains


   subroutine staircase_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      type(store) :: rows
      character(len=longest_name) :: varied
      real(wp), allocatable :: x(:), w(:)
      real(wp) :: extent(2, 2)
      integer(int64) :: ignored

      associate (unused => amplitudes)
      end associate
      if (self%from == '') then
         varied = 'torque'
         call compute_windings(size_of_family(self), rows)
      else
         call read_table(self%from, [character(len=7) :: '', 'winding'], 2, rows, varied)
      end if
      call extent_of(rows, extent, ignored)
      call begin_sweep(self, varied, column('winding', 'turns to a period of the drive'), extent, &
         'winding number  (turns a period)', 'The winding number of a driven pendulum, turns to a ' // &
         'period of the drive, against a constant, ' // trim(varied) // ': a devil''s staircase. Thick ' // &
         'horizontal lines are steps on which the pendulum is locked to the drive and the number is a ' // &
         'fraction; the dots between them are not locked, or locked on steps too narrow to see.')
      if (self%from == '') call self%caption( &
         'd^2<θ>/d<t>^2 = −sin <θ> − 1.5 d<θ>/d<t> + <I> + 1.5 cos <t>')
      call thin(rows, self%pixels(), extent(:, 1), x, w)
      call self%add('winding number', x, w)
      call self%draw(black, style='points pt 7 ps 0.25*scale')
      call add_steps(x, w, self)
      call self%plot()
   end subroutine staircase_figure


   subroutine exponents_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      type(store) :: rows
      character(len=longest_name) :: varied
      real(wp), allocatable :: x(:), exponent(:)
      real(wp) :: extent(2, 2)
      integer(int64) :: ignored

      associate (unused => amplitudes)
      end associate
      if (self%from == '') then
         varied = 'drive'
         call compute_exponents(size_of_family(self)/2, rows)
      else
         call read_table(self%from, [character(len=10) :: '', 'exponent_1'], 2, rows, varied)
      end if
      call extent_of(rows, extent, ignored)
      extent(:, 2) = [min(extent(1, 2), 0.0_wp), max(extent(2, 2), 0.0_wp)]
      call begin_sweep(self, varied, column('exponent', 'the larger Lyapunov exponent over ' // &
         'sqrt(g/l)'), extent, 'Lyapunov exponent  <λ> / <ω>_0', &
         'The larger Lyapunov exponent of a driven pendulum against a constant, ' // trim(varied) // &
         '. Below zero neighbours come together, and the motion is periodic; above it, ' // &
         'where the area is filled, they part, and it is chaotic.')
      if (self%from == '') call self%caption( &
         'd^2<θ>/d<t>^2 = −sin <θ> − 0.5 d<θ>/d<t> + <g> cos(2<t>/3)')
      ! Two decimals would reach into the axis's label
      if (abs(extent(2, 2) - extent(1, 2) - 0.6_wp) < 0.4_wp) call self%say('set ytics 0.1')
      call thin(rows, self%pixels(), extent(:, 1), x, exponent)
      call self%add('chaos', x, max(exponent, 0.0_wp))
      call self%draw(orange, style='filledcurves y=0 fs solid 0.35 noborder')
      call self%arrow(extent(:, 1), [0.0_wp, 0.0_wp], black, head=.false.)
      call self%add('exponent', x, exponent)
      call self%draw(blue, style='lines lw 1.2')
      call self%plot()
   end subroutine exponents_figure


   subroutine begin_sweep(self, varied, what, extent, label, about)
      type(figure), intent(inout) :: self
      character(len=*), intent(in) :: varied
      type(column), intent(in) :: what
      real(wp), intent(in) :: extent(2, 2)
      character(len=*), intent(in) :: label
      character(len=*), intent(in) :: about
      real(wp) :: x_range(2)

      x_range = extent(:, 1)
      if (.not. x_range(2) > x_range(1)) x_range = padded(x_range, 0.5_wp)
      call self%begin([column(varied, 'what was varied'), what], about)
      call self%panel(axis_of(trim(varied)), label, x_range, padded(extent(:, 2), 0.01_wp), cell=[1, 1, 1, 1])
   end subroutine begin_sweep


   !> One member for each pixel of the width
   function size_of_family(self) result(members)
      type(figure), intent(in) :: self
      integer :: members
      integer :: frame(2)

      frame = self%pixels()
      members = frame(1) + 1
   end function size_of_family


   !> From rest at the bottom, each member; exact where it is locked
   subroutine compute_windings(members, rows)
      integer, intent(in) :: members
      type(store), intent(out) :: rows
      ! 360 periods are whole cycles of most lengths, and so exact on steps of double the period, too
      integer, parameter :: forgotten = 300, counted = 360, longest = 12
      real(wp), parameter :: first = 0.8_wp, last = 1.4_wp, near = 1.0e-6_wp
      type(driven_pendulum) :: pendulum(members)
      type(driven_state) :: state(members)
      real(wp) :: torque(members), winding(members)
      integer :: i, period(members)
      integer(int64) :: turns(members)

      torque = [(first + (last - first)*(i - 1)/(members - 1), i=1, members)]
      pendulum = driven_pendulum(damping=1.5_wp, amplitude=1.5_wp, frequency=1.0_wp)
      pendulum%torque = torque
      call driven_winding(driven_order8(steps), pendulum, state, forgotten, counted, winding)
      call driven_locking(driven_order8(steps), pendulum, state, longest, near, period, turns)
      where (period > 0) winding = real(turns, wp)/period
      rows = begin_store(2)
      do i = 1, members
         call rows%add([torque(i), winding(i)])
      end do
   end subroutine compute_windings


   subroutine compute_exponents(members, rows)
      integer, intent(in) :: members
      type(store), intent(out) :: rows
      integer, parameter :: forgotten = 150, counted = 480
      real(wp), parameter :: first = 1.0_wp, last = 1.5_wp
      type(driven_pendulum) :: pendulum(members)
      type(driven_state) :: state(members)
      real(wp) :: drive(members), error(members), exponents(2, members)
      integer :: i

      drive = [(first + (last - first)*(i - 1)/(members - 1), i=1, members)]
      pendulum = driven_pendulum(damping=0.5_wp, frequency=2.0_wp/3.0_wp)
      pendulum%amplitude = drive
      call driven_exponents(driven_order8(steps), pendulum, state, forgotten, counted, exponents, error)
      rows = begin_store(2)
      do i = 1, members
         call rows%add([drive(i), exponents(1, i)])
      end do
   end subroutine compute_exponents


   !> The points of a curve. Of more than four to a pixel of the width only the lowest and the highest of each
   !> pixel are left, which is all that a picture shows.
   subroutine thin(rows, frame, x_range, x, y)
      type(store), intent(inout) :: rows
      !> Pixels, across and up
      integer, intent(in) :: frame(2)
      real(wp), intent(in) :: x_range(2)
      real(wp), allocatable, intent(out) :: x(:)
      real(wp), allocatable, intent(out) :: y(:)
      real(wp), allocatable :: low(:, :), high(:, :)
      real(wp) :: row(2)
      integer :: cells, place
      integer(int64) :: i
      logical :: found, all_of_them

      all_of_them = rows%rows <= 4*frame(1)
      cells = merge(int(min(rows%rows, 4_int64*frame(1))), frame(1), all_of_them)
      allocate(low(2, cells), high(2, cells))
      low = huge(low)
      high = -huge(high)
      call rows%rewind()
      do i = 1, rows%rows
         call rows%take(row, found)
         place = int(i)
         if (.not. all_of_them) place = min(cells, 1 + int(cells*(row(1) - x_range(1))/max(x_range(2) - &
            x_range(1), tiny(row))))
         if (row(2) < low(2, place)) low(:, place) = row
         if (row(2) > high(2, place)) high(:, place) = row
      end do
      x = low(1, :)
      y = low(2, :)
      if (all_of_them) return
      x = pack(reshape([low(1, :), high(1, :)], [2, cells], order=[2, 1]), .true.)
      y = pack(reshape([low(2, :), high(2, :)], [2, cells], order=[2, 1]), .true.)
      associate (there => abs(x) < huge(x))
         y = pack(y, there)
         x = pack(x, there)
      end associate
   end subroutine thin


   !> Where neighbours have the same winding number they stand on one step, locked. The widest bear their
   !> fractions, each once.
   subroutine add_steps(x, w, self)
      real(wp), intent(in) :: x(:)
      real(wp), intent(in) :: w(:)
      type(figure), intent(inout) :: self
      integer, parameter :: labelled = 14
      integer :: first(size(x)), last(size(x)), i, n
      real(wp) :: width(size(x))
      character(len=:), allocatable :: name
      logical :: widest

      call find_steps(w, first, last, n)
      width(:n) = abs(x(last(:n)) - x(first(:n)))
      do i = 1, n
         name = as_fraction(w(first(i)))
         widest = count(width(:n) > width(i)) < labelled .and. &
            all(width(:n) < width(i) .or. abs(w(first(:n)) - w(first(i))) > same .or. first(:n) == first(i))
         call self%add('locked at ' // name, x([first(i), last(i)]), w([first(i), last(i)]))
         if (.not. widest) name = ''
         call self%draw(blue, name, style='lines lw 4.5')
      end do
   end subroutine add_steps


   !> Runs of at least three equal numbers
   pure subroutine find_steps(w, first, last, number)
      real(wp), intent(in) :: w(:)
      integer, intent(out) :: first(:)
      integer, intent(out) :: last(:)
      !> How many
      integer, intent(out) :: number
      integer, parameter :: least = 3
      integer :: begin, i

      number = 0
      begin = 1
      do i = 1, size(w)
         if (i < size(w)) then
            if (abs(w(i + 1) - w(i)) <= same) cycle
         end if
         if (i - begin + 1 >= least) then
            number = number + 1
            first(number) = begin
            last(number) = i
         end if
         begin = i + 1
      end do
   end subroutine find_steps


   !> 1/2; the number itself where it is no fraction of small numbers
   pure function as_fraction(w) result(text)
      real(wp), intent(in) :: w
      character(len=:), allocatable :: text
      integer :: period

      do period = 1, 64
         if (abs(w*period - anint(w*period)) > 1.0e-6_wp*period) cycle
         text = to_text(nint(w*period))
         if (period > 1) text = text // '/' // to_text(period)
         return
      end do
      text = to_text(w)
   end function as_fraction

end module furiko_figure_sweep
