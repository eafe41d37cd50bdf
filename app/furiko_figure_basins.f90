! SPDX-License-Identifier: MIT

!> Basins of attraction: which attractor each start comes to, and how soon.
module furiko_figure_basins
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : driven_attractors, driven_basins, driven_order8, driven_pendulum, driven_scheme, &
      driven_state
   use furiko_cli_io, only : refuse
   use furiko_cli_store, only : begin_store, store
   use furiko_cli_text, only : whole_text
   use furiko_figure, only : amplitude, black, blue, column, figure, fixed, green, orange, purple, to_text
   use furiko_figure_density, only : angle_column, middles, quantile
   use furiko_figure_places, only : width_of
   use furiko_figure_table, only : extent_of, longest_name, read_table
   implicit none
   private
   public :: basins_figure


   real(wp), parameter :: pi = acos(-1.0_wp)
   real(wp), parameter :: degree = pi/180
   real(wp), parameter :: drive = 1.4_wp
   !> Attractors that have a colour of their own, and the pens of these
   integer, parameter :: pens(*) = [blue, orange, green, purple]
   !> A cell is as dark as its pen where a start arrives at once, and so much paler where it arrives late.
   real(wp), parameter :: palest = 0.72_wp


   !> A grid of starts
   type :: grid
      integer(int64) :: across = 0
      integer(int64) :: up = 0
      !> Edges, in degrees and in units of sqrt(g/l)
      real(wp) :: angles(2) = 0.0_wp
      real(wp) :: rates(2) = 0.0_wp
   end type grid


