! SPDX-License-Identifier: MIT

!> A figure: its curves, which the library computed, and the gnuplot commands that draw them. Pens, paper and
!> labels, the look that all figures share, are in this module and nowhere else.
!>
!> A figure is begun, then each of its panels is opened (`panel`), gets its curves (`add`, `draw`) and its
!> notes, and is closed (`plot`), when every label finds a place beside its curve that nothing crosses.
module furiko_figure
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_cli_text, only : append_to, replaced
   use furiko_figure_places, only : best_place, box, centred, dense, gap, stroke, width_of
   use furiko_figure_text, only : fixed, plain, ramp, significant, to_text
   implicit none
   private
   public :: figure, amplitude, column, paper, black, blue, orange, green, purple, solid
   public :: broken, fixed, line_break, significant, plain, ramp, to_text


   character(len=*), parameter :: nl = new_line('a')

   !> Pens. Each has at least 4.5:1 of contrast on white and a dash of its own, so that curves are told apart
   !> in grey and by every eye.
   integer, parameter :: black = 1, blue = 2, orange = 3, green = 4, purple = 5
   character(len=*), parameter :: colours(*) = [character(len=9) :: '"#000000"', '"#0072B2"', '"#B84A00"', &
      '"#00795A"', '"#8F3F83"']
   character(len=*), parameter :: dashes(*) = [character(len=17) :: '', ' dt (9, 3)', ' dt (4, 3)', &
      ' dt (9, 3, 2, 3)', ' dt (2, 2)']
   !> A dash other than a pen's own is told by the pen it belongs to.
   integer, parameter :: solid = black



   !> An amplitude of the command line
   type :: amplitude
      real(wp) :: radians = 0.0_wp
      !> As it was typed, with its unit: 30°, 0.3 rad
      character(len=:), allocatable :: label
      logical :: in_degrees = .true.
   end type amplitude


   !> What the figure is drawn on: pixels, and whether a title needs room above
   type :: paper
      integer :: width = 800
      integer :: height = 500
      logical :: has_title = .false.
   end type paper


   !> A column of the data: its name as the header says it, and what it holds in what unit
   type :: column
      character(len=32) :: name
      character(len=64) :: about
   end type column


   type :: curve
      character(len=:), allocatable :: name
      !> A row for each point, as many columns as the figure has
      real(wp), allocatable :: points(:, :)
      !> Of an image in place of them: the middles of its cells, and what the columns behind x and y hold:
      !> (x, y, column)
      real(wp), allocatable :: x(:)
      real(wp), allocatable :: y(:)
      integer, allocatable :: cells(:, :, :)
   end type curve


   type :: figure
      type(paper) :: sheet
      !> The file that the data come from; empty where the figure computes its own
      character(len=:), allocatable :: from
      !> What is seen, in a sentence or two: for those who do not see it
      character(len=:), allocatable :: about
      type(column), allocatable :: columns(:)
      type(curve), allocatable :: curves(:)
      !> The commands, one a line
      character(len=:), allocatable :: script
      !> Of the panel at hand: curves as `plot` takes them, strokes, rectangles that are taken, frame, ranges
      character(len=:), allocatable, private :: drawn
      type(stroke), allocatable, private :: strokes(:)
      type(box), allocatable, private :: taken(:)
      type(box), private :: frame
      real(wp), private :: x_range(2) = 0.0_wp, y_range(2) = 0.0_wp
      logical, private :: log_x = .false., log_y = .false.
   contains
      procedure :: begin
      procedure :: panel
      procedure :: add
      procedure :: draw
      procedure :: image
      procedure :: pixels
      procedure :: head
      procedure :: caption
      procedure :: note
      procedure :: arrow
      procedure :: say
      procedure :: plot
      procedure :: space
      procedure :: field
      procedure :: csv
      procedure, private :: across
      procedure, private :: down
      procedure, private :: put_label
   end type figure


