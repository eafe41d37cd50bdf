! SPDX-License-Identifier: MIT

! Carlson's integrals under the names of SLATEC (category C14), computed by furiko, with SLATEC's IER: 0;
! 1 where an argument is negative, 2 too small, 3 too large for SLATEC's own method, looked for in its
! order, 1, 3, 2. The value is then 0, as there.
!
! Otherwise than there: nothing is printed (there: XERMSG), D1MACH and R1MACH are not called; numbers are
! right to 4 units in the last place. Who wants values beyond these limits calls FKRF and its sisters.

!> The limits, of each kind of number
module compat_slatec
   implicit none
   private
   public :: ier_of, rc_least, rc_most, rd_least, rd_most, rj_least, rj_most

   double precision, parameter :: smallest(2) = [dble(tiny(1.0)), tiny(1.0d0)]
   double precision, parameter :: largest(2) = [dble(huge(1.0)), huge(1.0d0)]
   double precision, parameter :: rounding(2) = [0.5d0*epsilon(1.0), 0.5d0*epsilon(1.0d0)]
   ! Of R_C and R_F, of R_D, of R_J: of REAL, of DOUBLE PRECISION
   double precision, parameter :: rc_least(2) = 5*smallest
   double precision, parameter :: rc_most(2) = largest/5
   double precision, parameter :: rd_least(2) = 2/largest**(2.0d0/3)
   double precision, parameter :: rd_most(2) = (0.1d0*(rounding/3)**(1.0d0/6)/smallest)**(2.0d0/3)
   double precision, parameter :: rj_least(2) = (5*smallest)**(1.0d0/3)
   double precision, parameter :: rj_most(2) = 0.3d0*(largest/5)**(1.0d0/3)


contains


   pure integer function ier_of(negative, too_large, too_small)
      logical, intent(in) :: negative, too_large, too_small

      ier_of = merge(1, merge(3, merge(2, 0, too_small), too_large), negative)
   end function ier_of

end module compat_slatec


double precision function drc(x, y, ier)
   use compat_slatec, only : ier_of, rc_least, rc_most
   use furiko, only : carlson_rc
   implicit none
   double precision, intent(in) :: x, y
   integer, intent(out) :: ier

   drc = 0
   ier = ier_of(x < 0 .or. y <= 0, max(x, y) > rc_most(2), x + y < rc_least(2))
   if (ier == 0) drc = carlson_rc(x, y)
end function drc


double precision function drf(x, y, z, ier)
   use compat_slatec, only : ier_of, rc_least, rc_most
   use furiko, only : carlson_rf
   implicit none
   double precision, intent(in) :: x, y, z
   integer, intent(out) :: ier

   drf = 0
   ier = ier_of(min(x, y, z) < 0, max(x, y, z) > rc_most(2), min(x + y, x + z, y + z) < rc_least(2))
   if (ier == 0) drf = carlson_rf(x, y, z)
end function drf


double precision function drd(x, y, z, ier)
   use compat_slatec, only : ier_of, rd_least, rd_most
   use furiko, only : carlson_rd
   implicit none
   double precision, intent(in) :: x, y, z
   integer, intent(out) :: ier

   drd = 0
   ier = ier_of(min(x, y) < 0, max(x, y, z) > rd_most(2), min(x + y, z) < rd_least(2))
   if (ier == 0) drd = carlson_rd(x, y, z)
end function drd


double precision function drj(x, y, z, p, ier)
   use compat_slatec, only : ier_of, rj_least, rj_most
   use furiko, only : carlson_rj
   implicit none
   double precision, intent(in) :: x, y, z, p
   integer, intent(out) :: ier

   drj = 0
   ier = ier_of(min(x, y, z) < 0, max(x, y, z, p) > rj_most(2), min(x + y, x + z, y + z, p) < rj_least(2))
   if (ier == 0) drj = carlson_rj(x, y, z, p)
end function drj


real function rc(x, y, ier)
   use compat_slatec, only : ier_of, rc_least, rc_most
   use furiko, only : carlson_rc
   implicit none
   real, intent(in) :: x, y
   integer, intent(out) :: ier

   rc = 0
   ier = ier_of(x < 0 .or. y <= 0, max(x, y) > rc_most(1), x + y < rc_least(1))
   if (ier == 0) rc = carlson_rc(x, y)
end function rc


real function rf(x, y, z, ier)
   use compat_slatec, only : ier_of, rc_least, rc_most
   use furiko, only : carlson_rf
   implicit none
   real, intent(in) :: x, y, z
   integer, intent(out) :: ier

   rf = 0
   ier = ier_of(min(x, y, z) < 0, max(x, y, z) > rc_most(1), min(x + y, x + z, y + z) < rc_least(1))
   if (ier == 0) rf = carlson_rf(x, y, z)
end function rf


real function rd(x, y, z, ier)
   use compat_slatec, only : ier_of, rd_least, rd_most
   use furiko, only : carlson_rd
   implicit none
   real, intent(in) :: x, y, z
   integer, intent(out) :: ier

   rd = 0
   ier = ier_of(min(x, y) < 0, max(x, y, z) > rd_most(1), min(x + y, z) < rd_least(1))
   if (ier == 0) rd = carlson_rd(x, y, z)
end function rd


real function rj(x, y, z, p, ier)
   use compat_slatec, only : ier_of, rj_least, rj_most
   use furiko, only : carlson_rj
   implicit none
   real, intent(in) :: x, y, z, p
   integer, intent(out) :: ier

   rj = 0
   ier = ier_of(min(x, y, z) < 0, max(x, y, z, p) > rj_most(1), min(x + y, x + z, y + z, p) < rj_least(1))
   if (ier == 0) rj = carlson_rj(x, y, z, p)
end function rj
