! SPDX-License-Identifier: MIT

!> Joined texts in a loop that is not counted, or is left by exit, return or cycle: flang 19 and 22 keep
!> each one on the stack until the procedure ends, and end in a segmentation fault (ulimit -s 8192).
!> gfortran prints 100.
!>
!> In furiko: long loops over text are counted ones (app/furiko_cli_table.f90, test/test_notes.f90).
program text_in_a_loop
   implicit none
   character(len=:), allocatable :: text
   integer :: i

   text = repeat('a', 100)
   i = 0
   do while (i < 1000000)
      text = text(2:) // achar(97 + mod(i, 26))
      i = i + 1
   end do
   print '(i0)', len(text)
end program text_in_a_loop
