! SPDX-License-Identifier: MIT

!> The nome of k = 1/2, theta functions of it, and the way back.
program theta
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipk_k, nome_k, parameter_from_nome, theta3
   implicit none
   real(wp) :: q

   q = nome_k(0.5_wp)
   print '(f18.15)', q                                      ! => 0.017972387008967
   print '(f18.15)', acos(-1.0_wp)/2*theta3(0.0_wp, q)**2   ! => 1.685750354812596
   print '(f18.15)', ellipk_k(0.5_wp)                       ! => 1.685750354812596
   print '(f18.15)', parameter_from_nome(q)                 ! => 0.250000000000000
end program theta
