! SPDX-License-Identifier: MIT

!> compat/numrec.F90, REAL or by -DNUMREC_DOUBLE in DOUBLE PRECISION, against published numbers: Carlson,
!> Numer. Algorithms 10 (1995) 13, section 3; Zhang and Jin (1996), tables of ELIT; NAG's S21CAF, program
!> results; Bulirsch, Numer. Math. 13 (1969) 305.
program numrec
   use checks, only : finish, near
   use compat_numrec, only : wp
   implicit none
   ! In the last of 13 digits, or of the kind
   double precision, parameter :: e = max(1.0d-13, 8*dble(epsilon(1.0_wp)))
   real(wp), external :: cel, elle, ellf, ellpi, rc, rd, rf, rj
   real(wp) :: sn, cn, dn

   call near('rf', rf(1.0_wp, 2.0_wp, 0.0_wp), 1.3110287771461d0, e)
   call near('rf', rf(2.0_wp, 3.0_wp, 4.0_wp), 0.58408284167715d0, e)
   call near('rc', rc(0.0_wp, 0.25_wp), 3.1415926535898d0, 4*e)
   call near('rc', rc(2.25_wp, 2.0_wp), 0.69314718055995d0, e)
   call near('rc', rc(0.25_wp, -2.0_wp), 0.23104906018665d0, e)
   call near('rj', rj(0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp), 0.77688623778582d0, e)
   call near('rj', rj(2.0_wp, 3.0_wp, 4.0_wp, 5.0_wp), 0.14297579667157d0, e)
   call near('rj', rj(2.0_wp, 3.0_wp, 4.0_wp, -0.5_wp), 0.24723819703052d0, e)
   call near('rj', rj(2.0_wp, 3.0_wp, 4.0_wp, -5.0_wp), -0.12711230042964d0, e)
   call near('rd', rd(0.0_wp, 2.0_wp, 1.0_wp), 1.7972103521034d0, 2*e)
   call near('rd', rd(2.0_wp, 3.0_wp, 4.0_wp), 0.16510527294261d0, e)
   call near('ellf', ellf(acos(-1.0_wp)/6, 0.5_wp), 0.52942863d0, max(1.0d-8, e))
   call near('elle', elle(acos(-1.0_wp)/6, 0.5_wp), 0.51788193d0, max(1.0d-8, e))
   ! mpmath 1.4.1: ellippi(-0.3, 0.7, 0.36), the sign being theirs
   call near('ellpi', ellpi(0.7_wp, 0.3_wp, 0.6_wp), 0.68974765253668709d0, e)
   call sncndn(0.2_wp, 0.7_wp, sn, cn, dn)
   call near('sncndn', sn, 0.1983d0, 1.0d-4)
   call near('sncndn', cn, 0.9801d0, 1.0d-4)
   call near('sncndn', dn, 0.9941d0, 1.0d-4)
   call sncndn(10.0_wp, -10.0_wp, sn, cn, dn)
   call near('sncndn', sn, 0.2512d0, 1.0d-4)
   call near('sncndn', cn, 0.9679d0, 1.0d-4)
   call near('sncndn', dn, 0.5528d0, 1.0d-4)
   call near('cel', cel(0.1_wp, 4.1_wp, 1.2_wp, 1.1_wp), 1.5464442694017956d0, 2*e)
   call near('cel', cel(0.1_wp, -4.1_wp, 1.2_wp, 1.1_wp), -0.67687378198360556d0, 2*e)
   call finish('numrec')
end program numrec
