! SPDX-License-Identifier: MIT

!> For Fortran 77: Jacobi's functions, their amplitude, epsilon, zeta, inverses.
! allow(C121)
module furiko_f77_jacobi
   use furiko_jacobi
   use furiko_jacobi_epsilon
   use furiko_jacobi_inverse
   use furiko_jacobi_zeta
   implicit none
   public
end module furiko_f77_jacobi


include 'furiko_f77_jacobi.inc'
include 'furiko_f77_jacobi_real.inc'
! rooms: 3146113978
