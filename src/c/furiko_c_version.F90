! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> The library's version for C, as one number
module furiko_c_version
   use, intrinsic :: iso_c_binding, only : c_int
   use furiko, only : furiko_version
   implicit none
   private


contains


   !> 10000*major + 100*minor + patch: each dot moves what stands before it by two places
   pure function c_version() result(number) bind(c, name='furiko_version')
      integer(c_int) :: number
      integer :: i, part

      number = 0
      part = 0
      do i = 1, len(furiko_version)
         if (furiko_version(i:i) == '.') then
            number = 100*(number + part)
            part = 0
         else
            part = 10*part + index('0123456789', furiko_version(i:i)) - 1
         end if
      end do
      number = number + part
   end function c_version

end module furiko_c_version
! rooms: 3759241635
