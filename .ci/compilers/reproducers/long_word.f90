! SPDX-License-Identifier: MIT

!> List-directed input of a word longer than its variable: the rest of it is to be skipped (Fortran
!> 2018, 13.10.3.1), but flang 19 reads it as the next number: `towards- 1.0`. Right, `towards- 2.5`, in
!> gfortran and in flang 22.
!>
!> In furiko: the references' words are read into variables with room for all of them.
program long_word
   implicit none
   character(len=13) :: line
   character(len=8) :: word
   real :: x

   line = 'towards-1 2.5'
   read(line, *) word, x
   print '(a, f4.1)', word, x
end program long_word
