! SPDX-License-Identifier: MIT

! The elliptic functions of Zhang and Jin (Computation of Special Functions, Wiley 1996, chapter 18;
! SPECFUN) under their names, computed by furiko. HK is the modulus k, angles are in DEGREES.
!
! Otherwise than there: numbers are right to 4 units in the last place (there: 8 to 15 digits); any angle,
! and any k that has a value, NaN elsewhere. Kept is 1.0D+300 for infinity.

!> K(k) and E(k)
subroutine comelp(hk, ck, ce)
   use furiko, only : ellipke_k
   implicit none
   double precision, intent(in) :: hk
   double precision, intent(out) :: ck, ce

   call ellipke_k(hk, ck, ce)
   ck = min(ck, 1.0d300)
end subroutine comelp


!> F(phi, k) and E(phi, k), phi in degrees; of whole right angles from K and E, lest pi be rounded
subroutine elit(hk, phi, fe, ee)
   use furiko, only : ellipeinc_k, ellipf_k, ellipke_k
   implicit none
   double precision, intent(in) :: hk, phi
   double precision, intent(out) :: fe, ee
   double precision, parameter :: degree = acos(-1.0d0)/180

   if (abs(mod(phi, 90.0d0)) > 0) then
      fe = ellipf_k(phi*degree, hk)
      ee = ellipeinc_k(phi*degree, hk)
   else
      call ellipke_k(hk, fe, ee)
      fe = phi/90*min(fe, 1.0d300)
      ee = phi/90*ee
   end if
end subroutine elit


!> Pi(c; phi, k) with 1 - c sin^2 below the line, phi in degrees
subroutine elit3(phi, hk, c, el3)
   use furiko, only : ellippi_k, ellippiinc_k
   implicit none
   double precision, intent(in) :: phi, hk, c
   double precision, intent(out) :: el3
   double precision, parameter :: degree = acos(-1.0d0)/180

   if (abs(mod(phi, 90.0d0)) > 0) then
      el3 = ellippiinc_k(c, phi*degree, hk)
   else
      el3 = phi/90*min(ellippi_k(c, hk), 1.0d300)
   end if
end subroutine elit3


!> sn, cn, dn and, in degrees, the amplitude
subroutine jelp(u, hk, esn, ecn, edn, eph)
   use furiko, only : jacobi_am_k, jacobi_k
   implicit none
   double precision, intent(in) :: u, hk
   double precision, intent(out) :: esn, ecn, edn, eph

   call jacobi_k(u, hk, esn, ecn, edn)
   eph = jacobi_am_k(u, hk)*(180/acos(-1.0d0))
end subroutine jelp
