! SPDX-License-Identifier: MIT

! The elliptic functions of CERNLIB's MATHLIB under their names, computed by furiko: C346 (DELI1 to
! DELI3), C347 (DELI1C to DELI3C, DELIGC, DELIKC, DELIEC and the obsolete DELLIK, DELLIE, ELLICK, ELLICE),
! C318 (DELFUN), and the REAL ones with an R in front. AKP is the complementary modulus k', AK the modulus
! k, AK2 its square; X is the tangent of the angle. Of the third kind p = 1 - n, n in DLMF's sign.
!
! Otherwise than there: nothing is printed (there: MTLMTR, ABEND); where there is no value it is NaN, at a
! pole infinite; REAL functions are rounded from double precision. AK2 of DELI3C is not needed, k' and p
! keep their digits.
! Source: K. S. Koelbig, CERNLIB short writeups C318, C346, C347 (1992-1994).

!> Integrals from 0 to x as Bulirsch wrote them
module compat_cernlib
   use furiko, only : carlson_rd, carlson_rf, carlson_rj
   implicit none
   private
   public :: second_kind, third_kind


contains


   !> The arguments of Carlson's integrals, (1, 1 + mc x^2, 1 + x^2, 1 + p x^2), over the square of the larger
   !> of 1 and |x|, lest a square overflow; and x over it
   pure subroutine transform(x, mc, p, arguments, t)
      double precision, intent(in) :: x, mc, p
      double precision, intent(out) :: arguments(4), t
      double precision :: r

      r = 1/max(1.0d0, abs(x))
      t = sign(min(1.0d0, abs(x)), x)
      arguments = r*r + [0.0d0, mc, 1.0d0, p]*t*t
   end subroutine transform


   !> The integral of (a + b y^2)/((1 + y^2) sqrt((1 + y^2)(1 + mc y^2))): DLMF 19.25.9, 19.25.10
   pure double precision function second_kind(x, mc, a, b)
      double precision, intent(in) :: x, mc, a, b
      double precision :: u(4), t

      call transform(x, mc, 1.0d0, u, t)
      second_kind = a*t*carlson_rf(u(1), u(2), u(3)) + (b - a)/3*t**3*carlson_rd(u(1), u(2), u(3))
   end function second_kind


   !> The integral of (1 + y^2)/((1 + p y^2) sqrt((1 + y^2)(1 + mc y^2))): DLMF 19.25.14
   pure double precision function third_kind(x, mc, p)
      double precision, intent(in) :: x, mc, p
      double precision :: u(4), t

      call transform(x, mc, p, u, t)
      third_kind = t*carlson_rf(u(1), u(2), u(3)) + (1 - p)/3*t**3*carlson_rj(u(1), u(2), u(3), u(4))
   end function third_kind

end module compat_cernlib


!> F(atan x) of the complementary modulus akp
double precision function deli1(x, akp)
   use compat_cernlib, only : second_kind
   implicit none
   double precision, intent(in) :: x, akp

   deli1 = second_kind(x, akp*akp, 1.0d0, 1.0d0)
end function deli1


!> The integral of (a cos^2 + b sin^2)/sqrt(1 - k^2 sin^2) up to atan x; mode = -1: k'^2 is -akp^2
double precision function deli2(x, akp, a, b, mode)
   use compat_cernlib, only : second_kind
   implicit none
   double precision, intent(in) :: x, akp, a, b
   integer, intent(in) :: mode

   deli2 = second_kind(x, mode*akp*akp, a, b)
end function deli2


!> Pi(1 - p; atan x); of 1 + p x^2 < 0 the principal value
double precision function deli3(x, akp, p)
   use compat_cernlib, only : third_kind
   implicit none
   double precision, intent(in) :: x, akp, p

   deli3 = third_kind(x, akp*akp, p)
end function deli3


!> K of the complementary modulus akp
double precision function deli1c(akp)
   use furiko, only : bulirsch_cel
   implicit none
   double precision, intent(in) :: akp

   deli1c = bulirsch_cel(akp, 1.0d0, 1.0d0, 1.0d0)
end function deli1c


!> a B + b D
double precision function deli2c(akp, a, b)
   use furiko, only : bulirsch_cel
   implicit none
   double precision, intent(in) :: akp, a, b

   deli2c = bulirsch_cel(akp, 1.0d0, a, b)
end function deli2c


