! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

!> Rows of numbers in, rows of results out, in each kind of real; the text is in furiko_cli_rows.inc.
module furiko_cli_rows_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use furiko_by_name_sp, only : evaluate
   use furiko_cli_answers, only : answers
   use furiko_cli_fields, only : field, is_skipped, split
   use furiko_cli_header, only : read_header
   use furiko_cli_input, only : line_input, longest_line
   use furiko_cli_io, only : refuse
   use furiko_cli_number, only : is_out_of_range, is_right, longest, read_number, write_shortest
   use furiko_cli_request, only : begin_output, request
   use furiko_cli_text, only : whole_text
   implicit none
   private
   character(len=*), parameter :: kind_name = 'real32'
   include 'furiko_cli_rows.inc'
end module furiko_cli_rows_sp


module furiko_cli_rows_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko_by_name_dp, only : evaluate
   use furiko_cli_answers, only : answers
   use furiko_cli_fields, only : field, is_skipped, split
   use furiko_cli_header, only : read_header
   use furiko_cli_input, only : line_input, longest_line
   use furiko_cli_io, only : refuse
   use furiko_cli_number, only : is_out_of_range, is_right, longest, read_number, write_shortest
   use furiko_cli_request, only : begin_output, request
   use furiko_cli_text, only : whole_text
   implicit none
   private
   character(len=*), parameter :: kind_name = 'real64'
   include 'furiko_cli_rows.inc'
end module furiko_cli_rows_dp


#ifdef FURIKO_REAL128
module furiko_cli_rows_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use furiko_by_name_qp, only : evaluate
   use furiko_cli_answers, only : answers
   use furiko_cli_fields, only : field, is_skipped, split
   use furiko_cli_header, only : read_header
   use furiko_cli_input, only : line_input, longest_line
   use furiko_cli_io, only : refuse
   use furiko_cli_number, only : is_out_of_range, is_right, longest, read_number, write_shortest
   use furiko_cli_request, only : begin_output, request
   use furiko_cli_text, only : whole_text
   implicit none
   private
   character(len=*), parameter :: kind_name = 'real128'
   include 'furiko_cli_rows.inc'
end module furiko_cli_rows_qp
#endif


!> The kind by its name.
module furiko_cli_rows
   use, intrinsic :: iso_fortran_env, only : real32, real64, real128
   use furiko_cli_rows_sp, only : answer => evaluate_rows
   use furiko_cli_rows_dp, only : answer => evaluate_rows
#ifdef FURIKO_REAL128
   use furiko_cli_rows_qp, only : answer => evaluate_rows
#endif
   use furiko_cli_io, only : refuse
   use furiko_cli_request, only : request
   implicit none
   private
   public :: evaluate_rows


contains


   !> Answer every row of standard input as requested, in a kind of real.
   subroutine evaluate_rows(wanted, kind_name)
      type(request), intent(in) :: wanted
      character(len=*), intent(in) :: kind_name

      select case (kind_name)
      case ('real32')
         call answer(wanted, 0.0_real32)
      case ('real64')
         call answer(wanted, 0.0_real64)
      case default
#ifdef FURIKO_REAL128
         call answer(wanted, 0.0_real128)
#else
         call refuse('furiko eval: this compiler has no real128')
#endif
      end select
   end subroutine evaluate_rows

end module furiko_cli_rows
! rooms: 3943898739
