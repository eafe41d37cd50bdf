! SPDX-License-Identifier: MIT

!> How far a function is from its references: what the accuracy report prints and the tests judge.
module test_measurement
   implicit none
   private
   public :: measurement, add_point, unpack


   !> All points of a function in a regime
   type :: measurement
      character(len=16) :: name = ''
      character(len=16) :: regime = ''
      integer :: points = 0
      !> Errors in ulp
      real :: largest = -1.0
      double precision :: total = 0.0d0
      !> Arguments of the largest
      character(len=200) :: worst = ''
   end type measurement


contains


   !> Count a point in; `is_worst` tells whether its arguments are to be kept in `list(place)`.
   subroutine add_point(list, name, regime, distance, place, is_worst)
      type(measurement), allocatable, intent(inout) :: list(:)
      character(len=*), intent(in) :: name
      character(len=*), intent(in) :: regime
      real, intent(in) :: distance
      integer, intent(out) :: place
      logical, intent(out) :: is_worst

      do place = size(list), 1, -1
         if (list(place)%name == name .and. list(place)%regime == regime) exit
      end do
      if (place == 0) then
         list = [list, measurement(name, regime)]
         place = size(list)
      end if
      list(place)%points = list(place)%points + 1
      list(place)%total = list(place)%total + distance
      is_worst = distance > list(place)%largest
      list(place)%largest = max(list(place)%largest, distance)
   end subroutine add_point


   !> Unpack test/data/NAME.dat.gz and open it.
   subroutine unpack(name, folder, unit)
      character(len=*), intent(in) :: name
      !> Where there is room for the text
      character(len=*), intent(in) :: folder
      integer, intent(out) :: unit
      character(len=:), allocatable :: text
      integer :: code

      text = folder // '/' // name // '.dat'
      call execute_command_line('gzip -dc test/data/' // name // '.dat.gz >' // text, exitstat=code)
      if (code /= 0) error stop 'gzip failed'
      open(newunit=unit, file=text, status='old', action='read')
   end subroutine unpack

end module test_measurement
