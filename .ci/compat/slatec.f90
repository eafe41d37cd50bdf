! SPDX-License-Identifier: MIT

!> compat/slatec.f90 against the check values of SLATEC's prologues (DRC(0,1/4) = DRC(1/16,1/8) = pi,
!> DRC(9/4,2) = ln 2, the sums of DRD, DRF and DRJ) and of Carlson's programs of 1987, RF(0,1,2); IER at
!> its limits.
program slatec
   use checks, only : equal, finish, near
   implicit none
   double precision, external :: drc, drd, drf, drj
   real, external :: rc, rd, rf, rj
   double precision, parameter :: e = 1.0d-15, pi = acos(-1.0d0), least = tiny(1.0d0), most = huge(1.0d0)
   double precision :: a, b
   integer :: ier, more

   call near('drc', drc(0.0d0, 0.25d0, ier), pi, 2*e)
   call equal('ier of drc', ier, 0)
   call near('drc', drc(0.0625d0, 0.125d0, ier), pi, 2*e)
   call near('drc', drc(2.25d0, 2.0d0, ier), log(2.0d0), e)
   call near('drf', drf(0.0d0, 1.0d0, 2.0d0, ier), 1.31102877714605990523d0, e)
   call near('drd', drd(1.0d0, 2.0d0, 3.0d0, ier) + drd(2.0d0, 3.0d0, 1.0d0, ier) + &
      drd(3.0d0, 1.0d0, 2.0d0, ier), 3/sqrt(6.0d0), 4*e)
   ! x y = z w: of DRF, and of DRJ with p = 3
   call near('drf', drf(2.0d0, 5.0d0, 6.0d0, ier) + drf(6.0d0, 9.0d0, 10.0d0, ier), &
      drf(0.0d0, 3.0d0, 4.0d0, ier), e)
   a = 9*(2 + 6 + 3 + 4)
   b = 3*(3 + 2)*(3 + 6)
   call near('drj', drj(2.0d0, 5.0d0, 6.0d0, 5.0d0, ier) + drj(6.0d0, 9.0d0, 10.0d0, 9.0d0, ier) + &
      (a - b)*drj(a, b, b, a, ier) + 3/sqrt(a), drj(0.0d0, 3.0d0, 4.0d0, 3.0d0, ier), 4*e)
   call near('rf', rf(0.0, 1.0, 2.0, ier), 1.31102877714605990523d0, 4.0d-7)
   call near('rc', rc(0.0, 0.25, ier), pi, 8.0d-7)
   call near('rd', rd(0.0, 2.0, 1.0, ier), 1.7972103521033883d0, 4.0d-7)
   call near('rj', rj(2.0, 3.0, 4.0, 5.0, ier), 0.14297579667156753833d0, 4.0d-8)
   call near('0 for an error', drf(-1.0d0, 2*most/3, 0.0d0, ier), 0.0d0, 0.0d0)
   call equal('1 before 3', ier, 1)
   a = drf(0.0d0, 0.0d0, most, ier)
   call equal('3 before 2', ier, 3)
   a = drc(1.0d0, 0.0d0, ier)
   call equal('drc: y = 0', ier, 1)
   call limits('drc', 5*least, most/5)
   call limits('drf', 5*least, most/5)
   call limits('drd', 2/most**(2.0d0/3), (0.1d0*(epsilon(a)/6)**(1.0d0/6)/least)**(2.0d0/3))
   call limits('drj', (5*least)**(1.0d0/3), 0.3d0*(most/5)**(1.0d0/3))
   b = rf(0.0, 1.0, huge(1.0)/4, ier)
   call equal('rf: large', ier, 3)
   b = rf(0.0, tiny(1.0), 1.0, ier)
   call equal('rf: small', ier, 2)
   b = rj(1.0, 1.0, 1.0, 1.0e-13, ier)
   call equal('rj: small', ier, 2)
   b = rd(1.0, 1.0, -1.0, more)
   call equal('rd: z < 0', more, 2)
   call finish('slatec')


contains


   !> One side of a limit and the other
   subroutine limits(name, lower, upper)
      character(len=*), intent(in) :: name
      double precision, intent(in) :: lower, upper

      call equal(name // ' at the lower limit', code(name, lower*(1 + 1.0d-12)), 0)
      call equal(name // ' below it', code(name, lower*(1 - 1.0d-12)), 2)
      call equal(name // ' at the upper limit', code(name, upper*(1 - 1.0d-12)), 0)
      call equal(name // ' above it', code(name, upper*(1 + 1.0d-12)), 3)
   end subroutine limits


   integer function code(name, x)
      character(len=*), intent(in) :: name
      double precision, intent(in) :: x
      double precision :: value, rest

      rest = merge(x, 1.0d0, x > 1)
      select case (name)
      case ('drc')
         value = drc(0.0d0, x, code)
      case ('drf')
         value = drf(0.0d0, x, rest, code)
      case ('drd')
         value = drd(1.0d0, rest, x, code)
      case default
         value = drj(1.0d0, 1.0d0, rest, x, code)
      end select
      if (code == 0 .neqv. value > 0) code = -1
   end function code

end program slatec
