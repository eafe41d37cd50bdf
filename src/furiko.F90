! SPDX-License-Identifier: MIT
#include "arithmetic/furiko_compiler.inc"

!> Elliptic integrals, Jacobi elliptic functions and the exact pendulum: what a program `use`s.
!>
!> The argument's form is in the name, always: `_k` takes the modulus k, `_m` the parameter
!> m = k^2, `_mc` the complementary parameter mc = 1 - m, `_alpha` the modular angle. n and phi stand
!> before it. All procedures are elemental and generic over real32, real64 and (where the compiler
!> has it) real128; arrays of rank 1 go to vectorised kernels under the same names.
!>
!> - Complete integrals K, E, B, D, S: `print *, ellipk_m(0.25d0), ellipe_k(0.5)`, K and E at once
!>   `call ellipke_mc(mc, k, e)`; see [[ellipk_k]], [[ellipe_k]], [[ellipb_k]], [[ellipd_k]], [[ellips_k]].
!> - Incomplete integrals F, E, D: `ellipf_m(phi, m)`; see [[ellipf_k]], [[ellipeinc_k]], [[ellipdinc_k]].
!> - The third kind: `ellippi_m(n, m)`, `ellippiinc_m(n, phi, m)`, and J = (Pi - K)/n, `ellipj_m(n, m)`,
!>   `ellipjinc_m(n, phi, m)`; see [[ellippi_k]], [[ellippiinc_k]], [[ellipj_k]], [[ellipjinc_k]].
!> - Bulirsch's `bulirsch_cel(kc, p, a, b)`, of which all complete integrals are cases; see [[bulirsch_cel]].
!> - Carlson's forms: `carlson_rf(x, y, z)`; see [[carlson_rf]] and its sisters.
!> - Jacobi elliptic functions: `call jacobi_m(u, m, sn, cn, dn)`, `jacobi_sn_k(u, k)` and its eleven
!>   sisters, the amplitude `jacobi_am_m`, the inverses `jacobi_arcsn_m(x, m)` ...; see [[jacobi_k]].
!> - One modulus, many u: `p = modulus_from_k(k)`, `call p%jacobi(u, sn, cn, dn)`; see [[modulus]].
!> - Nome, theta functions, zeta and lambda: `nome_m(m)`, `theta1(z, q)`, `jacobi_zeta_m(phi, m)`; see
!>   [[nome_m]], [[theta1]], [[jacobi_zeta_m]].
!> - The pendulum's exact motion: `path = body%released(1.0d0)`, `path%angle(t)`; see [[pendulum]],
!>   [[motion]]. Its period: `period_ratio(theta0)` times 2 pi sqrt(l/g); see [[period_ratio]].
!> - The notes' own ways, to be compared with: the power series `ellipk_series_k(k, terms)` and the
!>   bound on its remainder, the trapezoidal rule `ellipk_trapezoid_k(k, n)`, the mean step by step
!>   `agm_steps_k`; see [[ellipk_series_k]], [[ellipk_trapezoid_k]], [[agm_steps_k]].
!> - An ellipse's perimeter: `ellipse_perimeter(2.0, 1.0)`; see [[ellipse_perimeter]].
!> - Equations of motion in steps: `call rk4(rates, parameters, t0, h, steps, y)` for any system,
!>   `verlet` and `forest_ruth` for x'' = a(x), `call pendulum_rk4(omega2, h, steps, angle, rate)` for
!>   one pendulum or many; see [[rk4]], [[verlet]], [[pendulum_rk4]].
!> - Driven, damped pendulums, many at once: `call driven_periods(scheme, pendulum, state, periods)`,
!>   `scheme = driven_order8(96)`; sections, cycles and where they double, Lyapunov exponents, winding
!>   numbers, basins; see [[driven_steps]], [[driven_section]], [[driven_cycle]],
!>   [[driven_exponents]], [[driven_basins]].
!> - Whether this build computes right: `furiko_selftest()` is 0; see [[furiko_selftest]].
!> - The arithmetic-geometric mean: `agm(1.0, sqrt(2.0))`; see [[agm]].
! allow(C121)
module furiko
   use furiko_agm
   use furiko_complete
   use furiko_ellips
   use furiko_incomplete
   use furiko_third_kind
   use furiko_ellipj
   use furiko_cel
   use furiko_carlson
   use furiko_nome
   use furiko_theta
   use furiko_jacobi
   use furiko_modulus
   use furiko_jacobi_epsilon
   use furiko_jacobi_inverse
   use furiko_inverse_period
   use furiko_second_inverse
   use furiko_jacobi_zeta
   use furiko_motion
   use furiko_period
   use furiko_series
   use furiko_trapezoid
   use furiko_agm_steps
   use furiko_ellipse
   use furiko_known_values
   use furiko_rk4
   use furiko_symplectic
   use furiko_pendulum_steps
   use furiko_driven_scheme
   use furiko_driven_steps
   use furiko_driven_sections
   use furiko_driven_cycles
   use furiko_driven_lyapunov
   use furiko_driven_rotation
   use furiko_driven_basins
   implicit none
   public


   !> The library's version, by the rules of semver.org
   character(len=*), parameter :: furiko_version = '0.3.0'

end module furiko
! rooms: 3759241635
