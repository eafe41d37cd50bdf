module furiko_pendulum_stub
use, intrinsic :: iso_fortran_env, only: wp=>real64
type :: pendulum
real(wp)::length=1,gravity=9.80665_wp
contains
procedure :: small_period
end type
contains
function small_period(self)
class(pendulum),intent(in)::self
real(wp)::small_period
small_period=8*atan(1d0)*sqrt(self%length/self%gravity)
end function
end module
