C     SPDX-License-Identifier: MIT
C
C     A pendulum in Fortran 77, by furiko's externals: its period and its
C     exact motion beside Runge-Kutta steps, and sn, cn, dn of one modulus.
      PROGRAM SWING
      INCLUDE 'furiko_f77.inc'
      EXTERNAL FALL
      INTEGER I, IER, NWRONG
      DOUBLE PRECISION W(96), V(64), T(4), A(4), Y(2), SN(4), CN(4)
      DOUBLE PRECISION DN(4), OMEGA2, R, AK
      COMMON /SYSTEM/ OMEGA2
      DATA T /0.25D0, 0.5D0, 0.75D0, 1.0D0/

C     Does this build of furiko compute right?
      CALL FKTEST(NWRONG)
      IF (NWRONG .NE. 0) STOP 1

C     A rod of 0.25 m, let go at rest at 1 radian
      OMEGA2 = 9.80665D0/0.25D0
      R = FKPER(1.0D0)
      WRITE (*, '(A, F17.15)') 'T/T_h    ', R
      AK = SIN(0.5D0)
      WRITE (*, '(A, F17.15)') '2/pi K   ', FKK(AK)/ASIN(1.0D0)
      CALL FKPSET(W, 96, 0.25D0, 9.80665D0, 1.0D0, 0.0D0, IER)
      IF (IER .NE. 0) STOP 2
      CALL FKPANG(W, 4, T, A)
      Y(1) = 1.0D0
      Y(2) = 0.0D0
      WRITE (*, '(A)') '   t    exactly      by steps'
      DO 10 I = 1, 4
         CALL FKRK4(FALL, 2, T(I) - 0.25D0, 1.0D-2, 25, Y)
         WRITE (*, '(F5.2, 2F13.9)') T(I), A(I), Y(1)
   10 CONTINUE

C     One modulus, many arguments
      CALL FKMSET(V, 64, AK, IER)
      IF (IER .NE. 0) STOP 3
      CALL FKMJAC(V, 4, T, SN, CN, DN)
      WRITE (*, '(A)') '   u       sn          cn          dn'
      DO 20 I = 1, 4
         WRITE (*, '(F5.2, 3F12.9)') T(I), SN(I), CN(I), DN(I)
   20 CONTINUE
      END


C     The angle is Y(1), its rate Y(2).
      SUBROUTINE FALL(T, Y, DY)
      DOUBLE PRECISION T, Y(2), DY(2), OMEGA2
      COMMON /SYSTEM/ OMEGA2
      DY(1) = Y(2)
      DY(2) = -OMEGA2*SIN(Y(1))
      END