!> Pi(1 - p); of p < 0 the principal value. ak2 = 1 - akp^2 is not looked at
double precision function deli3c(akp, ak2, p)
   use furiko, only : bulirsch_cel
   implicit none
   double precision, intent(in) :: akp, ak2, p

   deli3c = bulirsch_cel(akp, p, 1.0d0, 1.0d0)
   ! A NaN goes through, as in any function.
   if (.not. abs(ak2) >= 0) deli3c = ak2
end function deli3c


!> Bulirsch's cel(akp, p, a, b)
double precision function deligc(akp, p, a, b)
   use furiko, only : bulirsch_cel
   implicit none
   double precision, intent(in) :: akp, p, a, b

   deligc = bulirsch_cel(akp, p, a, b)
end function deligc


!> K of the modulus ak
double precision function delikc(ak)
   use furiko, only : ellipk_k
   implicit none
   double precision, intent(in) :: ak

   delikc = ellipk_k(ak)
end function delikc


!> E of the modulus ak
double precision function deliec(ak)
   use furiko, only : ellipe_k
   implicit none
   double precision, intent(in) :: ak

   deliec = ellipe_k(ak)
end function deliec


!> DELIKC's older name
double precision function dellik(ak)
   implicit none
   double precision, intent(in) :: ak
   double precision, external :: delikc

   dellik = delikc(ak)
end function dellik


!> DELIEC's older name
double precision function dellie(ak)
   implicit none
   double precision, intent(in) :: ak
   double precision, external :: deliec

   dellie = deliec(ak)
end function dellie


!> sn, cn, dn of x and k^2 = ak2
subroutine delfun(x, ak2, sn, cn, dn)
   use furiko, only : jacobi_m
   implicit none
   double precision, intent(in) :: x, ak2
   double precision, intent(out) :: sn, cn, dn

   call jacobi_m(x, ak2, sn, cn, dn)
end subroutine delfun


! The REAL ones


real function reli1(x, akp)
   implicit none
   real, intent(in) :: x, akp
   double precision, external :: deli1

   reli1 = real(deli1(dble(x), dble(akp)))
end function reli1


real function reli2(x, akp, a, b, mode)
   implicit none
   real, intent(in) :: x, akp, a, b
   integer, intent(in) :: mode
   double precision, external :: deli2

   reli2 = real(deli2(dble(x), dble(akp), dble(a), dble(b), mode))
end function reli2


real function reli3(x, akp, p)
   implicit none
   real, intent(in) :: x, akp, p
   double precision, external :: deli3

   reli3 = real(deli3(dble(x), dble(akp), dble(p)))
end function reli3


real function reli1c(akp)
   implicit none
   real, intent(in) :: akp
   double precision, external :: deli1c

   reli1c = real(deli1c(dble(akp)))
end function reli1c


real function reli2c(akp, a, b)
   implicit none
   real, intent(in) :: akp, a, b
   double precision, external :: deli2c

   reli2c = real(deli2c(dble(akp), dble(a), dble(b)))
end function reli2c


real function reli3c(akp, ak2, p)
   implicit none
   real, intent(in) :: akp, ak2, p
   double precision, external :: deli3c

   reli3c = real(deli3c(dble(akp), dble(ak2), dble(p)))
end function reli3c


real function religc(akp, p, a, b)
   implicit none
   real, intent(in) :: akp, p, a, b
   double precision, external :: deligc

   religc = real(deligc(dble(akp), dble(p), dble(a), dble(b)))
end function religc


real function relikc(ak)
   implicit none
   real, intent(in) :: ak
   double precision, external :: delikc

   relikc = real(delikc(dble(ak)))
end function relikc


real function reliec(ak)
   implicit none
   real, intent(in) :: ak
   double precision, external :: deliec

   reliec = real(deliec(dble(ak)))
end function reliec


real function ellick(ak)
   implicit none
   real, intent(in) :: ak
   double precision, external :: delikc

   ellick = real(delikc(dble(ak)))
end function ellick


real function ellice(ak)
   implicit none
   real, intent(in) :: ak
   double precision, external :: deliec

   ellice = real(deliec(dble(ak)))
end function ellice


subroutine relfun(x, ak2, sn, cn, dn)
   implicit none
   real, intent(in) :: x, ak2
   real, intent(out) :: sn, cn, dn
   double precision :: s, c, d

   call delfun(dble(x), dble(ak2), s, c, d)
   sn = real(s)
   cn = real(c)
   dn = real(d)
end subroutine relfun
