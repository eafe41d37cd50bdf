C     SPDX-License-Identifier: MIT
C
C     Every external of furiko from Fortran 77: the functions against
C     test/data/names.dat (NAMES is by make_check.py), a modulus and a
C     motion in W, steps with an EXTERNAL.
      PROGRAM CHECK
      INTEGER NBAD, NALL
      COMMON /COUNTS/ NBAD, NALL
      NBAD = 0
      NALL = 0
      CALL FKTEST(NBAD)
      CALL NAMES
      CALL MODLUS
      CALL MOTION
      CALL STEPS
      WRITE (*,*) NALL, ' checks, ', NBAD, ' faults'
      IF (NBAD .NE. 0 .OR. NALL .LT. 430) STOP 1
      END


C     One modulus, many U; sizes and marks
      SUBROUTINE MODLUS
      INCLUDE 'furiko_f77.inc'
      INTEGER I, IER
      DOUBLE PRECISION W(64), V(7), U(5000), SN(5000), CN(5000)
      DOUBLE PRECISION DN(5000), S, C, D
      DO 10 I = 1, 5000
         U(I) = 0.01D0*I
   10 CONTINUE
      DO 20 I = 1, 64
         W(I) = 0.0D0
   20 CONTINUE
      CALL FKMJAC(W, 1, U, SN, CN, DN)
      CALL TRUE('not filled', SN(1) .NE. SN(1))
      CALL FKMSEM(W, 63, 0.36D0, IER)
      CALL TRUE('W too small', IER .EQ. 1)
      CALL FKMGET(W, V)
      CALL TRUE('nothing written', V(2) .NE. V(2))
      CALL FKMSEM(W, 64, 0.36D0, IER)
      CALL TRUE('W is enough', IER .EQ. 0)
      CALL FKMGET(W, V)
      CALL NEAR('k', V(1), 0.6D0)
      CALL NEAR('m', V(2), 0.36D0)
      CALL NEAR('mc', V(3), 0.64D0)
      CALL NEAR('K', V(4), FKK(0.6D0))
      CALL NEAR('E', V(5), FKE(0.6D0))
      CALL NEAR('quarter', V(6), FKK(0.6D0))
      CALL NEAR('nome', V(7), FKQ(0.6D0))
      CALL FKMJAC(W, 5000, U, SN, CN, DN)
      CALL FKJCM(U(4999), 0.36D0, S, C, D)
      CALL NEAR('FKMJAC', SN(4999), S)
      CALL NEAR('FKMJAC', CN(4999), C)
      CALL NEAR('FKMJAC', DN(4999), D)
      CALL FKMAM(W, 5000, U, SN)
      CALL NEAR('FKMAM', SN(4999), FKAMM(U(4999), 0.36D0))
      CALL FKMEP(W, 5000, U, SN)
      CALL NEAR('FKMEP', SN(4999), FKEPM(U(4999), 0.36D0))
C     The same modulus by its other names
      CALL FKMSET(W, 64, 0.6D0, IER)
      CALL FKMGET(W, V)
      CALL NEAR('FKMSET', V(3), 0.64D0)
      CALL FKMSEC(W, 64, 0.64D0, IER)
      CALL FKMGET(W, V)
      CALL NEAR('FKMSEC', V(1), 0.6D0)
      CALL FKMSEA(W, 64, ASIN(0.6D0), IER)
      CALL FKMGET(W, V)
      CALL NEAR('FKMSEA', V(2), 0.36D0)
      END


