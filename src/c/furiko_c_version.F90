! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> The library's version for C, as one number; the text is in furiko_c_version.inc.
module furiko_c_version
   use, intrinsic :: iso_c_binding, only : c_int
   use furiko, only : furiko_version
   implicit none
   private
   include 'furiko_c_version.inc'
end module furiko_c_version
! rooms: 2664521601
