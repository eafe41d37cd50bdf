! SPDX-License-Identifier: MIT

!> compat/imsl.f90 against the outputs in IMSL's manual (Special Functions, 2021.0 and 2024.1; PV-WAVE
!> 2017.0 and 2023.3), and the rest against Abramowitz and Stegun, table 17.1 (m = 0.5), and Carlson
!> (1995)
program imsl
   use checks, only : finish, near
   implicit none
   real, external :: elk, ele, elrf, elrd, elrj, elrc, ejsn, ejcn, ejdn
   double precision, external :: delk, dele, delrf, delrd, delrj, delrc, dejsn, dejcn, dejdn
   double precision, parameter :: e = 1.0d-13, r = 2.0d-6, printed = 5.0d-4

   call near('ELRJ', elrj(2.0, 3.0, 4.0, 5.0), 0.143d0, printed)
   call near('ELRD', elrd(0.0, 2.0, 1.0), 1.797d0, printed)
   call near('ELRC', elrc(0.0, 1.0), 1.571d0, printed)
   call near('ELRC', elrc(2.25, 2.0), 0.693147d0, 1.0d-6)
   call near('EJSN', ejsn(1.5, 0.5), 0.968d0, printed)
   call near('EJCN', ejcn(1.5, 0.5), 0.250d0, printed)
   call near('ELK', elk(0.0), 1.57080d0, 5.0d-6)
   call near('ELK', elk(0.5), 1.854074677301372d0, r)
   call near('ELE', ele(0.5), 1.350643881047675d0, r)
   call near('ELRF', elrf(2.0, 3.0, 4.0), 0.58408284167715d0, r)
   ! dn^2 = 1 - m sn^2
   call near('EJDN', ejdn(1.5, 0.5)**2, 1 - 0.5d0*ejsn(1.5, 0.5)**2, r)
   call near('DELK', delk(0.5d0), 1.854074677301372d0, 1.0d-15)
   call near('DELE', dele(0.5d0), 1.350643881047675d0, 1.0d-15)
   call near('DELRF', delrf(2.0d0, 3.0d0, 4.0d0), 0.58408284167715d0, e)
   call near('DELRD', delrd(2.0d0, 3.0d0, 4.0d0), 0.16510527294261d0, e)
   call near('DELRJ', delrj(2.0d0, 3.0d0, 4.0d0, 5.0d0), 0.14297579667157d0, e)
   call near('DELRC', delrc(2.25d0, 2.0d0), 0.69314718055995d0, e)
   call near('DEJSN', dejsn(1.5d0, 0.5d0), 0.968d0, printed)
   call near('DEJCN', dejcn(1.5d0, 0.5d0), 0.250d0, printed)
   call near('DEJDN', dejdn(1.5d0, 0.5d0)**2, 1 - 0.5d0*dejsn(1.5d0, 0.5d0)**2, e)
   call finish('imsl')
end program imsl
