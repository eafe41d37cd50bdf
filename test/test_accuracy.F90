! SPDX-License-Identifier: MIT
#include "../src/arithmetic/furiko_compiler.inc"

module test_accuracy_sp
   use, intrinsic :: iso_fortran_env, only : wp => real32
   use, intrinsic :: ieee_exceptions, only : ieee_get_halting_mode, ieee_overflow, ieee_set_flag, &
      ieee_set_halting_mode
   use test_by_name_sp, only : value_at, values_at, yardstick
   use test_measurement, only : add_points, measurement, name_length, unpack
   use test_program, only : test_folder
   use test_ulp, only : ulps
   implicit none
   private
   include 'test_accuracy.inc'
end module test_accuracy_sp


module test_accuracy_dp
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use, intrinsic :: ieee_exceptions, only : ieee_get_halting_mode, ieee_overflow, ieee_set_flag, &
      ieee_set_halting_mode
   use test_by_name_dp, only : value_at, values_at, yardstick
   use test_measurement, only : add_points, measurement, name_length, unpack
   use test_program, only : test_folder
   use test_ulp, only : ulps
   implicit none
   private
   include 'test_accuracy.inc'
end module test_accuracy_dp


#ifdef FURIKO_REAL128
module test_accuracy_qp
   use, intrinsic :: iso_fortran_env, only : wp => real128
   use, intrinsic :: ieee_exceptions, only : ieee_get_halting_mode, ieee_overflow, ieee_set_flag, &
      ieee_set_halting_mode
   use test_by_name_qp, only : value_at, values_at, yardstick
   use test_measurement, only : add_points, measurement, name_length, unpack
   use test_program, only : test_folder
   use test_ulp, only : ulps
   implicit none
   private
   include 'test_accuracy.inc'
end module test_accuracy_qp
#endif


!> The accuracy report, and the suite that holds it against the promises of the docstrings.
module test_accuracy
   use, intrinsic :: iso_fortran_env, only : real32, real64, real128
   use test_accuracy_sp, only : measure
   use test_accuracy_dp, only : measure
#ifdef FURIKO_REAL128
   use test_accuracy_qp, only : measure
#endif
   use test_measurement, only : measurement, name_length
   use testdrive, only : check, error_type, new_unittest, unittest_type
   implicit none
   private
   public :: collect_accuracy, write_report


   character(len=*), parameter :: nl = new_line('a')

   character(len=*), parameter :: kind_names(3) = ['real32 ', 'real64 ', 'real128']

   character(len=*), parameter :: files(*) = [character(len=24) :: 'complete', 'incomplete', &
      'incomplete_inverse', 'third_kind', 'third_kind_incomplete', 'ellips', 'ellipj', &
      'ellipj_incomplete', 'cel', 'carlson', 'period', 'nome', 'theta', 'jacobi', 'jacobi_edges', &
      'jacobi_quotients', 'jacobi_inverse', 'jacobi_inverse_quotients', &
      'jacobi_zeta', 'heuman_lambda', 'parameter', 'excess', 'amplitude', 'agm', 'classics', 'agm_steps', &
      'jacobi_complex', 'motion', 'motion_tension', 'motion_phase', 'motion_time', 'motion_slack']


   !> A bound in what the family is measured in, per kind, for all of its forms; in one regime, or in
   !> all. Arrays may have bounds of their own.
   type :: promise
      character(len=name_length) :: family
      character(len=16) :: regime
      real :: bounds(3)
      real :: array_bounds(3) = -1.0
   end type promise

   !> What the docstrings promise. The later line counts.
   real, parameter :: none = 1.0e6
   type(promise), parameter :: promises(*) = [ &
      promise('ellipk', '', [0.5, 0.55, 4.0]), &
      promise('ellipe', '', [0.5, 0.55, 4.0]), &
      promise('ellipb', '', [0.5, 0.6, 4.0]), &
      promise('ellipd', '', [0.5, 0.6, 4.0]), &
      promise('ellippi', '', [4.0, 4.0, 4.0]), &
      promise('ellipf', '', [3.0, 3.0, 4.0]), &
      promise('ellipeinc', '', [3.0, 3.0, 4.0]), &
      promise('ellipeinc_inverse', '', [0.7, 0.7, 0.7]), &
      promise('ellipdinc', '', [3.0, 3.0, 4.0]), &
      promise('ellippiinc', '', [4.0, 4.0, 4.0]), &
      promise('ellips', '', [1.75, 1.75, 4.0]), &
      promise('ellipj', '', [4.0, 4.0, 4.0]), &
      promise('bulirsch_cel', '', [1.0, 1.0, 1.0]), &
      promise('carlson', '', [3.0, 3.0, 3.0]), &
      promise('carlson_rj', '', [4.0, 4.0, 4.0]), &
      promise('period', '', [0.6, 0.6, 4.0]), &
      promise('period_excess', '', [0.6, 0.6, 5.0]), &
      promise('amplitude_of_excess', '', [2.0, 2.0, 2.0]), &
      promise('amplitude_of_period', '', [2.0, 2.0, 2.0]), &
      promise('nome', '', [1.0, 1.0, 1.0]), &
      promise('theta', '', [1.0, 1.0, 1.0]), &
      promise('jacobi', '', [6.0, 6.0, 6.0]), &
      promise('jacobi_epsilon', 'above-1', [5.0, 5.0, 5.0]), &
      promise('jacobi_arc', '', [1.0, 1.0, 5.0]), &
      promise('jacobi_zeta', '', [1.0, 1.0, 1.0]), &
      promise('heuman_lambda', '', [1.0, 1.0, 1.0]), &
      promise('parameter', '', [1.0, 1.0, 1.0]), &
      promise('complementary', '', [1.0, 1.0, 1.0]), &
      promise('agm', '', [1.0, 1.0, 1.0]), &
      promise('agm_steps', '', [1.0, 1.0, 1.0]), &
      promise('ellipk_series', '', [1.0, 1.0, 1.0]), &
      promise('ellipe_series', '', [1.0, 1.0, 1.0]), &
      promise('period_ratio_series', '', [1.0, 1.0, 1.0]), &
      promise('amplitude_three_terms', '', [3.0, 3.0, 3.0]), &
      promise('ellipk_trapezoid', '', [3.0, 3.0, 3.0]), &
      promise('ellipe_trapezoid', '', [3.0, 3.0, 3.0]), &
      promise('ellipse_perimeter', '', [0.51, 0.51, 0.51]), &
      promise('ellipse_perimeter_series', '', [4.0, 4.0, 4.0]), &
      promise('modulus', '', [1.0, 1.0, 4.0]), &
      promise('complex', '', [8.0, 8.0, 8.0]), &
      promise('motion_angle', '', [4.0, 4.0, 4.0]), &
      promise('motion_rate', '', [4.0, 4.0, 4.0]), &
      promise('motion_tension', '', [16.0, 16.0, 16.0]), &
      promise('motion_phase', '', [2.0, 2.0, 2.0]), &
      promise('motion_time_to', '', [2.0, 2.0, 2.0]), &
      promise('motion_slack', '', [2.0, 2.0, 2.0])]


