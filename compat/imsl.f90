! SPDX-License-Identifier: MIT

! The elliptic functions of IMSL (MATH/LIBRARY Special Functions, chapters 9 and 10) by their Fortran 77
! names, computed by furiko: x of ELK and ELE is the parameter m = k^2, so is AM of EJSN, EJCN, EJDN.
! REAL, and with a D in front DOUBLE PRECISION.
!
! Otherwise than there: no error handler is called; where there is no value it is NaN, at a pole infinite
! (there: the largest number); arguments may be of any size.

real function elk(x)
   use furiko, only : ellipk_m
   implicit none
   real, intent(in) :: x

   elk = ellipk_m(x)
end function elk


double precision function delk(x)
   use furiko, only : ellipk_m
   implicit none
   double precision, intent(in) :: x

   delk = ellipk_m(x)
end function delk


real function ele(x)
   use furiko, only : ellipe_m
   implicit none
   real, intent(in) :: x

   ele = ellipe_m(x)
end function ele


double precision function dele(x)
   use furiko, only : ellipe_m
   implicit none
   double precision, intent(in) :: x

   dele = ellipe_m(x)
end function dele


real function elrf(x, y, z)
   use furiko, only : carlson_rf
   implicit none
   real, intent(in) :: x, y, z

   elrf = carlson_rf(x, y, z)
end function elrf


double precision function delrf(x, y, z)
   use furiko, only : carlson_rf
   implicit none
   double precision, intent(in) :: x, y, z

   delrf = carlson_rf(x, y, z)
end function delrf


real function elrd(x, y, z)
   use furiko, only : carlson_rd
   implicit none
   real, intent(in) :: x, y, z

   elrd = carlson_rd(x, y, z)
end function elrd


double precision function delrd(x, y, z)
   use furiko, only : carlson_rd
   implicit none
   double precision, intent(in) :: x, y, z

   delrd = carlson_rd(x, y, z)
end function delrd


real function elrj(x, y, z, rho)
   use furiko, only : carlson_rj
   implicit none
   real, intent(in) :: x, y, z, rho

   elrj = carlson_rj(x, y, z, rho)
end function elrj


double precision function delrj(x, y, z, rho)
   use furiko, only : carlson_rj
   implicit none
   double precision, intent(in) :: x, y, z, rho

   delrj = carlson_rj(x, y, z, rho)
end function delrj


real function elrc(x, y)
   use furiko, only : carlson_rc
   implicit none
   real, intent(in) :: x, y

   elrc = carlson_rc(x, y)
end function elrc


double precision function delrc(x, y)
   use furiko, only : carlson_rc
   implicit none
   double precision, intent(in) :: x, y

   delrc = carlson_rc(x, y)
end function delrc


real function ejsn(x, am)
   use furiko, only : jacobi_sn_m
   implicit none
   real, intent(in) :: x, am

   ejsn = jacobi_sn_m(x, am)
end function ejsn


double precision function dejsn(x, am)
   use furiko, only : jacobi_sn_m
   implicit none
   double precision, intent(in) :: x, am

   dejsn = jacobi_sn_m(x, am)
end function dejsn


real function ejcn(x, am)
   use furiko, only : jacobi_cn_m
   implicit none
   real, intent(in) :: x, am

   ejcn = jacobi_cn_m(x, am)
end function ejcn


double precision function dejcn(x, am)
   use furiko, only : jacobi_cn_m
   implicit none
   double precision, intent(in) :: x, am

   dejcn = jacobi_cn_m(x, am)
end function dejcn


real function ejdn(x, am)
   use furiko, only : jacobi_dn_m
   implicit none
   real, intent(in) :: x, am

   ejdn = jacobi_dn_m(x, am)
end function ejdn


double precision function dejdn(x, am)
   use furiko, only : jacobi_dn_m
   implicit none
   double precision, intent(in) :: x, am

   dejdn = jacobi_dn_m(x, am)
end function dejdn
