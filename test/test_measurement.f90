! SPDX-License-Identifier: MIT

!> How far a function is from its references: what the accuracy report prints and the tests judge.
module test_measurement
   implicit none
   private
   public :: measurement, add_points, unpack, name_length


   !> Room for the longest name of a function
   integer, parameter :: name_length = 41

   !> All points of a function in a regime
   type :: measurement
      character(len=name_length) :: name = ''
      character(len=name_length) :: regime = ''
      integer :: points = 0
      !> Errors in ulp, of calls one by one
      real :: largest = -1.0
      double precision :: total = 0.0d0
      !> The same with all points in one array
      real :: largest_of_array = -1.0
      !> Arguments of the largest
      character(len=200) :: worst = ''
   end type measurement


contains


   !> Count points in; `worst` are the arguments of the one with the largest distance.
   subroutine add_points(list, name, regime, distances, distances_of_array, worst)
      type(measurement), allocatable, intent(inout) :: list(:)
      character(len=*), intent(in) :: name
      character(len=*), intent(in) :: regime
      real, intent(in) :: distances(:)
      real, intent(in) :: distances_of_array(:)
      character(len=*), intent(in) :: worst
      integer :: place

      do place = size(list), 1, -1
         if (list(place)%name == name .and. list(place)%regime == regime) exit
      end do
      if (place == 0) then
         list = [list, measurement(name, regime)]
         place = size(list)
      end if
      list(place)%points = list(place)%points + size(distances)
      list(place)%total = list(place)%total + sum(real(distances, kind(0.0d0)))
      list(place)%largest_of_array = max(list(place)%largest_of_array, maxval(distances_of_array))
      if (maxval(distances) > list(place)%largest) then
         list(place)%largest = maxval(distances)
         list(place)%worst = worst
      end if
   end subroutine add_points


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