contains


   subroutine collect_accuracy(testsuite)
      type(unittest_type), allocatable, intent(out) :: testsuite(:)

      testsuite = [ &
         new_unittest('complete', test_complete), &
         new_unittest('incomplete', test_incomplete), &
         new_unittest('incomplete-inverse', test_incomplete_inverse), &
         new_unittest('third-kind', test_third_kind), &
         new_unittest('third-kind-incomplete', test_third_kind_incomplete), &
         new_unittest('ellips', test_ellips), &
         new_unittest('ellipj', test_ellipj), &
         new_unittest('ellipj-incomplete', test_ellipj_incomplete), &
         new_unittest('cel', test_cel), &
         new_unittest('carlson', test_carlson), &
         new_unittest('period', test_period), &
         new_unittest('period-excess', test_excess), &
         new_unittest('amplitude', test_amplitude), &
         new_unittest('nome', test_nome), &
         new_unittest('theta', test_theta), &
         new_unittest('jacobi', test_jacobi), &
         new_unittest('jacobi-edges', test_jacobi_edges), &
         new_unittest('jacobi-quotients', test_jacobi_quotients), &
         new_unittest('jacobi-inverse', test_jacobi_inverse), &
         new_unittest('jacobi-inverse-quotients', test_jacobi_inverse_quotients), &
         new_unittest('jacobi-zeta', test_jacobi_zeta), &
         new_unittest('heuman-lambda', test_heuman_lambda), &
         new_unittest('parameter', test_parameter), &
         new_unittest('agm', test_agm), &
         new_unittest('classics', test_classics), &
         new_unittest('agm-steps', test_agm_steps), &
         new_unittest('jacobi-complex', test_jacobi_complex), &
         new_unittest('motion', test_motion), &
         new_unittest('motion-tension', test_motion_tension), &
         new_unittest('motion-phase', test_motion_phase), &
         new_unittest('motion-time', test_motion_time), &
         new_unittest('motion-slack', test_motion_slack)]
   end subroutine collect_accuracy


   subroutine test_complete(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'complete')
   end subroutine test_complete


   subroutine test_incomplete(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'incomplete')
   end subroutine test_incomplete


   subroutine test_incomplete_inverse(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'incomplete_inverse')
   end subroutine test_incomplete_inverse


   subroutine test_third_kind(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'third_kind')
   end subroutine test_third_kind


   subroutine test_third_kind_incomplete(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'third_kind_incomplete')
   end subroutine test_third_kind_incomplete


   subroutine test_ellips(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'ellips')
   end subroutine test_ellips


   subroutine test_ellipj(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'ellipj')
   end subroutine test_ellipj


   subroutine test_ellipj_incomplete(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'ellipj_incomplete')
   end subroutine test_ellipj_incomplete


   subroutine test_cel(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'cel')
   end subroutine test_cel


   subroutine test_carlson(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'carlson')
   end subroutine test_carlson


   subroutine test_period(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'period')
   end subroutine test_period


   subroutine test_excess(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'excess')
   end subroutine test_excess


   subroutine test_amplitude(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'amplitude')
   end subroutine test_amplitude


   subroutine test_nome(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'nome')
   end subroutine test_nome


   subroutine test_theta(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'theta')
   end subroutine test_theta


   subroutine test_jacobi(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'jacobi')
   end subroutine test_jacobi


   subroutine test_jacobi_edges(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'jacobi_edges')
   end subroutine test_jacobi_edges


   subroutine test_jacobi_quotients(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'jacobi_quotients')
   end subroutine test_jacobi_quotients


   subroutine test_jacobi_inverse(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'jacobi_inverse')
   end subroutine test_jacobi_inverse


   subroutine test_jacobi_inverse_quotients(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'jacobi_inverse_quotients')
   end subroutine test_jacobi_inverse_quotients


   subroutine test_jacobi_zeta(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'jacobi_zeta')
   end subroutine test_jacobi_zeta


   subroutine test_heuman_lambda(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'heuman_lambda')
   end subroutine test_heuman_lambda


   subroutine test_parameter(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'parameter')
   end subroutine test_parameter


   subroutine test_agm(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'agm')
   end subroutine test_agm


   subroutine test_classics(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'classics')
   end subroutine test_classics


   subroutine test_agm_steps(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'agm_steps')
   end subroutine test_agm_steps


   subroutine test_jacobi_complex(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'jacobi_complex')
   end subroutine test_jacobi_complex


   subroutine test_motion(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'motion')
   end subroutine test_motion


   subroutine test_motion_tension(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'motion_tension')
   end subroutine test_motion_tension


   subroutine test_motion_phase(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'motion_phase')
   end subroutine test_motion_phase


   subroutine test_motion_time(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'motion_time')
   end subroutine test_motion_time


   subroutine test_motion_slack(error)
      type(error_type), allocatable, intent(out) :: error

      call check_file(error, 'motion_slack')
   end subroutine test_motion_slack


   !> No point of the file beyond its promise, in any kind
   subroutine check_file(error, file)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: file
      type(measurement), allocatable :: list(:)
      character(len=400) :: message
      integer :: i, kind, line

      do kind = 1, size(kind_names)
         allocate(list(0))
         call measure_kind(file, kind, list)
         do i = 1, size(list)
            write(message, '(*(a))') trim(kind_names(kind)), ' ', trim(list(i)%name), ', ', &
               trim(list(i)%regime), ': ', decimals(list(i)%largest), ' at ', &
               trim(list(i)%worst), ', ', decimals(list(i)%largest_of_array), ' in an array'
            line = promise_line(list(i))
            call check(error, list(i)%largest <= promises(line)%bounds(kind) .and. &
               list(i)%largest_of_array <= array_bound(promises(line), kind), trim(message))
            if (allocated(error)) return
         end do
         deallocate(list)
      end do
   end subroutine check_file


   !> Measure a file in a kind by its number; nothing where the compiler does not have it.
   subroutine measure_kind(file, kind, list)
      character(len=*), intent(in) :: file
      integer, intent(in) :: kind
      type(measurement), allocatable, intent(inout) :: list(:)

      select case (kind)
      case (1)
         call measure(file, 0.0_real32, list)
      case (2)
         call measure(file, 0.0_real64, list)
      case default