contains


   subroutine basins_figure(amplitudes, self)
      type(amplitude), intent(in) :: amplitudes(:)
      type(figure), intent(inout) :: self
      type(store) :: rows
      type(grid) :: starts
      type(driven_state) :: points(64)
      character(len=longest_name) :: ignored
      integer :: label(64)

      associate (unused => amplitudes)
      end associate
      label = 0
      if (self%from == '') then
         call compute_basins(self%pixels()/2, points, label, rows)
      else
         call read_table(self%from, [character(len=9) :: 'angle_rad', 'rate', 'attractor', 'arrival'], 3, &
            rows, ignored)
      end if
      call measure(rows, self%from, starts)
      call self%begin([angle_column, column('rate_over_sqrt_g_by_l', 'angular rate over sqrt(g/l)'), &
         column('attractor', 'the number of the attractor that it comes to, 0 for none'), &
         column('arrival', 'periods of the drive until then, -1 for never')], &
         'Basins of attraction of a driven pendulum: a plane of starts, angle against angular rate, ' // &
         'each in the colour of the attractor that it comes to, paler where it takes longer, and ' // &
         'grey where it comes to none. The basins lie in folded layers beside each other.')
      call self%panel('angle <θ> at the start  (degrees)', 'angular rate  d<θ>/d<t> / √(<g>/<l>)', &
         starts%angles, starts%rates, cell=[1, 1, 1, 1])
      if (all(abs(abs(starts%angles) - 180) < 1.0_wp)) call self%say('set xtics 45')
      call add_cells(rows, starts, winding_names(points, label), self)
      call add_attractors(points, label, self)
      call self%plot()
   end subroutine basins_figure


   !> The attractors of a pendulum of Taylor's, driven by 1.4, and where some starts go
   subroutine compute_basins(cells, points, label, rows)
      !> How many, across and up
      integer, intent(in) :: cells(2)
      type(driven_state), intent(out) :: points(:)
      integer, intent(out) :: label(:)
      type(store), intent(out) :: rows
      ! An error of 1e-5 in a period moves no edge by a pixel
      integer, parameter :: steps = 16, forgotten = 60, longest = 4, patience = 100
      real(wp), parameter :: near = 1.0e-3_wp, edges(2) = [-3.0_wp, 3.0_wp]
      type(driven_pendulum) :: pendulum
      type(driven_state), allocatable :: start(:), state(:)
      integer, allocatable :: basin(:), arrival(:)
      integer :: found, i

      pendulum = driven_pendulum(damping=0.5_wp, amplitude=drive, frequency=2.0_wp/3.0_wp)
      start = plane([8, 8])
      call driven_attractors(driven_order8(steps), pendulum, start, forgotten, longest, points, label, found)
      start = plane(cells)
      state = start
      allocate(basin(size(start)), arrival(size(start)))
      call driven_basins(driven_order8(steps), pendulum, state, points, label, near, patience, basin, arrival)
      rows = begin_store(4)
      do i = 1, size(start)
         call rows%add([start(i)%angle, start(i)%rate, real(basin(i), wp), real(arrival(i), wp)])
      end do

   contains

      !> The middles of cells
      pure function plane(cells) result(state)
         integer, intent(in) :: cells(2)
         type(driven_state) :: state(cells(1)*cells(2))
         real(wp) :: angle(cells(1)), rate(cells(2))
         integer :: i

         angle = middles([-pi, pi], cells(1))
         rate = middles(edges, cells(2))
         do i = 1, size(state)
            state(i)%angle = angle(modulo(i - 1, cells(1)) + 1)
            state(i)%rate = rate((i - 1)/cells(1) + 1)
         end do
      end function plane

   end subroutine compute_basins


   !> The grid that the rows are, angle by angle, then rate by rate; refused if they are none
   subroutine measure(rows, file, starts)
      type(store), intent(inout) :: rows
      character(len=*), intent(in) :: file
      type(grid), intent(out) :: starts
      real(wp) :: extent(2, 4), first(4), row(4)
      integer(int64) :: ignored, i
      logical :: found, whole

      call extent_of(rows, extent, ignored)
      call rows%rewind()
      call rows%take(first, found)
      do while (found)
         starts%across = starts%across + 1
         call rows%take(row, found)
         if (abs(row(2) - first(2)) > 0.0_wp) exit
      end do
      starts%up = rows%rows/starts%across
      whole = starts%up*starts%across == rows%rows .and. min(starts%up, starts%across) > 1
      call rows%rewind()
      do i = 1, rows%rows
         call rows%take(row, found)
         if (modulo(i - 1, starts%across) == 0) first = row
         whole = whole .and. .not. abs(row(2) - first(2)) > 0.0_wp
      end do
      if (.not. whole) call refuse('furiko plot: --from ' // file // ': its rows are no grid of ' // &
         'angles for each of some rates, two or more of each')
      starts%angles = edges(extent(:, 1), starts%across)/degree
      starts%rates = edges(extent(:, 2), starts%up)

   contains

      !> From the outer cells' middles
      pure function edges(middle, cells)
         real(wp), intent(in) :: middle(2)
         integer(int64), intent(in) :: cells
         real(wp) :: edges(2)

         edges = middle + (middle(2) - middle(1))/(2*real(cells - 1, wp))*[-1, 1]
      end function edges

   end subroutine measure


   !> Draw the cells, no more of them than the paper has pixels, and say how large each basin is.
   subroutine add_cells(rows, starts, names, self)
      type(store), intent(inout) :: rows
      type(grid), intent(in) :: starts
      character(len=*), intent(in) :: names(:)
      type(figure), intent(inout) :: self
      integer, allocatable :: image(:, :, :)
      real(wp) :: row(4)
      integer(int64) :: members(0:size(pens) + 1)
      integer :: cells(2)
      integer(int64) :: i
      logical :: found

      cells = int(min([starts%across, starts%up], int(self%pixels(), int64)))
      allocate(image(cells(1), cells(2), 2))
      members = 0
      call rows%rewind()
      do i = 0, rows%rows - 1
         call rows%take(row, found)
         associate (x => int(modulo(i, starts%across)*cells(1)/starts%across) + 1, &
            y => int(i/starts%across*cells(2)/starts%up) + 1, &
            own => nint(max(0.0_wp, min(row(3), size(pens) + 1.0_wp))))
            image(x, y, :) = [own, nint(max(-1.0_wp, min(row(4), 1.0e9_wp)))]
            members(own) = members(own) + 1
         end associate
      end do
      associate (arrival => image(:, :, 2))
         self%script = self%script // colours_by(quantile(arrival, 0.02_wp), quantile(arrival, 0.98_wp))
      end associate
      call self%image('basins', middles(starts%angles, cells(1)), middles(starts%rates, cells(2)), image, &
         ':(part($4, $5, 16)):(part($4, $5, 8)):(part($4, $5, 0)) with rgbimage')
      call add_key(members, starts, names, self)
   end subroutine add_cells


   !> What the key calls the attractors: by their winding numbers where the points are known
   pure function winding_names(points, label) result(names)
      type(driven_state), intent(in) :: points(:)
      integer, intent(in) :: label(:)
      character(len=40) :: names(size(pens) + 1)
      integer(int64) :: turns
      integer :: i

      do i = 1, size(pens)
         names(i) = 'attractor ' // to_text(i)
         if (all(label /= i)) cycle
         turns = points(minloc(abs(label - i), 1))%turns
         names(i) = 'winding number ' // trim(merge('−', '   ', turns < 0)) // whole_text(abs(turns))
         if (count(label == i) > 1) names(i) = trim(names(i)) // '/' // to_text(count(label == i))
      end do
      names(size(names)) = 'others'
   end function winding_names


   !> gnuplot's functions for red, green and blue of an attractor and an arrival
   pure function colours_by(early, late) result(text)
      integer, intent(in) :: early
      integer, intent(in) :: late
      character(len=:), allocatable :: text
      character(len=*), parameter :: nl = new_line('a')

      text = 'pen(a) = a == 1 ? 0x0072B2 : a == 2 ? 0xB84A00 : a == 3 ? 0x00795A : a == 4 ? 0x8F3F83 : ' // &
         'a == 0 ? 0xA0A0A0 : 0x000000' // nl // &
         'late(t) = t < ' // to_text(early) // ' ? 0 : t > ' // to_text(late) // ' ? 1 : (t - ' // &
         to_text(early) // '.0)/' // to_text(max(late - early, 1)) // nl // &
         'part(a, t, shift) = mixed((pen(int(a)) >> shift) & 255, a == 0 ? 0 : ' // fixed(palest, 2) // &
         '*late(t))' // nl // &
         'mixed(c, w) = c + w*(255 - c)' // nl
   end function colours_by


   !> Above the panel, what the colours are
   subroutine add_key(members, starts, names, self)
      integer(int64), intent(in) :: members(0:)
      type(grid), intent(in) :: starts
      character(len=*), intent(in) :: names(:)
      type(figure), intent(inout) :: self
      real(wp), parameter :: above = 14.0_wp, apart = 16.0_wp, room = 158.0_wp
      ! Most faces are narrower than the one that labels find their places by
      real(wp), parameter :: narrow = 0.85_wp
      character(len=:), allocatable :: text
      integer :: frame(2), i
      real(wp) :: at
      logical :: crowded

      frame = self%pixels()
      crowded = count(members > 0)*(room + apart) > frame(1)
      at = 0.0_wp
      do i = 1, size(members)
         associate (which => modulo(i, size(members)))
            if (members(which) == 0) cycle
            text = 'grey: none'
            if (which > 0) text = '■ ' // trim(names(which))
            ! Where there are many, the number has to do
            if (crowded .and. which > 0 .and. which <= size(pens)) text = '■ ' // to_text(which)
            if (crowded .and. which == 0) text = 'grey'
            text = text // ', ' // fixed(100*(members(which)/real(sum(members), wp)), &
               merge(0, 1, crowded)) // ' %'
            call self%note(text, starts%angles(1) + (starts%angles(2) - starts%angles(1))*at/frame(1), &
               starts%rates(2) + (starts%rates(2) - starts%rates(1))*above/frame(2), 'left', pen_of(which))
            at = at + merge(narrow, 1.0_wp, crowded)*width_of(text) + apart
         end associate
      end do
   end subroutine add_key


   pure function pen_of(attractor) result(pen)
      integer, intent(in) :: attractor
      integer :: pen

      pen = black
      if (attractor >= 1 .and. attractor <= size(pens)) pen = pens(attractor)
   end function pen_of


   !> A disc at each point of the attractors, where there are any
   subroutine add_attractors(points, label, self)
      type(driven_state), intent(in) :: points(:)
      integer, intent(in) :: label(:)
      type(figure), intent(inout) :: self
      real(wp), dimension(size(points)) :: angle, rate
      integer :: i

      angle = points%angle/degree
      rate = points%rate
      do i = 1, maxval(label)
         associate (own => label == i)
            call self%add('points of attractor ' // to_text(i), pack(angle, own), pack(rate, own), &
               more=spread([real(i, wp), 0.0_wp], 1, count(own)))
            call self%draw(black, style='points pt 7 ps 0.9*scale')
         end associate
      end do
   end subroutine add_attractors

end module furiko_figure_basins
