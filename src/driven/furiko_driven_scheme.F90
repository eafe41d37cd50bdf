! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> How driven pendulums are stepped: the method, the steps to a period of the drive, and what the drive is
!> at each of their stages.
module furiko_driven_scheme
   use, intrinsic :: iso_fortran_env, only : wp => real64
   implicit none
   private
   public :: driven_scheme, driven_order8, driven_rk4
   include 'furiko_driven_nodes.inc'


   !> A method with a number of steps to each period of the drive, made by [[driven_order8]] or
   !> [[driven_rk4]], and from then on only read: any number of threads may share it.
   type :: driven_scheme
      !> Steps to a period; 0 in a scheme that nobody has made
      integer :: steps = 0
      !> Stages of a step, each with a sine: 12 of order 8, 4 of order 4
      integer :: stages = 0
      !> Cosine and sine of the drive's phase, by stage and step. All members use them, whatever their
      !> frequencies are, since each has the same number of steps to its own period.
      real(wp), allocatable :: wave(:, :, :)
   end type driven_scheme


contains


   !> The method of order 8, 12 stages, of Dormand and Prince, with equal steps. The angle of a
   !> chaotic member (b = 0.5, g = 1.2, frequency 2/3) errs after one period by 7e-8 with 24 steps,
   !> 4e-9 with 32, 1e-11 with 64 and 6e-13 with 96; elsewhere compare with twice as many.
   !> Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 1993, II.5, II.10.
   pure function driven_order8(steps) result(scheme)
      !> Steps to a period of the drive, at least 1
      integer, intent(in) :: steps
      type(driven_scheme) :: scheme

      scheme = scheme_of(order8_nodes, steps)
   end function driven_order8


   !> The method of order 4 that the lecture notes and textbooks use; see [[rk4]]. Errors as for
   !> [[driven_order8]]: 4e-7 with 256 steps, 2e-9 with 1024.
   pure function driven_rk4(steps) result(scheme)
      !> Steps to a period of the drive, at least 1
      integer, intent(in) :: steps
      type(driven_scheme) :: scheme

      scheme = scheme_of(rk4_nodes, steps)
   end function driven_rk4


   pure function scheme_of(nodes, steps) result(scheme)
      real(wp), intent(in) :: nodes(:)
      integer, intent(in) :: steps
      type(driven_scheme) :: scheme
      real(wp), parameter :: turn = 2*acos(-1.0_wp)
      real(wp) :: phase
      integer :: i, j

      scheme%steps = max(steps, 1)
      scheme%stages = size(nodes)
      allocate(scheme%wave(2, scheme%stages, 0:scheme%steps - 1))
      do j = 0, scheme%steps - 1
         do i = 1, scheme%stages
            phase = turn*((real(j, wp) + nodes(i))/real(scheme%steps, wp))
            scheme%wave(:, i, j) = [cos(phase), sin(phase)]
         end do
      end do
   end function scheme_of
end module furiko_driven_scheme
! rooms: 1522845922