C     The README's pendulum
      SUBROUTINE MOTION
      INCLUDE 'furiko_f77.inc'
      INTEGER I, IER
      DOUBLE PRECISION W(96), V(4), T(2), X(2)
      DO 10 I = 1, 96
         W(I) = 0.0D0
   10 CONTINUE
      T(1) = 0.0D0
      T(2) = 0.1D0
      CALL FKPANG(W, 2, T, X)
      CALL TRUE('not filled', X(1) .NE. X(1))
      CALL FKPSET(W, 95, 0.25D0, 9.80665D0, 1.0D0, 0.0D0, IER)
      CALL TRUE('W too small', IER .EQ. 1)
      CALL FKPSET(W, 96, 0.25D0, 9.80665D0, 1.0D0, 0.0D0, IER)
      CALL TRUE('W is enough', IER .EQ. 0)
      CALL FKPGET(W, V)
      CALL NEAR('period', V(1), 1.069751469668781D0)
      CALL NEAR('amplitude', V(2), 1.0D0)
      CALL NEAR('energy', V(3), -39.2266D0*COS(1.0D0))
      CALL TRUE('no slack', V(4) .NE. V(4))
      CALL FKPANG(W, 2, T, X)
      CALL NEAR('start', X(1), 1.0D0)
      CALL NEAR('FKPANG', X(2), 0.837997725111338D0)
      CALL FKPRAT(W, 1, T(2), X)
C     Energy stays.
      CALL NEAR('FKPRAT', 0.5D0*X(1)**2
     +   - 39.2266D0*COS(0.837997725111338D0), V(3))
      CALL FKPTEN(W, 1, T, X)
      CALL NEAR('FKPTEN', X(1), COS(1.0D0))
      X(1) = 0.0D0
      CALL FKPTIM(W, 1, X, T)
      CALL NEAR('FKPTIM', T(1), 0.25D0*V(1))
      END


C     A harmonic oscillator: cosine, by three methods
      SUBROUTINE STEPS
      EXTERNAL RATES, ACC
      DOUBLE PRECISION Y(2), X(1), V(1)
      Y(1) = 1.0D0
      Y(2) = 0.0D0
      CALL FKRK4(RATES, 2, 0.0D0, 1.0D-3, 1000, Y)
      CALL TRUE('FKRK4', ABS(Y(1) - COS(1.0D0)) .LT. 1.0D-13)
      X(1) = 1.0D0
      V(1) = 0.0D0
      CALL FKVERL(ACC, 1, 1.0D-3, 1000, X, V)
      CALL TRUE('FKVERL', ABS(X(1) - COS(1.0D0)) .LT. 1.0D-7)
      CALL TRUE('FKVERL', ABS(X(1) - COS(1.0D0)) .GT. 1.0D-10)
      X(1) = 1.0D0
      V(1) = 0.0D0
      CALL FKFRUT(ACC, 1, 1.0D-3, 1000, X, V)
      CALL TRUE('FKFRUT', ABS(X(1) - COS(1.0D0)) .LT. 1.0D-12)
      END

      SUBROUTINE RATES(T, Y, DY)
      DOUBLE PRECISION T, Y(2), DY(2)
      DY(1) = Y(2)
      DY(2) = -Y(1)
      END

      SUBROUTINE ACC(X, A)
      DOUBLE PRECISION X(1), A(1)
      A(1) = -X(1)
      END


C     To 16 units in the last place, as C's functions
      SUBROUTINE NEAR(WHAT, X, Y)
      CHARACTER*(*) WHAT
      DOUBLE PRECISION X, Y
      CALL TRUE(WHAT, ABS(X - Y) .LE. 16.0D0*2.0D0**(-52)*ABS(Y))
      END

      SUBROUTINE NEARS(WHAT, X, Y)
      CHARACTER*(*) WHAT
      REAL X, Y
      CALL TRUE(WHAT, ABS(X - Y) .LE. 16.0*2.0**(-23)*ABS(Y))
      END

      SUBROUTINE TRUE(WHAT, GOOD)
      CHARACTER*(*) WHAT
      LOGICAL GOOD
      INTEGER NBAD, NALL
      COMMON /COUNTS/ NBAD, NALL
      NALL = NALL + 1
      IF (GOOD) RETURN
      NBAD = NBAD + 1
      WRITE (*,*) 'wrong: ', WHAT
      END
