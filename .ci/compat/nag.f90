! SPDX-License-Identifier: MIT

!> compat/nag.f90 against the example program results of the NAG Library's manual (Mark 24 to 30.3), IFAIL
!> included
program nag
   use checks, only : equal, finish, near
   implicit none
   double precision, external :: s21baf, s21bbf, s21bcf, s21bdf, s21bef, s21bff, s21bgf, s21bhf, s21bjf
   double precision, parameter :: u(4) = [0.2d0, 5.0d0, -0.5d0, 10.0d0]
   double precision, parameter :: m(4) = [0.3d0, -1.0d0, -0.1d0, 11.0d0]
   double precision, parameter :: sn(4) = [0.1983d0, -0.2440d0, -0.4812d0, 0.2512d0]
   double precision, parameter :: cn(4) = [0.9801d0, 0.9698d0, 0.8766d0, 0.9679d0]
   double precision, parameter :: dn(4) = [0.9941d0, 1.029d0, 1.012d0, 0.5528d0]
   double precision, parameter :: e = 1.0d-4
   double precision :: x, y, z, a, b, c
   integer :: i, ifail

   do i = 1, 4
      ifail = -1
      call s21caf(u(i), m(i), a, b, c, ifail)
      call equal('S21CAF', ifail, 0)
      call near('S21CAF', a, sn(i), e)
      call near('S21CAF', b, cn(i), e)
      call near('S21CAF', c, dn(i), merge(e, 1.0d-3, dn(i) < 1))
   end do
   x = 0.5d0
   y = 1.0d0
   z = 1.5d0
   ifail = 0
   call near('S21BBF', s21bbf(x, y, z, ifail), 1.0281d0, e)
   call near('S21BBF', s21bbf(1.5d0, 2.0d0, 2.5d0, ifail), 0.7116d0, e)
   call near('S21BCF', s21bcf(x, x, y, ifail), 1.4787d0, e)
   call near('S21BCF', s21bcf(z, z, y, ifail), 0.7775d0, e)
   call near('S21BDF', s21bdf(x, x, x, 2.0d0, ifail), 1.1184d0, e)
   call near('S21BDF', s21bdf(x, z, z, 2.0d0, ifail), 0.6017d0, e)
   call near('S21BFF', s21bff(acos(-1.0d0)/6, 0.25d0, ifail), 0.5179d0, e)
   call near('S21BFF', s21bff(acos(-1.0d0)/3, 0.50d0, ifail), 0.9650d0, e)
   call near('S21BFF', s21bff(acos(-1.0d0)/2, 0.75d0, ifail), 1.2111d0, e)
   call near('S21BJF', s21bjf(0.25d0, ifail), 1.4675d0, e)
   call near('S21BJF', s21bjf(0.50d0, ifail), 1.3506d0, e)
   call near('S21BJF', s21bjf(0.75d0, ifail), 1.2111d0, e)
   call equal('no error', ifail, 0)
   ! Of the others by mpmath 1.4.1
   call near('S21BAF', s21baf(0.5d0, 1.0d0, ifail), 1.1107207345395916d0, 1.0d-15)
   call near('S21BEF', s21bef(0.7d0, 0.36d0, ifail), 0.72007839946519029d0, 1.0d-15)
   call near('S21BGF', s21bgf(0.3d0, 0.7d0, 0.36d0, ifail), 0.75552974499568021d0, 1.0d-15)
   call near('S21BHF', s21bhf(0.5d0, ifail), 1.8540746773013719d0, 1.0d-15)
   call errors
   call finish('nag')


contains


   !> IFAIL = 1 on entry: silent
   subroutine errors
      ifail = 1
      call failed(1, s21baf(-1.0d0, 1.0d0, ifail))
      call failed(2, s21baf(1.0d0, 0.0d0, ifail))
      call failed(1, s21bbf(-1.0d0, 1.0d0, 1.0d0, ifail))
      call failed(2, s21bbf(0.0d0, 1.0d0, 0.0d0, ifail))
      call failed(1, s21bcf(0.0d0, 0.0d0, 1.0d0, ifail))
      call failed(2, s21bcf(0.0d0, 1.0d0, 0.0d0, ifail))
      call failed(1, s21bdf(0.0d0, 0.0d0, 1.0d0, 1.0d0, ifail))
      call failed(2, s21bdf(0.0d0, 1.0d0, 1.0d0, 0.0d0, ifail))
      call failed(1, s21bef(-1.0d0, 0.5d0, ifail))
      call failed(2, s21bef(1.0d0, 2.0d0, ifail))
      call failed(1, s21bff(2.0d0, 0.5d0, ifail))
      call failed(2, s21bff(1.0d0, 2.0d0, ifail))
      call failed(1, s21bgf(0.5d0, 2.0d0, 0.5d0, ifail))
      call failed(2, s21bgf(0.5d0, 1.0d0, 2.0d0, ifail))
      call failed(1, s21bhf(2.0d0, ifail))
      call failed(1, s21bjf(2.0d0, ifail))
      call infinite(2, s21bhf(1.0d0, ifail))
      call infinite(3, s21bef(acos(0.0d0), 1.0d0, ifail))
      call infinite(3, s21bgf(0.5d0, acos(0.0d0), 1.0d0, ifail))
      call infinite(4, s21bgf(1.0d0, acos(0.0d0), 0.5d0, ifail))
   end subroutine errors


   !> What was called before gives 0, and its error
   subroutine failed(error, value)
      integer, intent(in) :: error
      double precision, intent(in) :: value

      call near('0 for an error', value, 0.0d0, 0.0d0)
      call equal('IFAIL', ifail, error)
      ifail = 1
   end subroutine failed


   !> What was called before gives the largest number, and its error
   subroutine infinite(error, value)
      integer, intent(in) :: error
      double precision, intent(in) :: value

      call near('the largest number for infinity', value, huge(value), 0.0d0)
      call equal('IFAIL', ifail, error)
      ifail = 1
   end subroutine infinite

end program nag
