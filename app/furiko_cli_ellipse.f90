! SPDX-License-Identifier: MIT

!> `furiko perimeter` and `furiko arc`: lengths along an ellipse.
module furiko_cli_ellipse
   use, intrinsic :: iso_fortran_env, only : int64, wp => real64
   use furiko, only : ellipeinc_inverse_mc, ellipeinc_mc, ellipse_perimeter_series
   use furiko_cli_io, only : finish
   use furiko_cli_options, only : command, command_line, demand, option
   use furiko_cli_quantity, only : angle_of, in_degrees, metres, number_of, whole_of
   use furiko_cli_sheet, only : begin_sheet, column, digits, format_option, places, sheet, whole
   use furiko_word_arithmetic_dp, only : words, pi_words, mean_with_one, operator(+), operator(-), &
      operator(*), operator(/)
   implicit none
   private
   public :: perimeter_usage, arc_usage


contains


   function perimeter_usage() result(usage)
      type(command) :: usage

      usage = command('perimeter', 'of an ellipse', 'A B', 2, &
         'The perimeter of an ellipse with semiaxes A and B, in their unit (metres if they have one).', &
         example='furiko perimeter 2 1', options=[ &
         option('--terms', 'N', '', 'a further column: by the first N terms of its series'), &
         format_option], run=perimeter_command)
   end function perimeter_usage


   subroutine perimeter_command(line)
      type(command_line), intent(in) :: line
      type(column), parameter :: columns(2) = [column('perimeter', digits, 16), column('series', digits, 12)]
      type(sheet) :: page
      type(words) :: axes(2), row(2)
      integer :: last, terms

      axes = axes_of(line)
      terms = 1
      if (line%given('--terms')) terms = whole_of(line%value('--terms'), 1, 1000000)
      last = merge(2, 1, line%given('--terms'))
      page = begin_sheet(line, columns(:last))
      row = [perimeter(axes), words(ellipse_perimeter_series(axes(1)%hi, axes(2)%hi, terms))]
      call page%row(row(:last))
      call page%end()
      call finish()
   end subroutine perimeter_command


   !> 2 pi a (1 - c_0^2/2 - s)/M(1, b/a), c_0^2 = 1 - b^2/a^2, s of the arithmetic-geometric mean M; a the
   !> larger semiaxis (DLMF 19.9.9, 19.8.6)
   pure function perimeter(axes) result(length)
      type(words), intent(in) :: axes(2)
      type(words) :: length
      type(words) :: b, mean, s
      integer :: larger

      larger = maxloc(axes%hi, 1)
      length = axes(larger)
      if (.not. length%hi > 0.0_wp) return
      b = axes(3 - larger)/length
      length = 2.0_wp*length
      if (.not. b%hi > tiny(1.0_wp)) then
         length = 2.0_wp*length
      else
         call mean_with_one(b, mean, s)
         length = length*pi_words*(1.0_wp - (1.0_wp - b)*(1.0_wp + b)/2.0_wp - s)/mean
      end if
   end function perimeter


   !> The two semiaxes
   function axes_of(line) result(axes)
      type(command_line), intent(in) :: line
      type(words) :: axes(2)
      integer :: i

      if (size(line%operands) < 2) call line%reject('name two semiaxes, as ' // line%name // ' 2 1')
      do i = 1, 2
         axes(i) = number_of(line%operands(i), metres)
         call demand(axes(i)%hi >= 0.0_wp, line%operands(i), 'semiaxis >= 0')
      end do
      i = maxloc(axes%hi, 1)
      call demand(axes(i)%hi >= 1.0e-290_wp .and. axes(i)%hi <= 1.0e307_wp .or. .not. axes(i)%hi > 0.0_wp, &
         line%operands(i), '1e-290 <= larger semiaxis <= 1e307')
   end function axes_of


   function arc_usage() result(usage)
      type(command) :: usage

      usage = command('arc', 'of an ellipse between two angles, and points at equal steps of it', 'A B', 2, &
         'The length of the arc of the ellipse x = A cos t, y = B sin t between two angles t, in the ' // &
         'unit of A and B (metres if they have one).', &
         'Angles are in degrees, or as 1rad. Where --from and --to are whole turns apart, the last of N ' // &
         'points is a step before the first; else it is at --to.', &
         'furiko arc 2 1 --from 0 --to 90 --equal 4', options=[ &
         option('--from', 'T', '0', 'the first angle'), &
         option('--to', 'T', '360', 'the last angle'), &
         option('--polar', about='the angles are those that one sees from the centre, tan = y/x'), &
         option('--equal', 'N', '', 'N points at equal steps of arc, a row for each: t, x, y, arc'), &
         format_option], run=arc_command)
   end function arc_usage


   subroutine arc_command(line)
      type(command_line), intent(in) :: line
      type(sheet) :: page
      type(words) :: given(2), from, to
      real(wp) :: axes(2), s(2)
      integer :: right_digits

      given = axes_of(line)
      axes = given%hi
      call demand(minval(axes) > 1.0e-140_wp*maxval(axes), line%operands(minloc(axes, 1)), &
         'semiaxis > 1e-140 of the other')
      from = parameter_of(line, '--from', axes)
      to = parameter_of(line, '--to', axes)
      s = [arc(axes, from), arc(axes, to)]
      ! what the difference of two arcs leaves of 15 digits
      right_digits = 12
      if (abs(s(2) - s(1)) > 0.0_wp) right_digits = max(1, min(12, &
         14 - int(log10(sum(abs(s))/abs(s(2) - s(1))))))
      if (line%given('--equal')) then
         call put_points(line, axes, from, to, s, right_digits)
         return
      end if
      page = begin_sheet(line, [column('from_deg', digits, 12), column('to_deg', digits, 12), &
         column('arc', digits, right_digits)])
      call page%row([in_degrees(from), in_degrees(to), words(s(2) - s(1))])
      call page%end()
      call finish()
   end subroutine arc_command


   !> N points from an angle on, at equal steps of arc
   subroutine put_points(line, axes, from, to, s, right_digits)
      type(command_line), intent(in) :: line
      real(wp), intent(in) :: axes(2)
      type(words), intent(in) :: from
      type(words), intent(in) :: to
      !> The arcs up to there
      real(wp), intent(in) :: s(2)
      integer, intent(in) :: right_digits
      real(wp), parameter :: turn = 2*acos(-1.0_wp)
      type(sheet) :: page
      real(wp) :: step, t, turns
      integer :: count, i, points, style

      points = whole_of(line%value('--equal'), 1, 100000000)
      turns = ((to%hi - from%hi) + (to%lo - from%lo))/turn
      step = (s(2) - s(1))/points
      if (abs(turns - anint(turns)) > 4*epsilon(1.0_wp)*max(1.0_wp, &
         abs(to%hi))) step = (s(2) - s(1))/max(1, points - 1)
      ! what is right of a coordinate is so to the larger semiaxis
      count = 11 - nint(log10(maxval(axes)))
      style = merge(places, digits, count >= 3 .and. count <= 14)
      if (style == digits) count = 11
      page = begin_sheet(line, [column('point', whole, width=9), column('t_deg', places, 10), &
         column('x', style, count, width=18), column('y', style, count, width=18), &
         column('arc', digits, right_digits)], rows=int(points, int64))
      do i = 0, points - 1
         t = ellipeinc_inverse_mc((s(1) + i*step)/axes(2), (axes(1)/axes(2))**2)
         if (i == 0) t = from%hi
         call page%row([words(real(i + 1, wp)), in_degrees(words(t)), &
            words(axes(1)*cos(t)), words(axes(2)*sin(t)), words(i*step)])
      end do
      call page%end()
      call finish()
   end subroutine put_points


   !> The parameter t at an angle; the angle from the centre differs by less than a quarter turn.
   function parameter_of(line, name, axes) result(t)
      type(command_line), intent(in) :: line
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: axes(2)
      type(words) :: t
      real(wp) :: sine, cosine

      t = angle_of(line%value(name))
      call demand(abs(t%hi) <= 1.0e6_wp, line%value(name), '-1e6 <= angle <= 1e6 rad')
      if (.not. line%given('--polar')) return
      sine = sin(t%hi)
      cosine = cos(t%hi)
      t = t + atan2((axes(1) - axes(2))*sine*cosine, axes(1)*sine**2 + axes(2)*cosine**2)
   end function parameter_of


   !> The arc of a cos t, b sin t from 0 to t: b E(t, 1 - a^2/b^2); its last digit by the derivative
   pure function arc(axes, t) result(s)
      real(wp), intent(in) :: axes(2)
      type(words), intent(in) :: t
      real(wp) :: s

      s = axes(2)*ellipeinc_mc(t%hi, (axes(1)/axes(2))**2) + &
         hypot(axes(1)*sin(t%hi), axes(2)*cos(t%hi))*t%lo
   end function arc

end module furiko_cli_ellipse
