! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

!> Rows of numbers in, rows of results out, in each kind of real; the text is in furiko_cli_rows.inc.
module furiko_cli_rows_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan
   use furiko_by_name_sp, only : evaluate
   use furiko_catalogue, only : argument_count, catalogue_entry, result_count
   use furiko_cli_number, only : is_number
   use furiko_cli_terminal, only : put, refuse
   use furiko_cli_words, only : first_word, next_row
   implicit none
   private
   character(len=*), parameter :: round_trip = '(es20.8e2)'
   include 'furiko_cli_rows.inc'
end module furiko_cli_rows_sp


module furiko_cli_rows_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan
   use furiko_by_name_dp, only : evaluate
   use furiko_catalogue, only : argument_count, catalogue_entry, result_count
   use furiko_cli_number, only : is_number
   use furiko_cli_terminal, only : put, refuse
   use furiko_cli_words, only : first_word, next_row
   implicit none
   private
   character(len=*), parameter :: round_trip = '(es30.16e3)'
   include 'furiko_cli_rows.inc'
end module furiko_cli_rows_dp


#ifdef FURIKO_REAL128
module furiko_cli_rows_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use, intrinsic :: ieee_arithmetic, only : ieee_is_nan
   use furiko_by_name_qp, only : evaluate
   use furiko_catalogue, only : argument_count, catalogue_entry, result_count
   use furiko_cli_number, only : is_number
   use furiko_cli_terminal, only : put, refuse
   use furiko_cli_words, only : first_word, next_row
   implicit none
   private
   character(len=*), parameter :: round_trip = '(es50.35e4)'
   include 'furiko_cli_rows.inc'
end module furiko_cli_rows_qp
#endif


!> The kind by its name.
module furiko_cli_rows
   use, intrinsic :: iso_fortran_env, only : real32, real64, real128
   use furiko_catalogue, only : catalogue_entry
   use furiko_cli_rows_sp, only : answer => evaluate_rows
   use furiko_cli_rows_dp, only : answer => evaluate_rows
#ifdef FURIKO_REAL128
   use furiko_cli_rows_qp, only : answer => evaluate_rows
#endif
   use furiko_cli_terminal, only : refuse
   implicit none
   private
   public :: evaluate_rows


contains


   !> Answer every row of standard input with the function of an entry, in a kind of real.
   subroutine evaluate_rows(entry, kind_name)
      type(catalogue_entry), intent(in) :: entry
      character(len=*), intent(in) :: kind_name

      select case (kind_name)
      case ('real32')
         call answer(entry, 0.0_real32)
      case ('real64')
         call answer(entry, 0.0_real64)
      case default
#ifdef FURIKO_REAL128
         call answer(entry, 0.0_real128)
#else
         call refuse('furiko eval: this compiler has no real128')
#endif
      end select
   end subroutine evaluate_rows

end module furiko_cli_rows
! rooms: 341569128