contains


   subroutine begin(self, columns, about)
      class(figure), intent(inout) :: self
      type(column), intent(in) :: columns(:)
      character(len=*), intent(in) :: about

      self%columns = columns
      self%about = about
      self%script = ''
      allocate(self%curves(0))
   end subroutine begin


   !> Open a panel, one of `cell(2)` beside and `cell(4)` below each other, of the number `cell(1)` from the
   !> left and `cell(3)` from above.
   subroutine panel(self, x_label, y_label, x_range, y_range, log, cell, margin)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: x_label
      character(len=*), intent(in) :: y_label
      real(wp), intent(in) :: x_range(2)
      real(wp), intent(in) :: y_range(2)
      !> The axes that are logarithmic: 'x', 'y' or 'xy'
      character(len=*), intent(in), optional :: log
      integer, intent(in), optional :: cell(4)
      !> Pixels kept free on the right
      integer, intent(in), optional :: margin

      self%x_range = x_range
      self%y_range = y_range
      self%log_x = .false.
      self%log_y = .false.
      if (present(log)) self%log_x = index(log, 'x') > 0
      if (present(log)) self%log_y = index(log, 'y') > 0
      self%frame = frame_of(self%sheet, y_label /= '', cell)
      if (present(margin)) self%frame%right = self%frame%right - margin
      self%drawn = ''
      if (allocated(self%strokes)) deallocate(self%strokes, self%taken)
      allocate(self%strokes(0), self%taken(0))

      call self%say('unset label; unset arrow; unset logscale')
      call self%say('set lmargin at screen ' // to_text(self%frame%left/self%sheet%width) // &
         '; set rmargin at screen ' // to_text(self%frame%right/self%sheet%width))
      call self%say('set tmargin at screen ' // to_text(1 - self%frame%top/self%sheet%height) // &
         '; set bmargin at screen ' // to_text(1 - self%frame%bottom/self%sheet%height))
      if (self%log_x) call self%say('set logscale x')
      if (self%log_y) call self%say('set logscale y')
      call self%say('set xrange [' // to_text(x_range(1)) // ':' // to_text(x_range(2)) // ']')
      call self%say('set yrange [' // to_text(y_range(1)) // ':' // to_text(y_range(2)) // ']')
      ! Not as gnuplot's own labels: ylabel moves with the width of the numbers, and an SVG file has no xlabel
      ! where a margin is set.
      call put_text(self, x_label, box(self%frame%left, self%frame%right, self%frame%bottom + 50, &
         self%frame%bottom + 50), ' center')
      call put_text(self, y_label, box(self%frame%left - 70, self%frame%left - 70, self%frame%top, &
         self%frame%bottom), ' center rotate by 90')
   end subroutine panel


   !> The axes' rectangle, with room around it for their numbers and labels and for what stands above
   pure function frame_of(sheet, has_y_label, cell) result(frame)
      type(paper), intent(in) :: sheet
      logical, intent(in) :: has_y_label
      !> As of [[panel]]; without it there is no caption
      integer, intent(in), optional :: cell(4)
      type(box) :: frame
      real(wp) :: head, height, width
      integer :: place(4)

      place = 1
      if (present(cell)) place = cell
      head = merge(36.0_wp, 2.0_wp, sheet%has_title)
      width = (sheet%width - 4.0_wp)/place(2)
      height = (sheet%height - head - 32.0_wp)/place(4)
      frame%left = (place(1) - 1)*width + merge(84.0_wp, 60.0_wp, has_y_label)
      frame%right = place(1)*width - 18.0_wp
      frame%top = head + (place(3) - 1)*height + merge(30.0_wp, 14.0_wp, present(cell))
      frame%bottom = head + place(3)*height - 30.0_wp
   end function frame_of


   !> Width and height of the axes' rectangle, in pixels, of a figure of one panel with a caption
   pure function pixels(self)
      class(figure), intent(in) :: self
      integer :: pixels(2)

      associate (frame => frame_of(self%sheet, .true., [1, 1, 1, 1]))
         pixels = nint([frame%right - frame%left, frame%bottom - frame%top])
      end associate
   end function pixels


   !> Add a curve: its points, or, in a figure of more than two columns, rows of numbers; all finite but for
   !> rows of [[line_break]], where a line is broken or a row of a grid ends.
   subroutine add(self, name, x, y, more)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: x(:)
      real(wp), intent(in) :: y(:)
      !> The columns behind x and y; 0 if not given
      real(wp), intent(in), optional :: more(:, :)
      type(curve) :: new

      new%name = name
      allocate(new%points(size(x), size(self%columns)))
      new%points = 0.0_wp
      new%points(:, 1) = x
      new%points(:, 2) = y
      if (present(more)) new%points(:, 3:) = more
      call append(self%curves, new)
   end subroutine add


   subroutine append(curves, new)
      type(curve), allocatable, intent(inout) :: curves(:)
      type(curve), intent(in) :: new
      type(curve), allocatable :: longer(:)

      allocate(longer(size(curves) + 1))
      longer(:size(curves)) = curves
      longer(size(longer)) = new
      call move_alloc(longer, curves)
   end subroutine append


   !> Add an image, a grid of cells, and draw it. No label keeps clear of it. Every form of picture, an SVG
   !> file too, holds it as a bitmap.
   subroutine image(self, name, x, y, cells, how)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: name
      !> The middles of the cells, at least two each way
      real(wp), intent(in) :: x(:)
      real(wp), intent(in) :: y(:)
      !> What the columns behind x and y hold: (x, y, column)
      integer, intent(in) :: cells(:, :, :)
      !> What gnuplot is told behind the columns of x and y, as ':4 with image'
      character(len=*), intent(in) :: how
      type(curve) :: new

      new%name = name
      new%x = x
      new%y = y
      new%cells = cells
      call append(self%curves, new)
      call begin_drawing(self)
      self%drawn = self%drawn // ' using 2:3' // how // " title '" // name // "'"
   end subroutine image


   !> The last curve's place in the data, behind those that are drawn already
   subroutine begin_drawing(self)
      type(figure), intent(inout) :: self

      if (self%drawn /= '') self%drawn = self%drawn // ', \' // nl // '   '
      self%drawn = self%drawn // 'data skip head index ' // to_text(size(self%curves) - 1)
   end subroutine begin_drawing


   !> Draw the last curve, with a label that finds its place by itself.
   subroutine draw(self, pen, label, dash, style, x_column, side)
      class(figure), intent(inout) :: self
      integer, intent(in) :: pen
      character(len=*), intent(in), optional :: label
      !> The pen whose dash it takes; its own if none is given
      integer, intent(in), optional :: dash
      !> What gnuplot is told behind `with`, in place of lines; points take no dash
      character(len=*), intent(in), optional :: style
      !> The column of the data that is drawn for x, of which the curve's name is the first; 2 if not given
      integer, intent(in), optional :: x_column
      !> The side of its curve that the label keeps to if it can, as in [[beside]]
      integer, intent(in), optional :: side
      type(stroke) :: this
      type(stroke), allocatable :: longer(:)
      character(len=:), allocatable :: look
      integer :: n, x

      x = 2
      if (present(x_column)) x = x_column
      this%which = size(self%curves)
      this%pen = pen
      this%label = ''
      if (present(label)) this%label = label
      if (present(side)) this%side = side
      look = 'lines lw 2' // trim(dashes(pen))
      if (present(dash)) look = 'lines lw 2' // trim(dashes(dash))
      if (present(style)) look = style
      associate (points => self%curves(this%which)%points)
         call dense(self%across(points(:, x - 1)), self%down(points(:, 2)), index(look, 'lines') == 1, this)
      end associate
      n = size(self%strokes)
      allocate(longer(n + 1))
      longer(:n) = self%strokes
      longer(n + 1) = this
      call move_alloc(longer, self%strokes)

      call begin_drawing(self)
      self%drawn = self%drawn // ' using ' // to_text(x) // ':3 with ' // look // ' lc rgb ' // &
         colours(pen) // " title '" // self%curves(this%which)%name // "'"
   end subroutine draw


   !> An arrowhead on the last curve, behind its point of a number; none on a curve that is hardly larger
   subroutine head(self, point)
      class(figure), intent(inout) :: self
      integer, intent(in) :: point
      real(wp), parameter :: small = 40.0_wp

      associate (x => self%strokes(size(self%strokes))%x)
         if (maxval(x) - minval(x) < small) return
      end associate
      associate (points => self%curves(size(self%curves))%points)
         call self%say('set arrow from ' // to_text(points(point, 1)) // ', ' // to_text(points(point, &
            2)) // &
            ' to ' // to_text(points(point + 1, 1)) // ', ' // to_text(points(point + 1, 2)) // &
            ' head filled size screen 0.013,25 fixed lw 2 lc rgb ' // &
            colours(self%strokes(size(self%strokes))%pen))
      end associate
   end subroutine head


   !> Draw the last curve's points as arrows of equal length, in the direction of its third and fourth column.
   subroutine field(self, pen)
      class(figure), intent(inout) :: self
      integer, intent(in) :: pen
      real(wp), parameter :: length = 15.0_wp
      character(len=:), allocatable :: dx, dy

      dx = to_text((self%frame%right - self%frame%left)/(self%x_range(2) - self%x_range(1))/length)
      dy = to_text((self%frame%bottom - self%frame%top)/(self%y_range(2) - self%y_range(1))/length)
      call self%say('stretch(x, y) = 1/sqrt((x*' // dx // ')**2 + (y*' // dy // ')**2)')
      call self%draw(pen, style='vectors head size screen 0.008,20 lw 1')
      self%drawn = replaced(self%drawn, '2:3 with vectors', '($2-$4*stretch($4, ' // &
         '$5)/2):($3-$5*stretch($4, $5)/2):($4*stretch($4, $5)):($5*stretch($4, $5)) with vectors')
   end subroutine field


   !> Draw the last curve as a grid in space, in a panel of its own.
   subroutine space(self, x_label, y_label, z_label)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: x_label
      character(len=*), intent(in) :: y_label
      character(len=*), intent(in) :: z_label

      call self%say('unset label')
      call put_text(self, x_label, at(0.36_wp, 0.90_wp), ' center')
      call put_text(self, y_label, at(0.80_wp, 0.83_wp), ' left')
      call put_text(self, z_label, at(0.06_wp, 0.55_wp), ' center rotate by 90')
      call self%say('set border 895; set xyplane at -1.1; set view 55, 20; set hidden3d back offset 0')
      call self%say('set xtics 2; set ytics 0.25; set ztics 1')
      call self%say("splot data skip head index 0 using 2:3:4 with lines lw 1 lc rgb " // colours(blue) // &
         " title '" // self%curves(1)%name // "'")

   contains

      !> A point of the paper, in parts of it
      pure function at(right, below)
         real(wp), intent(in) :: right
         real(wp), intent(in) :: below
         type(box) :: at

         at%left = right*self%sheet%width
         at%right = at%left
         at%top = below*self%sheet%height
         at%bottom = at%top
      end function at

   end subroutine space


   !> A line above the panel
   subroutine caption(self, text)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: text

      call put_text(self, text, box(self%frame%left, self%frame%left, self%frame%top - 14, &
         self%frame%top - 14), ' left')
   end subroutine caption


   !> A remark at a point of the panel, on its right or on its left, which labels keep clear of
   subroutine note(self, text, x, y, side, pen)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: text
      real(wp), intent(in) :: x
      real(wp), intent(in) :: y
      !> left, right or center: how the text is aligned
      character(len=*), intent(in) :: side
      integer, intent(in), optional :: pen
      real(wp) :: edge, width

      width = width_of(text)
      edge = self%across(x)
      if (side == 'left') edge = edge + gap
      if (side == 'right') edge = edge - gap - width
      if (side == 'center') edge = edge - width/2
      call self%put_label(text, centred(edge + width/2, self%down(y), width), pen, side)
   end subroutine note


   !> A line from a point to another, with a head at its end if asked for
   subroutine arrow(self, x, y, pen, head)
      class(figure), intent(inout) :: self
      real(wp), intent(in) :: x(2)
      real(wp), intent(in) :: y(2)
      integer, intent(in) :: pen
      logical, intent(in) :: head

      call self%say('set arrow from ' // to_text(x(1)) // ', ' // to_text(y(1)) // ' to ' // &
         to_text(x(2)) // ', ' // to_text(y(2)) // merge(' head filled', ' nohead     ', head) // &
         ' lw 1.5 lc rgb ' // colours(pen))
   end subroutine arrow


   !> Add a line to the script, where <K> stands for a slanted K.
   subroutine say(self, line)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: line

      self%script = self%script // replaced(replaced(line, '<', '{/:Italic '), '>', '}') // nl
   end subroutine say


   !> Close the panel: labels find their places, and all is drawn.
   subroutine plot(self)
      class(figure), intent(inout) :: self
      integer :: i

      do i = 1, size(self%strokes)
         associate (this => self%strokes(i))
            if (this%label /= '') call self%put_label(this%label, best_place(self%strokes, self%taken, &
               self%frame, i), this%pen)
         end associate
      end do
      call self%say('plot ' // self%drawn)
   end subroutine plot


   !> Write a label into a rectangle, which is taken then.
   subroutine put_label(self, text, place, pen, side)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: text
      type(box), intent(in) :: place
      integer, intent(in), optional :: pen
      !> The end of the rectangle that the text keeps to; its middle if none is given
      character(len=*), intent(in), optional :: side
      character(len=:), allocatable :: how
      type(box) :: at

      self%taken = [self%taken, place]
      at = place
      how = ' center front'
      if (present(side)) how = ' ' // side // ' front'
      if (index(how, 'left') > 0) at%right = at%left
      if (index(how, 'right') > 0) at%left = at%right
      if (present(pen)) how = how // ' tc rgb ' // colours(pen)
      call put_text(self, text, at, how)
   end subroutine put_label


   !> Write a text into the middle of a rectangle, as told.
   subroutine put_text(self, text, place, how)
      class(figure), intent(inout) :: self
      character(len=*), intent(in) :: text
      type(box), intent(in) :: place
      character(len=*), intent(in) :: how

      call self%say('set label "' // text // '" at screen ' // &
         to_text((place%left + place%right)/2/self%sheet%width) // ', screen ' // &
         to_text(1 - (place%top + place%bottom)/2/self%sheet%height) // how)
   end subroutine put_text


   !> Pixels from the left of a value of x
   elemental function across(self, x) result(pixels)
      class(figure), intent(in) :: self
      real(wp), intent(in) :: x
      real(wp) :: pixels

      pixels = self%frame%left + part(x, self%x_range, self%log_x)*(self%frame%right - self%frame%left)
   end function across


   !> Pixels from the top of a value of y
   elemental function down(self, y) result(pixels)
      class(figure), intent(in) :: self
      real(wp), intent(in) :: y
      real(wp) :: pixels

      pixels = self%frame%bottom - part(y, self%y_range, self%log_y)*(self%frame%bottom - self%frame%top)
   end function down


   !> Which part of a range lies below a value
   pure function part(x, range, logarithmic)
      real(wp), intent(in) :: x
      real(wp), intent(in) :: range(2)
      logical, intent(in) :: logarithmic
      real(wp) :: part

      if (is_line_break(x)) then
         part = -1e6_wp
      else if (logarithmic) then
         part = log(max(x, tiny(x))/range(1))/log(range(2)/range(1))
      else
         part = (x - range(1))/(range(2) - range(1))
      end if
   end function part


   !> All curves as rows `curve,x,y`, two blank lines between them, where gnuplot sees the next, and one
   !> where a line is broken.
   pure function csv(self) result(text)
      class(figure), intent(in) :: self
      character(len=:), allocatable :: text
      integer :: i, length

      text = ''
      length = 0
      call append_to(text, length, 'curve')
      do i = 1, size(self%columns)
         call append_to(text, length, ',' // trim(self%columns(i)%name))
      end do
      call append_to(text, length, nl)
      do i = 1, size(self%curves)
         if (i > 1) call append_to(text, length, nl // nl)
         if (allocated(self%curves(i)%cells)) then
            call add_image_rows(self%curves(i), text, length)
         else
            call add_rows(self%curves(i), text, length)
         end if
      end do
      text = text(:length)
   end function csv


   !> The cells of an image, from left to right and from below upwards
   pure subroutine add_image_rows(self, text, length)
      type(curve), intent(in) :: self
      character(len=:), allocatable, intent(inout) :: text
      integer, intent(inout) :: length
      ! Letters of a number
      character(len=18) :: left(size(self%x)), up
      integer :: i, j, k

      do i = 1, size(self%x)
         left(i) = to_text(self%x(i))
      end do
      do j = 1, size(self%y)
         up = to_text(self%y(j))
         do i = 1, size(self%x)
            call append_to(text, length, self%name // ',' // trim(left(i)) // ',' // trim(up))
            do k = 1, size(self%cells, 3)
               call append_to(text, length, ',' // to_text(self%cells(i, j, k)))
            end do
            call append_to(text, length, nl)
         end do
      end do
   end subroutine add_image_rows


   pure subroutine add_rows(self, text, length)
      type(curve), intent(in) :: self
      character(len=:), allocatable, intent(inout) :: text
      integer, intent(inout) :: length
      integer :: i, j

      do i = 1, size(self%points, 1)
         if (.not. is_line_break(self%points(i, 1))) then
            call append_to(text, length, self%name)
            do j = 1, size(self%points, 2)
               call append_to(text, length, ',' // to_text(self%points(i, j)))
            end do
         end if
         call append_to(text, length, nl)
      end do
   end subroutine add_rows


   !> In place of a number: here a line is broken.
   pure function line_break()
      real(wp) :: line_break

      line_break = huge(line_break)
   end function line_break


   elemental function is_line_break(x)
      real(wp), intent(in) :: x
      logical :: is_line_break

      is_line_break = x >= huge(x)
   end function is_line_break


   !> A coordinate of a line that is broken where another coordinate, the angle, jumps by more than `jump`
   pure function broken(values, angle, jump) result(line)
      real(wp), intent(in) :: values(:)
      real(wp), intent(in) :: angle(:)
      real(wp), intent(in) :: jump
      real(wp), allocatable :: line(:)
      integer :: first, i

      allocate(line(0))
      first = 1
      do i = 2, size(values)
         if (abs(angle(i) - angle(i - 1)) <= jump) cycle
         line = [line, values(first:i - 1), line_break()]
         first = i
      end do
      line = [line, values(first:)]
   end function broken

end module furiko_figure