#ifdef FURIKO_REAL128
         call measure(file, 0.0_real128, list)
#endif
      end select
   end subroutine measure_kind


   !> The line of `promises` for a function, whose name begins with its family's
   pure function promise_line(what) result(line)
      type(measurement), intent(in) :: what
      integer :: line

      do line = size(promises), 1, -1
         if (index(what%name, trim(promises(line)%family)) /= 1) cycle
         if (promises(line)%regime == '' .or. promises(line)%regime == what%regime) return
      end do
   end function promise_line


   !> What is promised of arrays: what is promised of scalars where nothing else is said
   pure real function array_bound(line, kind)
      type(promise), intent(in) :: line
      integer, intent(in) :: kind

      array_bound = line%array_bounds(kind)
      if (array_bound < 0.0) array_bound = line%bounds(kind)
   end function array_bound


   !> doc/accuracy.md: a line for each family, then all regimes of each function
   subroutine write_report(path)
      character(len=*), intent(in) :: path
      type(measurement), allocatable :: list(:)
      real, dimension(size(promises), size(kind_names)) :: largest, largest_of_array
      character(len=:), allocatable :: details
      integer :: file, i, kind, unit

      largest = 0.0
      largest_of_array = 0.0
      details = ''
      do kind = 1, size(kind_names)
         details = details // nl // '## ' // trim(kind_names(kind)) // nl // nl // &
            '| function | regime | points | largest | mean | in arrays | promised | largest at |' // &
            nl // '|---|---|---|---|---|---|---|---|' // nl
         do file = 1, size(files)
            allocate(list(0))
            call measure_kind(trim(files(file)), kind, list)
            do i = 1, size(list)
               associate (line => promise_line(list(i)))
                  largest(line, kind) = max(largest(line, kind), list(i)%largest)
                  largest_of_array(line, kind) = max(largest_of_array(line, kind), &
                     list(i)%largest_of_array)
               end associate
               details = details // row(list(i), kind) // nl
            end do
            deallocate(list)
         end do
      end do

      open(newunit=unit, file=path, status='replace', action='write')
      write(unit, '(a)') '# Accuracy', '', &
         'Errors in units in the last place of the exact value (0.5 is correct rounding), against the', &
         '40-digit references in test/data. Written by `./fpmw test -- report doc/accuracy.md`.', '', &
         'Other families are counted in epsilon or otherwise:', '', &
         '- `ellipeinc_inverse`, the angle of an arc s: in what half an ulp of s is in the angle, where', &
         '  that is more than an ulp of it;', &
         '- `complex_sn_re` and so on, real and imaginary part of a Jacobi function of complex u: of the', &
         '  absolute value of the function;', &
         '- `motion_angle`: of a radian, of the amplitude where that is less, of a quarter of the angle', &
         '  where turns have piled up;', &
         '- `motion_rate`: of the largest rate, were it at the bottom; `motion_tension`: of 1 or 4 k^2;', &
         '- `motion_phase`: of a period; `motion_time_to`: of the time and of 1/64 of a period together;', &
         '- `motion_slack_time`, the time to the slack angle as rounded: of the time and of the angle over', &
         '  the rate together.', '', &
         'Regimes by the name of `subnormal` have results, or arguments, below the normal numbers. Their', &
         'ulp is the smallest number there is, and no number says what of it is missing: 0 is correct', &
         'rounding, 1 is not. In those by the name of `overflow` some values are beyond the largest,', &
         'and infinity is what is right. `agm_steps_kn` and `_en` are K and E after so many steps, their', &
         'second argument; that of series and rules is the number of terms or subintervals.', '', &
         'The largest error of each family, over all forms and regimes but those listed by themselves,', &
         'and behind it that of the same points in one array.', '', &
         '| family | regime | real32 | array | real64 | array | real128 | array |', &
         '|---|---|---|---|---|---|---|---|'
      do i = 1, size(promises)
         write(unit, '(*(a))') '| ', trim(promises(i)%family), ' | ', trim(promises(i)%regime), &
            (' | ' // decimals(largest(i, kind)) // ' | ' // decimals(largest_of_array(i, kind)), &
            kind=1, size(kind_names)), ' |'
      end do
      write(unit, '(a)', advance='no') details
      close(unit)
   end subroutine write_report


   !> A line of the report's tables
   pure function row(what, kind) result(line)
      type(measurement), intent(in) :: what
      integer, intent(in) :: kind
      character(len=:), allocatable :: line
      character(len=12) :: points

      write(points, '(i0)') what%points
      line = '| ' // trim(what%name) // ' | ' // trim(what%regime) // ' | ' // trim(points) // ' | ' // &
         decimals(what%largest) // ' | ' // decimals(real(what%total/what%points)) // ' | ' // &
         decimals(what%largest_of_array) // ' | ' // &
         decimals(promises(promise_line(what))%bounds(kind)) // ' | ' // trim(what%worst) // ' |'
   end function row


   !> Three decimals of a nonnegative number; `none` and beyond in words
   pure function decimals(x) result(text)
      real, intent(in) :: x
      character(len=:), allocatable :: text
      character(len=16) :: buffer

      write(buffer, '(f16.3)') x
      if (.not. x < none) buffer = 'no bound'
      text = trim(adjustl(buffer))
   end function decimals

end module test_accuracy
! rooms: 2792044251
