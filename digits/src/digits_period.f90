! SPDX-License-Identifier: MIT

!> K, and the period of a pendulum, to any number of digits, by the arithmetic-geometric mean.
module digits_period
   use, intrinsic :: iso_c_binding, only : c_char, c_f_pointer, c_int, c_long, c_null_char, &
      c_null_ptr, c_ptr, c_size_t
   use digits_mpfr, only : mpfr_add, mpfr_agm, mpfr_clear, mpfr_cmp_si, mpfr_const_pi, mpfr_div, &
      mpfr_free_str, mpfr_get_str, mpfr_init2, mpfr_mul, mpfr_set_si, mpfr_set_str, mpfr_sin, &
      mpfr_sqrt, mpfr_sub, mpfr_t, to_nearest
   implicit none
   private
   public :: period_digits, outside


   !> What `period_digits` returns where the function is not finite and real, or the word no number
   character(len=*), parameter :: outside = ''


contains


   !> K, correctly rounded to `count` digits: $$ K = \pi / (2 M(1, k')), $$ or for an amplitude in
   !> degrees T/T_h = 1/M(1, k'), k' = cos(A/2). Source: DLMF 19.8.5
   !>
   !> Computed at two precisions until they agree, as a decimal k next to 1 needs more of them.
   function period_digits(form, word, count) result(text)
      !> k, m, mc or amplitude
      character(len=*), intent(in) :: form
      !> Its value: a decimal number or a fraction of two
      character(len=*), intent(in) :: word
      integer, intent(in) :: count
      character(len=:), allocatable :: text
      character(len=:), allocatable :: before
      integer(c_long) :: bits

      ! 64/19 is above log2(10); the distance of k from 1 has at most as many digits as the word
      bits = (int(count + len(word), c_long)*64)/19 + 64
      text = evaluate(form, word, count, bits)
      do
         before = text
         bits = 2*bits
         text = evaluate(form, word, count, bits)
         if (text == before .or. text == outside) exit
      end do
   end function period_digits


   function evaluate(form, word, count, bits) result(text)
      character(len=*), intent(in) :: form
      character(len=*), intent(in) :: word
      integer, intent(in) :: count
      integer(c_long), intent(in) :: bits
      character(len=:), allocatable :: text
      type(mpfr_t) :: x, y, one
      logical :: valid
      integer(c_int) :: stat

      call mpfr_init2(x, bits)
      call mpfr_init2(y, bits)
      call mpfr_init2(one, bits)
      stat = mpfr_set_si(one, 1_c_long, to_nearest)
      text = outside
      call read_number(word, x, y, valid)
      if (valid) call complement(form, x, y, valid)
      if (valid) then
         ! x = k'
         stat = mpfr_agm(y, one, x, to_nearest)
         if (form == 'amplitude') then
            stat = mpfr_div(x, one, y, to_nearest)
         else
            stat = mpfr_add(y, y, y, to_nearest)
            stat = mpfr_const_pi(x, to_nearest)
            stat = mpfr_div(x, x, y, to_nearest)
         end if
         text = to_text(x, count)
      end if
      call mpfr_clear(x)
      call mpfr_clear(y)
      call mpfr_clear(one)
   end function evaluate


   !> x <- the number that the word means; y is scratch.
   subroutine read_number(word, x, y, valid)
      character(len=*), intent(in) :: word
      type(mpfr_t), intent(inout) :: x
      type(mpfr_t), intent(inout) :: y
      logical, intent(out) :: valid
      integer :: slash
      integer(c_int) :: stat

      slash = index(word // '/', '/')
      valid = len(word) > 0 .and. verify(word, '+-.0123456789eE/') == 0
      if (valid) valid = mpfr_set_str(x, word(:slash - 1) // c_null_char, 10_c_int, to_nearest) == 0
      if (.not. valid .or. slash > len(word)) return
      valid = mpfr_set_str(y, word(slash + 1:) // c_null_char, 10_c_int, to_nearest) == 0
      if (valid) valid = mpfr_cmp_si(y, 0_c_long) /= 0
      if (valid) stat = mpfr_div(x, x, y, to_nearest)
   end subroutine read_number


   !> x <- k' of the modulus, parameter or amplitude x; y is scratch. Valid within the domain.
   subroutine complement(form, x, y, valid)
      character(len=*), intent(in) :: form
      type(mpfr_t), intent(inout) :: x
      type(mpfr_t), intent(inout) :: y
      logical, intent(out) :: valid
      integer(c_int) :: stat

      valid = .true.
      select case (form)
      case ('amplitude')
         ! cos(A/2) = sin((180 - A) pi/360), 0 <= A < 180
         valid = mpfr_cmp_si(x, 0_c_long) >= 0 .and. mpfr_cmp_si(x, 180_c_long) < 0
         stat = mpfr_set_si(y, 180_c_long, to_nearest)
         stat = mpfr_sub(x, y, x, to_nearest)
         stat = mpfr_const_pi(y, to_nearest)
         stat = mpfr_mul(x, x, y, to_nearest)
         stat = mpfr_set_si(y, 360_c_long, to_nearest)
         stat = mpfr_div(x, x, y, to_nearest)
         stat = mpfr_sin(x, x, to_nearest)
         return
      case ('k')
         ! 1 - k^2, exact at the second precision
         stat = mpfr_mul(x, x, x, to_nearest)
         stat = mpfr_set_si(y, 1_c_long, to_nearest)
         stat = mpfr_sub(x, y, x, to_nearest)
      case ('m')
         stat = mpfr_set_si(y, 1_c_long, to_nearest)
         stat = mpfr_sub(x, y, x, to_nearest)
      case default
         ! mc it is
      end select
      valid = mpfr_cmp_si(x, 0_c_long) > 0
      stat = mpfr_sqrt(x, x, to_nearest)
   end subroutine complement


   !> `count` digits of x > 0 in fixed notation, or with an exponent where that would be too long.
   function to_text(x, count) result(text)
      type(mpfr_t), intent(in) :: x
      integer, intent(in) :: count
      character(len=:), allocatable :: text
      character(kind=c_char), pointer :: figures(:)
      character(len=24) :: power
      integer(c_long) :: point
      type(c_ptr) :: place
      integer :: i

      place = mpfr_get_str(c_null_ptr, point, 10_c_int, int(count, c_size_t), x, to_nearest)
      call c_f_pointer(place, figures, [count])
      allocate(character(len=count) :: text)
      do i = 1, count
         text(i:i) = figures(i)
      end do
      call mpfr_free_str(place)
      if (point >= 1 .and. point < count) then
         text = text(:point) // '.' // text(point + 1:)
      else if (point <= 0 .and. point > -6) then
         text = '0.' // repeat('0', int(-point)) // text
      else if (point /= count) then
         write(power, '(i0)') point - 1
         text = text(1:1) // '.' // text(2:) // 'e' // trim(power)
      end if
   end function to_text

end module digits_period
