! SPDX-License-Identifier: MIT

!> Points so many that their density is drawn: a bifurcation diagram and a section, cell by cell of the paper.
module furiko_figure_density
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : driven_is_near, driven_order8, driven_pendulum, driven_periods, driven_section, &
      driven_state
   use furiko_cli_store, only : begin_store, store
   use furiko_figure, only : amplitude, column, figure
   use furiko_figure_table, only : axis_of, extent_of, longest_name, padded, read_table
   implicit none
   private
   public :: add_density, angle_column, angle_range, bifurcation_figure, middles, quantile


   real(wp), parameter :: pi = acos(-1.0_wp)
   real(wp), parameter :: degree = pi/180
   !> Steps a period, for pictures: an error of 1e-7 in a period
   integer, parameter, public :: steps = 24
   type(column), parameter :: angle_column = column('angle_deg', 'angle in degrees, -180 to 180')


contains


   !> Columns of the paper are shaded by what part of the points of their values each cell has. So a thin line
   !> of one period is as black as the bands of chaos are grey.
   subroutine bifurcation_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      type(store) :: rows
      character(len=longest_name) :: varied
      real(wp) :: extent(2, 2), half
      integer(int64) :: values
      integer :: cells(2)

      associate (unused => amplitudes)
      end associate
      cells = self%pixels()
      if (self%from == '') then
         varied = 'drive'
         call compute_cascade(cells(1), rows)
      else
         call read_table(self%from, [character(len=9) :: '', 'angle_rad'], 2, rows, varied)
      end if
      call extent_of(rows, extent, values)
      cells(1) = int(max(2_int64, min(values, int(cells(1), int64))))
      half = max(0.5_wp, 1.0e-6_wp*abs(extent(1, 1)))
      if (values > 1) half = (extent(2, 1) - extent(1, 1))/(2*real(values - 1, wp))
      call self%begin([column(varied, 'what was varied'), angle_column, &
         column('points', 'points of the section in the cell'), &
         column('shade', '100 for the fullest cell of its column, 0 for none')], &
         'A bifurcation diagram: the angles of a driven pendulum at the beginning of periods of the ' // &
         'drive, against a constant, ' // trim(varied) // '. Thin lines are cycles, one line for each ' // &
         'period; grey bands are chaos, darker where the pendulum comes by more often.')
      call self%panel(axis_of(trim(varied)), 'angle <θ>  (degrees)', extent(:, 1) + half*[-1, 1], &
         angle_range(extent(:, 2)/degree), cell=[1, 1, 1, 1])
      if (self%from == '') call self%caption('d^2<θ>/d<t>^2 = −sin <θ> − 0.5 d<θ>/d<t> + ' // &
         '<g> cos(2<t>/3), once a period of the drive')
      call add_density(self, rows, [1.0_wp, degree], extent(:, 1) + half*[-1, 1], &
         angle_range(extent(:, 2)/degree), cells, by_column=.true.)
      call self%plot()
   end subroutine bifurcation_figure


   !> The cascade of Taylor's chapter 12, one value for each column of the paper. Of a cycle a few points are
   !> all that there are; what has come to none goes on for as many as show where chaos comes by more often.
   subroutine compute_cascade(values, rows)
      integer, intent(in) :: values
      type(store), intent(out) :: rows
      integer, parameter :: forgotten = 300, few = 64, many = 2400
      real(wp), parameter :: first = 1.06_wp, last = 1.087_wp
      type(driven_pendulum) :: pendulum(values)
      type(driven_state) :: state(values)
      real(wp) :: drive(values)
      logical :: closed(values)
      integer :: i

      drive = [(first + (last - first)*(i - 1)/(values - 1), i=1, values)]
      pendulum = driven_pendulum(damping=0.5_wp, frequency=2.0_wp/3.0_wp)
      pendulum%amplitude = drive
      state = driven_state(angle=-pi/2)
      call driven_periods(driven_order8(steps), pendulum, state, forgotten)
      closed = are_closed(pendulum, state)
      rows = begin_store(2)
      call add_section(pack(pendulum, closed), pack(state, closed), few, rows)
      call add_section(pack(pendulum, .not. closed), pack(state, .not. closed), many, rows)
   end subroutine compute_cascade


   !> Whether members are on cycles of so many periods or of a part of that
   function are_closed(pendulum, state) result(closed)
      type(driven_pendulum), intent(in) :: pendulum(:)
      type(driven_state), intent(in) :: state(:)
      logical :: closed(size(state))
      integer, parameter :: periods = 32
      real(wp), parameter :: near = 1.0e-5_wp
      type(driven_state) :: later(size(state))

      later = state
      call driven_periods(driven_order8(steps), pendulum, later, periods)
      closed = driven_is_near(later, state, near)
   end function are_closed


   !> Drive and angle at the beginning of so many periods
   subroutine add_section(pendulum, start, periods, rows)
      type(driven_pendulum), intent(in) :: pendulum(:)
      type(driven_state), intent(in) :: start(:)
      integer, intent(in) :: periods
      type(store), intent(inout) :: rows
      type(driven_state) :: state(size(start))
      type(driven_state), allocatable :: points(:, :)
      integer :: i, j

      state = start
      allocate(points(periods, size(state)))
      call driven_section(driven_order8(steps), pendulum, state, 0, points)
      do i = 1, size(state)
         do j = 1, periods
            call rows%add([pendulum(i)%amplitude, points(j, i)%angle])
         end do
      end do
   end subroutine add_section


   !> What an axis of angles shows: what is occupied, or a whole turn where that is nearly all of it
   pure function angle_range(occupied) result(range)
      real(wp), intent(in) :: occupied(2)
      real(wp) :: range(2)
      real(wp), parameter :: most = 300.0_wp, least = 0.5_wp

      range = padded(occupied, least)
      if (occupied(2) - occupied(1) > most .and. all(abs(occupied) < 180.5_wp)) range = [-180.0_wp, 180.0_wp]
   end function angle_range


   !> Draw the first two columns of some rows as an image of their density. The square root makes rare points
   !> visible beside frequent ones, and no point is paler than a quarter.
   subroutine add_density(self, rows, units, x_range, y_range, cells, by_column)
      type(figure), intent(inout) :: self
      type(store), intent(inout) :: rows
      !> What the columns are divided by
      real(wp), intent(in) :: units(2)
      real(wp), intent(in) :: x_range(2)
      real(wp), intent(in) :: y_range(2)
      !> How many, across and up
      integer, intent(in) :: cells(2)
      !> Whether each column of cells has a black of its own
      logical, intent(in) :: by_column
      real(wp), parameter :: palest = 25.0_wp
      integer :: fullest(cells(1)), i
      integer, allocatable :: image(:, :, :)

      allocate(image(cells(1), cells(2), 2))
      call count_points(rows, units, x_range, y_range, image(:, :, 1))
      fullest = maxval(image(:, :, 1), 2)
      if (.not. by_column) fullest = quantile(image(:, :, 1), 0.99_wp)
      do i = 1, cells(1)
         image(i, :, 2) = merge(nint(palest + (100 - palest)*sqrt(min(1.0_wp, real(image(i, :, 1), &
            wp)/max(fullest(i), 1)))), 0, image(i, :, 1) > 0)
      end do
      call self%say("set palette defined (0 '#ffffff', 100 '#000000'); set cbrange [0:100]; unset colorbox")
      call self%image('density', middles(x_range, cells(1)), middles(y_range, cells(2)), image, &
         ':5 with image')
   end subroutine add_density


   !> How many rows fall into each cell
   subroutine count_points(rows, units, x_range, y_range, counts)
      type(store), intent(inout) :: rows
      real(wp), intent(in) :: units(2)
      real(wp), intent(in) :: x_range(2)
      real(wp), intent(in) :: y_range(2)
      integer, intent(out) :: counts(:, :)
      real(wp) :: row(2)
      integer :: i, j
      logical :: found

      counts = 0
      call rows%rewind()
      do
         call rows%take(row, found)
         if (.not. found) return
         i = place(row(1)/units(1), x_range, size(counts, 1))
         j = place(row(2)/units(2), y_range, size(counts, 2))
         if (counts(i, j) < huge(i)) counts(i, j) = counts(i, j) + 1
      end do

   contains

      !> The cell that a value falls into
      pure function place(value, range, cells)
         real(wp), intent(in) :: value
         real(wp), intent(in) :: range(2)
         integer, intent(in) :: cells
         integer :: place

         place = min(cells, 1 + int(cells*max(0.0_wp, (value - range(1))/(range(2) - range(1)))))
      end function place

   end subroutine count_points


   !> The least number that so large a part of those above 0 do not exceed; 1 where there is none
   pure function quantile(numbers, part) result(least)
      integer, intent(in) :: numbers(:, :)
      real(wp), intent(in) :: part
      integer :: least
      integer, parameter :: most = 100000
      integer, allocatable :: times(:)
      integer :: i, j

      allocate(times(most), source=0)
      do j = 1, size(numbers, 2)
         do i = 1, size(numbers, 1)
            if (numbers(i, j) <= 0) cycle
            associate (number => min(numbers(i, j), most))
               times(number) = times(number) + 1
            end associate
         end do
      end do
      i = 0
      do least = 1, most - 1
         i = i + times(least)
         if (i >= part*sum(times)) return
      end do
   end function quantile


   !> The middles of equal cells of a range
   pure function middles(range, cells) result(x)
      real(wp), intent(in) :: range(2)
      integer, intent(in) :: cells
      real(wp) :: x(cells)
      integer :: i

      x = [(range(1) + (range(2) - range(1))*(i - 0.5_wp)/cells, i=1, cells)]
   end function middles

end module furiko_figure_density
