! SPDX-License-Identifier: MIT

! The elliptic functions of Numerical Recipes (Press, Teukolsky, Vetterling, Flannery: Numerical Recipes
! in FORTRAN, second edition, section 6.11, and cel of the first edition, 6.7) under their names, computed
! by furiko. To be compiled with a program in place of its own copies: REAL, or with -DNUMREC_DOUBLE in
! DOUBLE PRECISION, as many programs have changed theirs. A program compiled with -fdefault-real-8 has this
! file compiled with that flag and without the macro; a mismatch is not reported, and gives numbers near
! 1E-314.
!
! Otherwise than there: bad arguments give NaN, a pole infinity (there: PAUSE); arguments may be of any
! size, phi any angle, m > 1 and mc < 0 what a real argument can give; numbers are right to 4 units in the
! last place.

!> The kind of real
module compat_numrec
   implicit none
   public
#ifdef NUMREC_DOUBLE
   integer, parameter :: wp = kind(1.0d0)
#else
   integer, parameter :: wp = kind(1.0)
#endif
end module compat_numrec


!> R_F, x, y, z >= 0, at most one of them 0
function rf(x, y, z)
   use compat_numrec, only : wp
   use furiko, only : carlson_rf
   implicit none
   real(wp), intent(in) :: x, y, z
   real(wp) :: rf

   rf = carlson_rf(x, y, z)
end function rf


!> R_D, x, y >= 0, z > 0
function rd(x, y, z)
   use compat_numrec, only : wp
   use furiko, only : carlson_rd
   implicit none
   real(wp), intent(in) :: x, y, z
   real(wp) :: rd

   rd = carlson_rd(x, y, z)
end function rd


!> R_J, x, y, z >= 0; of p < 0 the principal value
function rj(x, y, z, p)
   use compat_numrec, only : wp
   use furiko, only : carlson_rj
   implicit none
   real(wp), intent(in) :: x, y, z, p
   real(wp) :: rj

   rj = carlson_rj(x, y, z, p)
end function rj


!> R_C, x >= 0; of y < 0 the principal value
function rc(x, y)
   use compat_numrec, only : wp
   use furiko, only : carlson_rc
   implicit none
   real(wp), intent(in) :: x, y
   real(wp) :: rc

   rc = carlson_rc(x, y)
end function rc


!> F(phi, k) of the modulus k = ak
function ellf(phi, ak)
   use compat_numrec, only : wp
   use furiko, only : ellipf_k
   implicit none
   real(wp), intent(in) :: phi, ak
   real(wp) :: ellf

   ellf = ellipf_k(phi, ak)
end function ellf


!> E(phi, k) of the modulus k = ak
function elle(phi, ak)
   use compat_numrec, only : wp
   use furiko, only : ellipeinc_k
   implicit none
   real(wp), intent(in) :: phi, ak
   real(wp) :: elle

   elle = ellipeinc_k(phi, ak)
end function elle


!> Pi(phi, n, k) with 1 + n sin^2 below the line, n = en: DLMF's and furiko's n is -en
function ellpi(phi, en, ak)
   use compat_numrec, only : wp
   use furiko, only : ellippiinc_k
   implicit none
   real(wp), intent(in) :: phi, en, ak
   real(wp) :: ellpi

   ellpi = ellippiinc_k(-en, phi, ak)
end function ellpi


!> sn, cn, dn of uu and the complementary parameter emmc = 1 - k^2
subroutine sncndn(uu, emmc, sn, cn, dn)
   use compat_numrec, only : wp
   use furiko, only : jacobi_mc
   implicit none
   real(wp), intent(in) :: uu, emmc
   real(wp), intent(out) :: sn, cn, dn

   call jacobi_mc(uu, emmc, sn, cn, dn)
end subroutine sncndn


!> Bulirsch's cel(kc, p, a, b)
function cel(qqc, pp, aa, bb)
   use compat_numrec, only : wp
   use furiko, only : bulirsch_cel
   implicit none
   real(wp), intent(in) :: qqc, pp, aa, bb
   real(wp) :: cel

   cel = bulirsch_cel(qqc, pp, aa, bb)
end function cel
