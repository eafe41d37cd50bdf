! SPDX-License-Identifier: MIT

!> The forms in which a modulus is given: by itself, by the parameter m = k^2, the complementary parameter
!> mc = 1 - m, the modular angle alpha, k = sin(alpha), or by the complementary modulus, k'^2 = 1 - k^2.
!> Internal.
module furiko_forms
   implicit none
   private
   public :: by_k, by_m, by_mc, by_alpha, by_k_of_complement
   integer, parameter :: by_k = 1, by_m = 2, by_mc = 3, by_alpha = 4, by_k_of_complement = 5
end module furiko_forms
