! SPDX-License-Identifier: MIT

!> Chance by a seed, and a watch on calls that do not come back.
module test_chance
   use, intrinsic :: iso_c_binding, only : c_funloc, c_funptr, c_int
   use, intrinsic :: iso_fortran_env, only : error_unit, int64, real64
   implicit none
   private
   public :: seed_chance, chance, one_of, watch


   !> POSIX's number of the alarm's signal
   integer(c_int), parameter :: alarm_signal = 14
   !> What is in hand, for when the alarm goes off
   character(len=80) :: in_hand = ''

   interface
      function c_alarm(seconds) result(left) bind(c, name='alarm')
         import :: c_int
         implicit none
         integer(c_int), value :: seconds
         integer(c_int) :: left
      end function c_alarm

      function c_signal(number, handler) result(old) bind(c, name='signal')
         import :: c_funptr, c_int
         implicit none
         integer(c_int), value :: number
         type(c_funptr), value :: handler
         type(c_funptr) :: old
      end function c_signal

      subroutine c_exit(code) bind(c, name='_exit')
         import :: c_int
         implicit none
         integer(c_int), value :: code
      end subroutine c_exit
   end interface


contains


   !> The same seed, the same draws (with one compiler).
   subroutine seed_chance(seed)
      integer, intent(in) :: seed
      integer, allocatable :: state(:)
      integer :: i, length
      real(real64) :: ignored

      call random_seed(size=length)
      allocate(state(length))
      state = [(int(modulo((seed + 1_int64)*(7919_int64*i + 104729_int64), 2147483647_int64)), i=1, length)]
      call random_seed(put=state)
      ! The first ones of seeds that are neighbours may be alike
      do i = 1, 20
         call random_number(ignored)
      end do
   end subroutine seed_chance


   !> Uniform in [0, 1), with all bits of real64
   function chance()
      real(real64) :: chance

      call random_number(chance)
   end function chance


   !> A whole number from 1 to n
   function one_of(n)
      integer, intent(in) :: n
      integer :: one_of

      one_of = 1 + int(n*chance())
   end function one_of


   !> From here on `name` is in hand, for so many seconds at most; 0 ends the watch.
   subroutine watch(name, seconds)
      character(len=*), intent(in) :: name
      integer, intent(in) :: seconds
      type(c_funptr) :: old
      integer(c_int) :: left

      in_hand = name
      old = c_signal(alarm_signal, c_funloc(give_up))
      left = c_alarm(int(seconds, c_int))
   end subroutine watch


   !> Say what hangs, and end.
   subroutine give_up(number) bind(c)
      integer(c_int), value :: number

      write(error_unit, '(3a, i0)') 'hangs: ', trim(in_hand), ', signal ', number
      flush(error_unit)
      call c_exit(1_c_int)
   end subroutine give_up

end module test_chance
