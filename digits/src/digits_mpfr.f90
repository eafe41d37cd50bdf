! SPDX-License-Identifier: MIT

!> The part of MPFR (https://www.mpfr.org) that the program needs, under MPFR's names.
module digits_mpfr
   use, intrinsic :: iso_c_binding, only : c_char, c_int, c_long, c_ptr, c_size_t
   implicit none
   private
   public :: mpfr_t, to_nearest
   public :: mpfr_init2, mpfr_clear, mpfr_set_str, mpfr_set_si, mpfr_const_pi
   public :: mpfr_add, mpfr_sub, mpfr_mul, mpfr_div, mpfr_agm, mpfr_sqrt, mpfr_sin
   public :: mpfr_cmp_si, mpfr_get_str, mpfr_free_str


   !> MPFR's struct, whose members are its own
   type, bind(c) :: mpfr_t
      private
      integer(c_long) :: precision
      integer(c_int) :: sign
      integer(c_long) :: exponent
      type(c_ptr) :: limbs
   end type mpfr_t

   integer(c_int), parameter :: to_nearest = 0


   abstract interface
      function constant(x, rounding) result(stat) bind(c)
         import :: c_int, mpfr_t
         implicit none
         type(mpfr_t), intent(inout) :: x
         integer(c_int), value :: rounding
         integer(c_int) :: stat
      end function constant

      function unary(x, y, rounding) result(stat) bind(c)
         import :: c_int, mpfr_t
         implicit none
         type(mpfr_t), intent(inout) :: x
         type(mpfr_t), intent(in) :: y
         integer(c_int), value :: rounding
         integer(c_int) :: stat
      end function unary

      function binary(x, y, z, rounding) result(stat) bind(c)
         import :: c_int, mpfr_t
         implicit none
         type(mpfr_t), intent(inout) :: x
         type(mpfr_t), intent(in) :: y
         type(mpfr_t), intent(in) :: z
         integer(c_int), value :: rounding
         integer(c_int) :: stat
      end function binary
   end interface

   procedure(constant), bind(c, name='mpfr_const_pi') :: mpfr_const_pi
   procedure(unary), bind(c, name='mpfr_sqrt') :: mpfr_sqrt
   procedure(unary), bind(c, name='mpfr_sin') :: mpfr_sin
   procedure(binary), bind(c, name='mpfr_add') :: mpfr_add
   procedure(binary), bind(c, name='mpfr_sub') :: mpfr_sub
   procedure(binary), bind(c, name='mpfr_mul') :: mpfr_mul
   procedure(binary), bind(c, name='mpfr_div') :: mpfr_div
   procedure(binary), bind(c, name='mpfr_agm') :: mpfr_agm

   interface
      subroutine mpfr_init2(x, bits) bind(c)
         import :: c_long, mpfr_t
         implicit none
         type(mpfr_t), intent(out) :: x
         integer(c_long), value :: bits
      end subroutine mpfr_init2

      subroutine mpfr_clear(x) bind(c)
         import :: mpfr_t
         implicit none
         type(mpfr_t), intent(inout) :: x
      end subroutine mpfr_clear

      function mpfr_set_str(x, text, base, rounding) result(stat) bind(c)
         import :: c_char, c_int, mpfr_t
         implicit none
         type(mpfr_t), intent(inout) :: x
         character(kind=c_char), intent(in) :: text(*)
         integer(c_int), value :: base
         integer(c_int), value :: rounding
         integer(c_int) :: stat
      end function mpfr_set_str

      function mpfr_set_si(x, n, rounding) result(stat) bind(c)
         import :: c_int, c_long, mpfr_t
         implicit none
         type(mpfr_t), intent(inout) :: x
         integer(c_long), value :: n
         integer(c_int), value :: rounding
         integer(c_int) :: stat
      end function mpfr_set_si

      function mpfr_cmp_si(x, n) result(order) bind(c)
         import :: c_int, c_long, mpfr_t
         implicit none
         type(mpfr_t), intent(in) :: x
         integer(c_long), value :: n
         integer(c_int) :: order
      end function mpfr_cmp_si

      function mpfr_get_str(text, exponent, base, digits, x, rounding) result(place) bind(c)
         import :: c_int, c_long, c_ptr, c_size_t, mpfr_t
         implicit none
         type(c_ptr), value :: text
         integer(c_long), intent(out) :: exponent
         integer(c_int), value :: base
         integer(c_size_t), value :: digits
         type(mpfr_t), intent(in) :: x
         integer(c_int), value :: rounding
         type(c_ptr) :: place
      end function mpfr_get_str

      subroutine mpfr_free_str(text) bind(c)
         import :: c_ptr
         implicit none
         type(c_ptr), value :: text
      end subroutine mpfr_free_str
   end interface

end module digits_mpfr
