! SPDX-License-Identifier: MIT

! Written by tools/make_c_interface.py.

!> All that C calls: for fpm, which leaves out of a library the modules that no program uses. Fortran finds
!> nothing here.
! allow(C121)
module furiko_c
   use furiko_c_agm_dp
   use furiko_c_agm_sp
   use furiko_c_carlson_dp
   use furiko_c_carlson_sp
   use furiko_c_cel_dp
   use furiko_c_cel_sp
   use furiko_c_complete_dp
   use furiko_c_complete_sp
   use furiko_c_ellipj_dp
   use furiko_c_ellipj_sp
   use furiko_c_ellips_dp
   use furiko_c_ellips_sp
   use furiko_c_ellipse_dp
   use furiko_c_ellipse_sp
   use furiko_c_incomplete_dp
   use furiko_c_incomplete_sp
   use furiko_c_inverse_period_dp
   use furiko_c_inverse_period_sp
   use furiko_c_jacobi_dp
   use furiko_c_jacobi_epsilon_dp
   use furiko_c_jacobi_epsilon_sp
   use furiko_c_jacobi_inverse_dp
   use furiko_c_jacobi_inverse_sp
   use furiko_c_jacobi_sp
   use furiko_c_jacobi_zeta_dp
   use furiko_c_jacobi_zeta_sp
   use furiko_c_modulus
   use furiko_c_motion
   use furiko_c_nome_dp
   use furiko_c_nome_sp
   use furiko_c_pendulum_steps_dp
   use furiko_c_pendulum_steps_sp
   use furiko_c_period_dp
   use furiko_c_period_sp
   use furiko_c_rk4_dp
   use furiko_c_rk4_sp
   use furiko_c_second_inverse_dp
   use furiko_c_second_inverse_sp
   use furiko_c_selftest
   use furiko_c_series_dp
   use furiko_c_series_sp
   use furiko_c_symplectic_dp
   use furiko_c_symplectic_sp
   use furiko_c_theta_dp
   use furiko_c_theta_sp
   use furiko_c_third_kind_dp
   use furiko_c_third_kind_sp
   use furiko_c_version
   implicit none
   private
end module furiko_c
