! SPDX-License-Identifier: MIT

!> Elliptic integrals and the exact pendulum: what a program `use`s.
!>
!> The argument's form is in the name, always: `_k` takes the modulus k, `_m` the parameter
!> m = k^2, `_mc` the complementary parameter mc = 1 - m. All procedures are elemental and
!> generic over real32, real64 and (where the compiler has it) real128.
!>
!> - Complete integrals: `print *, ellipk_m(0.25d0), ellipe_k(0.5)`, or both at once,
!>   `call ellipke_mc(mc, k, e)`; see [[ellipk_k]], [[ellipe_k]], [[ellipke_k]].
!> - The pendulum's period: `period_ratio(theta0)` times 2 pi sqrt(l/g); see [[period_ratio]].
!> - The arithmetic-geometric mean: `agm(1.0, sqrt(2.0))`; see [[agm]].
module furiko
   use furiko_agm, only : agm
   use furiko_complete, only : ellipk_k, ellipk_m, ellipk_mc, ellipe_k, ellipe_m, ellipe_mc, &
      ellipke_k, ellipke_m, ellipke_mc
   use furiko_period, only : period_ratio
   implicit none
   private
   public :: furiko_version
   public :: agm
   public :: ellipk_k, ellipk_m, ellipk_mc
   public :: ellipe_k, ellipe_m, ellipe_mc
   public :: ellipke_k, ellipke_m, ellipke_mc
   public :: period_ratio


   !> The library's version, by the rules of semver.org
   character(len=*), parameter :: furiko_version = '0.1.0'

end module furiko
