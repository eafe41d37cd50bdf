! SPDX-License-Identifier: MIT

! The elliptic functions of the NAG Library, chapter S21, under their names, computed by furiko: S21BAF
! (R_C), S21BBF (R_F), S21BCF (R_D), S21BDF (R_J), S21BEF to S21BGF (F, E, Pi of phi and m; n in DLMF's
! sign), S21BHF, S21BJF (K, E of m), S21CAF (sn, cn, dn of u and m). DOUBLE PRECISION.
!
! IFAIL as there: on entry 0 stops at an error, -1 writes a line to standard error and goes on, 1 goes
! on silently; on exit 0, or which constraint of the routine is broken, numbered as in its documentation
! (Mark 24 to 30). The value is then 0, or at a pole the largest number.
!
! Otherwise than there: no X04AAF, P01ABF; IFAIL = 3 and 4 of S21BCF and S21BDF and both of S21CAF warn of
! what overflows or underflows there; here it comes out as infinity, as 0 or right, so IFAIL is then 0.

!> What is done about errors
module compat_nag
   use, intrinsic :: iso_fortran_env, only : error_unit
   implicit none
   private
   public :: answer, first_true, legendre_error, report, right_angle
   !> As programs have it, a little less
   double precision, parameter :: right_angle = acos(0.0d0)


contains


   !> Which is the first that is true; 0 if none
   pure integer function first_true(conditions)
      logical, intent(in) :: conditions(:)

      do first_true = 1, size(conditions)
         if (conditions(first_true)) return
      end do
      first_true = 0
   end function first_true


   !> Of Legendre's integrals up to phi, of which furiko says f: 1 outside 0 to pi/2, 2 where there is none, 3
   !> where it is infinite
   pure integer function legendre_error(phi, f, infinite)
      double precision, intent(in) :: phi, f
      logical, intent(in) :: infinite

      legendre_error = first_true([phi < 0 .or. phi > right_angle, .not. abs(f) >= 0, infinite])
   end function legendre_error


   !> 0 for an error, the largest number for infinity
   pure double precision function answer(error, f)
      integer, intent(in) :: error
      double precision, intent(in) :: f

      answer = f
      if (error > 0) answer = merge(0.0d0, huge(f), error < 3)
   end function answer


   subroutine report(name, error, ifail)
      character(len=*), intent(in) :: name
      integer, intent(in) :: error
      integer, intent(inout) :: ifail

      if (error /= 0 .and. ifail /= 1) write (error_unit, '(3a, i0)') 'furiko: ', name, ': IFAIL = ', error
      if (error /= 0 .and. ifail == 0) error stop 1
      ifail = error
   end subroutine report

end module compat_nag


double precision function s21baf(x, y, ifail)
   use compat_nag, only : first_true, report
   use furiko, only : carlson_rc
   implicit none
   double precision, intent(in) :: x, y
   integer, intent(inout) :: ifail

   call report('S21BAF', first_true([x < 0, abs(y) <= 0]), ifail)
   s21baf = 0
   if (ifail == 0) s21baf = carlson_rc(x, y)
end function s21baf


double precision function s21bbf(x, y, z, ifail)
   use compat_nag, only : first_true, report
   use furiko, only : carlson_rf
   implicit none
   double precision, intent(in) :: x, y, z
   integer, intent(inout) :: ifail

   call report('S21BBF', first_true([min(x, y, z) < 0, count([x, y, z] <= 0) > 1]), ifail)
   s21bbf = 0
   if (ifail == 0) s21bbf = carlson_rf(x, y, z)
end function s21bbf


double precision function s21bcf(x, y, z, ifail)
   use compat_nag, only : first_true, report
   use furiko, only : carlson_rd
   implicit none
   double precision, intent(in) :: x, y, z
   integer, intent(inout) :: ifail

   call report('S21BCF', first_true([min(x, y) < 0 .or. max(x, y) <= 0, z <= 0]), ifail)
   s21bcf = 0
   if (ifail == 0) s21bcf = carlson_rd(x, y, z)
end function s21bcf


double precision function s21bdf(x, y, z, r, ifail)
   use compat_nag, only : first_true, report
   use furiko, only : carlson_rj
   implicit none
   double precision, intent(in) :: x, y, z, r
   integer, intent(inout) :: ifail

   call report('S21BDF', first_true([min(x, y, z) < 0 .or. count([x, y, z] <= 0) > 1, abs(r) <= 0]), ifail)
   s21bdf = 0
   if (ifail == 0) s21bdf = carlson_rj(x, y, z, r)
end function s21bdf


double precision function s21bef(phi, dm, ifail)
   use compat_nag, only : answer, legendre_error, report, right_angle
   use furiko, only : ellipf_m
   implicit none
   double precision, intent(in) :: phi, dm
   integer, intent(inout) :: ifail

   s21bef = ellipf_m(phi, dm)
   call report('S21BEF', legendre_error(phi, s21bef, phi >= right_angle .and. dm >= 1), ifail)
   s21bef = answer(ifail, s21bef)
end function s21bef


double precision function s21bff(phi, dm, ifail)
   use compat_nag, only : answer, legendre_error, report
   use furiko, only : ellipeinc_m
   implicit none
   double precision, intent(in) :: phi, dm
   integer, intent(inout) :: ifail

   s21bff = ellipeinc_m(phi, dm)
   call report('S21BFF', legendre_error(phi, s21bff, .false.), ifail)
   s21bff = answer(ifail, s21bff)
end function s21bff


!> Its error 4: infinite, since n sin^2(phi) = 1
double precision function s21bgf(dn, phi, dm, ifail)
   use compat_nag, only : answer, legendre_error, report, right_angle
   use furiko, only : ellippiinc_m
   implicit none
   double precision, intent(in) :: dn, phi, dm
   integer, intent(inout) :: ifail
   integer :: error

   s21bgf = ellippiinc_m(dn, phi, dm)
   error = legendre_error(phi, s21bgf, phi >= right_angle .and. dm >= 1)
   if (error == 0 .and. abs(dn*sin(phi)**2 - 1) <= 0) error = 4
   call report('S21BGF', error, ifail)
   s21bgf = answer(ifail, s21bgf)
end function s21bgf


double precision function s21bhf(dm, ifail)
   use compat_nag, only : first_true, report
   use furiko, only : ellipk_m
   implicit none
   double precision, intent(in) :: dm
   integer, intent(inout) :: ifail

   s21bhf = ellipk_m(dm)
   call report('S21BHF', first_true([dm > 1, dm >= 1]), ifail)
   if (ifail == 1) s21bhf = 0
   if (ifail == 2) s21bhf = huge(dm)
end function s21bhf


double precision function s21bjf(dm, ifail)
   use compat_nag, only : first_true, report
   use furiko, only : ellipe_m
   implicit none
   double precision, intent(in) :: dm
   integer, intent(inout) :: ifail

   call report('S21BJF', first_true([dm > 1]), ifail)
   s21bjf = 0
   if (ifail == 0) s21bjf = ellipe_m(dm)
end function s21bjf


subroutine s21caf(u, m, sn, cn, dn, ifail)
   use compat_nag, only : report
   use furiko, only : jacobi_m
   implicit none
   double precision, intent(in) :: u, m
   double precision, intent(out) :: sn, cn, dn
   integer, intent(inout) :: ifail

   call jacobi_m(u, m, sn, cn, dn)
   call report('S21CAF', 0, ifail)
end subroutine s21caf
