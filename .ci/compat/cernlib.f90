! SPDX-License-Identifier: MIT

!> compat/cernlib.f90 against the definitions in the short writeups C346, C347 and C318, integrated by
!> mpmath 1.4.1 at x = 2, k' = 1/2; no table is printed there. K and E of k = 1/2 are also Abramowitz and
!> Stegun's, table 17.1.
program cernlib
   use checks, only : finish, near
   implicit none
   double precision, external :: deli1, deli2, deli3, deli1c, deli2c, deli3c, deligc, delikc, deliec, &
      dellik, dellie
   real, external :: reli1, reli2, reli3, reli1c, reli2c, reli3c, religc, relikc, reliec, ellick, ellice
   double precision, parameter :: e = 2.0d-15, r = 2.0d-6
   double precision, parameter :: f1 = 1.30529189842845783d0, f2 = 3.45171785889592382d0, &
      f3 = 0.84231945308015337d0
   double precision, parameter :: k = 1.68575035481259604d0, c1 = 2.15651564749964324d0, &
      c3 = 1.13929379710727542d0
   double precision, parameter :: second = 1.46746220933942715d0
   double precision :: sn, cn, dn
   real :: s, c, d

   call near('DELI1', deli1(2.0d0, 0.5d0), f1, e)
   call near('DELI1', deli1(-2.0d0, 0.5d0), -f1, e)
   call near('DELI1', deli1(1.0d200, 0.5d0), c1, e)
   call near('DELI1', deli1(1.0d-200, 0.5d0), 1.0d-200, 1.0d-215)
   call near('DELI2', deli2(2.0d0, 0.5d0, 3.0d0, 2.0d0, 1), f2, 2*e)
   call near('DELI2', deli2(2.0d0, 0.25d0, 3.0d0, 2.0d0, -1), 3.90658451580436721d0, 2*e)
   call near('DELI3', deli3(2.0d0, 0.5d0, 3.0d0), f3, e)
   ! A principal value
   call near('DELI3', deli3(2.0d0, 0.5d0, -1.0d0), 0.31499987053166140d0, e)
   call near('DELI1C', deli1c(0.5d0), c1, e)
   call near('DELI2C', deli2c(0.5d0, 3.0d0, 2.0d0), 5.20893411592401809d0, 2*e)
   call near('DELI3C', deli3c(0.5d0, 0.75d0, 3.0d0), c3, e)
   call near('DELIGC', deligc(0.5d0, 3.0d0, 1.0d0, 1.0d0), c3, e)
   call near('DELIGC', deligc(0.1d0, -4.1d0, 1.2d0, 1.1d0), -0.67687378198360556d0, e)
   call near('DELIKC', delikc(0.5d0), k, e)
   call near('DELIEC', deliec(0.5d0), second, e)
   call near('DELLIK', dellik(0.5d0), k, e)
   call near('DELLIE', dellie(0.5d0), second, e)
   call near('RELI1', reli1(2.0, 0.5), f1, r)
   call near('RELI2', reli2(2.0, 0.5, 3.0, 2.0, 1), f2, r)
   call near('RELI3', reli3(2.0, 0.5, 3.0), f3, r)
   call near('RELI1C', reli1c(0.5), c1, r)
   call near('RELI2C', reli2c(0.5, 3.0, 2.0), 5.20893411592401809d0, r)
   call near('RELI3C', reli3c(0.5, 0.75, 3.0), c3, r)
   call near('RELIGC', religc(0.5, 3.0, 1.0, 1.0), c3, r)
   call near('RELIKC', relikc(0.5), k, r)
   call near('RELIEC', reliec(0.5), second, r)
   call near('ELLICK', ellick(0.5), k, r)
   call near('ELLICE', ellice(0.5), second, r)
   ! sn = sin(am), cn, dn of F(pi/6, k = 1/2) = 0.52942863, Abramowitz and Stegun, table 17.5
   call delfun(0.52942863d0, 0.25d0, sn, cn, dn)
   call near('DELFUN', sn, 0.5d0, 1.0d-8)
   call near('DELFUN', cn, sqrt(0.75d0), 1.0d-8)
   call near('DELFUN', dn, sqrt(0.9375d0), 1.0d-8)
   call relfun(0.52942863, 0.25, s, c, d)
   call near('RELFUN', s, 0.5d0, r)
   call near('RELFUN', c, sqrt(0.75d0), r)
   call near('RELFUN', d, sqrt(0.9375d0), r)
   call finish('cernlib')
end program cernlib
