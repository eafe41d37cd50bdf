! SPDX-License-Identifier: MIT

!> Every function of the catalogue in each kind of real, one call at a time and as arrays, and the objects,
!> once on the same points: for `tools/count_instructions.py`. Prints, in this order, what it calls and how
!> often.
program counts
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use bench_counts_dp, only : one => count_one, many => count_many
   use bench_counts_objects, only : count_object, objects
#ifdef __GFC_REAL_16__
   use bench_counts_qp, only : one_quad => count_one, many_quad => count_many
#endif
   use bench_counts_sp, only : one_single => count_one, many_single => count_many
   use furiko, only : modulus, modulus_from_m, motion, pendulum
   use furiko_by_name, only : evaluate
   use furiko_catalogue, only : argument_count, catalogue, catalogue_entry, result_count
   implicit none
   integer, parameter :: points = 96, few = 12
   !> Steps of sequences that fill an interval evenly: the square roots of 2, 3, 5, 7
   real(wp), parameter :: steps(4) = sqrt([2.0_wp, 3.0_wp, 5.0_wp, 7.0_wp])
   real(wp) :: m(points), angles(points), x(4, points, size(catalogue)), y(3, points)
   type(modulus) :: p
   type(motion) :: path
   type(pendulum) :: body
   integer :: i, j

   m = [(parameter_of(j), j=1, points)]
   angles = [(6*fraction_of(1, j), j=1, points)]
   do i = 1, size(catalogue)
      do j = 1, points
         x(:argument_count(catalogue(i)), j, i) = arguments_of(catalogue(i), argument_count(catalogue(i)), j)
      end do
   end do
   p = modulus_from_m(m(1))
   path = body%released(1.0_wp)
   ! No function: what there was until here
   call say('preparations', 'not counted', 1)
   call one(' ', x(:1, :1, 1), y(:1, :1))
   do i = 1, size(catalogue)
      call count_function(catalogue(i)%name, x(:argument_count(catalogue(i)), :, i), &
         y(:result_count(catalogue(i)), :))
   end do
   do i = 1, size(objects)
      call say(objects(i), 'real64', points)
      call count_object(i, p, path, angles, abs(m), y(1, :))
   end do


contains


   subroutine count_function(name, x, y)
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: x(:, :)
      real(wp), intent(out) :: y(:, :)

      call say(name, 'real32, scalar', points)
      call one_single(name, x, y)
      call say(name, 'real32, array', points)
      call many_single(name, x, y)
      call say(name, 'real64, scalar', points)
      call one(name, x, y)
      call say(name, 'real64, array', points)
      call many(name, x, y)
#ifdef __GFC_REAL_16__
      call say(name, 'real128, scalar', few)
      call one_quad(name, x(:, :few), y(:, :few))
      call say(name, 'real128, array', few)
      call many_quad(name, x(:, :few), y(:, :few))
#endif
   end subroutine count_function


   subroutine say(name, form, calls)
      character(len=*), intent(in) :: name, form
      integer, intent(in) :: calls

      print '(4a, i0)', trim(name), ' | ', form, ' | ', calls
   end subroutine say


   !> In [0, 1), the i-th of four at point j
   pure function fraction_of(i, j) result(f)
      integer, intent(in) :: i, j
      real(wp) :: f

      f = modulo(j*steps(i), 1.0_wp)
   end function fraction_of


   !> Three quarters of the points are everyday's, the others next to 1 or negative
   pure function parameter_of(j) result(m)
      integer, intent(in) :: j
      real(wp) :: m

      m = fraction_of(2, j)
      if (modulo(j, 8) == 3) m = 1 - 10.0_wp**(-1 - 5*m)
      if (modulo(j, 8) == 7) m = -m
   end function parameter_of


   !> The arguments of a function at point j. Those of an inverse are values of the function.
   function arguments_of(entry, inputs, j) result(x)
      type(catalogue_entry), intent(in) :: entry
      integer, intent(in) :: inputs, j
      real(wp) :: x(inputs)
      character(len=len(entry%arguments)) :: rest
      integer :: i

      rest = adjustl(entry%arguments)
      do i = 1, inputs
         x(i) = argument(rest(:index(rest, ' ') - 1), fraction_of(i, j), j)
         rest = adjustl(rest(index(rest, ' '):))
      end do
      if (index(entry%name, 'jacobi_arc') == 1) then
         associate (direct => 'jacobi_'//trim(entry%name(len('jacobi_arc') + 1:)))
            call evaluate(direct, [1.5_wp*fraction_of(1, j), x(2)], x(:1))
         end associate
      end if
   end function arguments_of


   !> One argument by its symbol in the catalogue
   pure function argument(symbol, f, j) result(x)
      character(len=*), intent(in) :: symbol
      real(wp), intent(in) :: f
      integer, intent(in) :: j
      real(wp) :: x
      real(wp) :: m

      m = parameter_of(j)
      x = f
      select case (symbol)
      case ('m')
         x = m
      case ('k')
         x = sqrt(abs(m))
      case ('mc')
         x = 1 - m
      case ('alpha')
         x = asin(sqrt(abs(m)))
      case ('phi', 'z', 's')
         x = merge(30.0_wp, 1.57_wp, modulo(j, 5) == 1)*f
      case ('u')
         x = merge(100.0_wp, 6.0_wp, modulo(j, 5) == 1)*f
      case ('n', 'q', 'excess')
         x = 0.9_wp*f
      case ('amplitude')
         x = 3*f
      case ('K')
         x = 1.5707964_wp + 5*f
      case ('ratio')
         x = 1 + 2*f
      case default
         x = f + 0.01_wp
      end select
   end function argument

end program counts
