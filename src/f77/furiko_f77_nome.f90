! SPDX-License-Identifier: MIT

!> For Fortran 77: the nome, theta functions, the parameter of a nome and of K.
! allow(C121)
module furiko_f77_nome
   use furiko_inverse_period
   use furiko_nome
   use furiko_theta
   implicit none
   public
end module furiko_f77_nome


include 'furiko_f77_nome.inc'
include 'furiko_f77_nome_real.inc'
! rooms: 1799974996
