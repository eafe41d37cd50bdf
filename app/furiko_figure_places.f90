! SPDX-License-Identifier: MIT

!> Where a label goes: beside its curve, where it is far from all other curves and labels.
module furiko_figure_places
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_figure_text, only : letters
   implicit none
   private
   public :: box, stroke, best_place, centred, dense, width_of, gap


   !> Of a label, in pixels: its height, a letter's width (that of a wide face), its distance from the curve
   real(wp), parameter :: height_of_text = 17.0_wp, width_of_letter = 8.2_wp, gap = 5.0_wp
   !> A label that other curves are this far from needs no better place.
   real(wp), parameter :: room = 14.0_wp


   !> A curve, or points, as this panel draws it
   type :: stroke
      integer :: which = 0
      integer :: pen = 1
      character(len=:), allocatable :: label
      integer :: side = 0
      !> Its points in pixels, close to each other
      real(wp), allocatable :: x(:)
      real(wp), allocatable :: y(:)
   end type stroke


   !> Sides of a rectangle, in pixels from the upper left corner of the paper
   type :: box
      real(wp) :: left = 0.0_wp
      real(wp) :: right = 0.0_wp
      real(wp) :: top = 0.0_wp
      real(wp) :: bottom = 0.0_wp
   end type box


contains


   !> Points in pixels, with others between those of a line that are far apart
   pure subroutine dense(x, y, is_line, this)
      real(wp), intent(in) :: x(:)
      real(wp), intent(in) :: y(:)
      logical, intent(in) :: is_line
      type(stroke), intent(inout) :: this
      real(wp), parameter :: far = 6.0_wp, out = 1e4_wp
      integer :: i, j, n, total
      integer :: pieces(size(x))

      pieces = 1
      if (is_line) then
         do i = 1, size(x) - 1
            if (hypot(x(i + 1) - x(i), y(i + 1) - y(i)) < out) pieces(i) = &
               1 + int(hypot(x(i + 1) - x(i), y(i + 1) - y(i))/far)
         end do
      end if
      total = sum(pieces)
      allocate(this%x(total), this%y(total))
      n = 0
      do i = 1, size(x)
         do j = 0, pieces(i) - 1
            n = n + 1
            this%x(n) = x(i) + (x(min(i + 1, size(x))) - x(i))*j/pieces(i)
            this%y(n) = y(i) + (y(min(i + 1, size(x))) - y(i))*j/pieces(i)
         end do
      end do
   end subroutine dense


   !> The place beside a curve, within the frame, that other curves and labels are farthest from
   pure function best_place(strokes, taken, frame, which) result(best)
      !> All curves of a panel
      type(stroke), intent(in) :: strokes(:)
      !> Rectangles that other labels have
      type(box), intent(in) :: taken(:)
      type(box), intent(in) :: frame
      !> The curve that bears the label
      integer, intent(in) :: which
      type(box) :: best
      type(box) :: place
      real(wp) :: highest, score, width
      integer :: i, side

      associate (own => strokes(which))
         width = width_of(own%label)
         best = centred((frame%left + frame%right)/2, frame%top + height_of_text, width)
         highest = -huge(highest)
         do i = 1, size(own%x), max(1, size(own%x)/150)
            do side = 1, 40
               place = beside(own%x(i), own%y(i), side, width)
               if (.not. is_within(place, frame)) cycle
               score = clearance(strokes, taken, place, which)
               if (own%side > 0 .and. modulo(side, 8) /= modulo(own%side, 8)) score = score - room
               ! Of places as good as each other the first, on every machine
               if (score <= highest + 0.01_wp) cycle
               highest = score
               best = place
            end do
         end do
      end associate
   end function best_place


   !> How good a place is for a label: how far all is that is not its curve, less how far that is; much less
   !> if it lies on something, or nearer to another curve.
   pure function clearance(strokes, taken, place, which) result(score)
      type(stroke), intent(in) :: strokes(:)
      type(box), intent(in) :: taken(:)
      type(box), intent(in) :: place
      integer, intent(in) :: which
      real(wp) :: score
      real(wp), parameter :: touching = 2.5_wp
      real(wp) :: nearest, others
      integer :: crossed, i

      crossed = 0
      others = huge(others)
      nearest = others
      do i = 1, size(taken)
         others = min(others, max(taken(i)%left - place%right, place%left - taken(i)%right, &
            taken(i)%top - place%bottom, place%top - taken(i)%bottom))
         if (others < touching) crossed = 20
      end do
      do i = 1, size(strokes)
         associate (distance => sqrt(apart(place, strokes(i)%x, strokes(i)%y)))
            if (i == which) nearest = minval(distance)
            if (i /= which) others = min(others, minval(distance))
            crossed = crossed + count(distance < touching)
         end associate
      end do
      score = min(others, room) - nearest/2 - room*crossed
      if (others <= nearest) score = score - room
   end function clearance


   !> The square of a point's distance from a rectangle
   elemental function apart(place, x, y)
      type(box), intent(in) :: place
      real(wp), intent(in) :: x
      real(wp), intent(in) :: y
      real(wp) :: apart

      apart = max(place%left - x, 0.0_wp, x - place%right)**2 + max(place%top - y, 0.0_wp, &
         y - place%bottom)**2
   end function apart


   !> A label's rectangle in one of eight directions from a point, in one of five distances
   pure function beside(x, y, side, width) result(place)
      real(wp), intent(in) :: x
      real(wp), intent(in) :: y
      !> From 1 to 40: above, below, left, right, and the corners, near ones first
      integer, intent(in) :: side
      real(wp), intent(in) :: width
      type(box) :: place
      integer, parameter :: right(8) = [0, 0, -1, 1, -1, 1, -1, 1], below(8) = [-1, 1, 0, 0, -1, -1, 1, 1]
      real(wp) :: distance
      integer :: way

      way = modulo(side - 1, 8) + 1
      distance = gap*(1 + (side - 1)/8)
      place = centred(x + right(way)*(distance + width/2), &
         y + below(way)*(distance + height_of_text/2), width)
   end function beside


   pure function centred(x, y, width) result(place)
      real(wp), intent(in) :: x
      real(wp), intent(in) :: y
      real(wp), intent(in) :: width
      type(box) :: place

      place = box(x - width/2, x + width/2, y - height_of_text/2, y + height_of_text/2)
   end function centred


   pure function is_within(inner, outer)
      type(box), intent(in) :: inner
      type(box), intent(in) :: outer
      logical :: is_within

      is_within = inner%left > outer%left + gap .and. inner%right <= outer%right .and. &
         inner%top >= outer%top .and. inner%bottom < outer%bottom - gap
   end function is_within


   !> A label's width in pixels, in a wide face
   pure function width_of(label) result(width)
      character(len=*), intent(in) :: label
      real(wp) :: width

      width = width_of_letter*letters(label)
   end function width_of

end module furiko_figure_places
