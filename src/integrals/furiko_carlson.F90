! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

module furiko_carlson_sp
   use furiko_carlson_plain_sp, only : rf, rc, rd, rj, rg, &
      rf_of_many, rc_of_many, rd_of_many, rj_of_many, rg_of_many
   implicit none
   private
   include 'furiko_carlson.inc'
   include 'furiko_carlson_of_many.inc'
end module furiko_carlson_sp


module furiko_carlson_dp
   use furiko_carlson_plain_dp, only : rf, rc, rd, rj, rg, &
      rf_of_many, rc_of_many, rd_of_many, rj_of_many, rg_of_many
   implicit none
   private
   include 'furiko_carlson.inc'
   include 'furiko_carlson_of_many.inc'
end module furiko_carlson_dp


#ifdef FURIKO_REAL128
module furiko_carlson_qp
   use furiko_carlson_plain_qp, only : rf, rc, rd, rj, rg
   implicit none
   private
   include 'furiko_carlson.inc'
end module furiko_carlson_qp
#endif


!> Carlson's symmetric elliptic integrals R_F, R_C, R_D, R_J, R_G for real arguments, in real32,
!> real64 and real128.
!> A rank-1 argument of real32 or real64 goes to a batch that the compiler vectorises; all else is
!> elemental.
! allow(C121)
module furiko_carlson
   use furiko_carlson_sp
   use furiko_carlson_dp
#ifdef FURIKO_REAL128
   use furiko_carlson_qp
#endif
   implicit none
   public
end module furiko_carlson
! rooms: 3305853556
