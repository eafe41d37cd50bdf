! SPDX-License-Identifier: MIT

!> Does this build of the library compute right? For those who package it: `make check`, ctest and
!> `meson test` run this program, and ask nothing but the library.
program check
   use, intrinsic :: iso_fortran_env, only : wp => real64
   use furiko, only : ellipk_m, furiko_selftest, furiko_version, motion, pendulum
   implicit none
   type(motion) :: path
   type(pendulum) :: clock

   clock%length = 0.25_wp
   path = clock%released(1.0_wp)
   ! The README's numbers
   call compare(path%period(), 1.069751469668781_wp)
   call compare(path%angle(0.1_wp), 0.837997725111338_wp)
   call compare(ellipk_m(0.25_wp), 1.685750354812596_wp)
   if (furiko_selftest() /= 0) error stop 'furiko computes wrong numbers in this build'
   print '(3a)', 'furiko ', furiko_version, ' computes right'


contains


   subroutine compare(x, known)
      real(wp), intent(in) :: x, known

      if (.not. abs(x - known) < 1.0e-15_wp) error stop 'furiko does not know the README''s numbers'
   end subroutine compare

end program check
