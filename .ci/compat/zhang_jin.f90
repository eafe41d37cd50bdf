! SPDX-License-Identifier: MIT

!> compat/zhang_jin.f90 against the tables in the comments of Zhang and Jin's MCOMELP, MELIT, MJELP (1996)
program zhang_jin
   use checks, only : finish, near
   implicit none
   double precision, parameter :: k(5) = [0.0d0, 0.25d0, 0.5d0, 0.75d0, 1.0d0]
   double precision, parameter :: first(5) = [1.570796d0, 1.596242d0, 1.685750d0, 1.910990d0, 1.0d300]
   double precision, parameter :: second(5) = [1.570796d0, 1.545957d0, 1.467462d0, 1.318472d0, 1.0d0]
   double precision, parameter :: f(0:6) = [0.0d0, 0.26254249d0, 0.52942863d0, 0.80436610d0, 1.08955067d0, &
      1.38457455d0, 1.68575035d0]
   double precision, parameter :: e(0:6) = [0.0d0, 0.26106005d0, 0.51788193d0, 0.76719599d0, 1.00755556d0, &
      1.23988858d0, 1.46746221d0]
   double precision, parameter :: phi(0:4) = [0.0d0, 47.0586d0, 90.0d0, 132.9414d0, 180.0d0]
   double precision, parameter :: sn(0:4) = [0.0d0, 0.7320508d0, 1.0d0, 0.7320508d0, 0.0d0]
   double precision, parameter :: cn(0:4) = [1.0d0, 0.6812500d0, 0.0d0, -0.6812500d0, -1.0d0]
   double precision, parameter :: dn(0:4) = [1.0d0, 0.9306049d0, 0.8660254d0, 0.9306049d0, 1.0d0]
   double precision :: a, b, c, d, complete
   integer :: i

   do i = 1, 5
      call comelp(k(i), a, b)
      call near('comelp', a, first(i), 1.0d-6)
      call near('comelp', b, second(i), 1.0d-6)
   end do
   do i = 0, 6
      call elit(0.5d0, 15.0d0*i, a, b)
      call near('elit', a, f(i), 1.0d-8)
      call near('elit', b, e(i), 1.0d-8)
   end do
   call elit(1.0d0, 90.0d0, a, b)
   call near('elit at infinity', a, 1.0d300, 0.0d0)
   call near('elit at infinity', b, 1.0d0, 0.0d0)
   call comelp(0.5d0, complete, b)
   do i = 0, 4
      call jelp(0.5d0*i*complete, 0.5d0, a, b, c, d)
      call near('jelp', a, sn(i), 1.0d-7)
      call near('jelp', b, cn(i), 1.0d-7)
      call near('jelp', c, dn(i), 1.0d-7)
      call near('jelp', d, phi(i), 1.0d-4)
   end do
   ! mpmath 1.4.1: ellippi(0.5, pi/4, 0.25), ellippi(0.5, 0.25)
   call elit3(45.0d0, 0.5d0, 0.5d0, a)
   call near('elit3', a, 0.89306572890534415d0, 1.0d-15)
   call elit3(90.0d0, 0.5d0, 0.5d0, a)
   call near('elit3', a, 2.4136715042011945d0, 2.0d-15)
   call elit3(90.0d0, 0.5d0, 1.0d0, a)
   call near('elit3 at infinity', a, 1.0d300, 0.0d0)
   call finish('zhang_jin')
end program zhang_jin
