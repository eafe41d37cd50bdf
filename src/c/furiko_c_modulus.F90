! SPDX-License-Identifier: MIT
#include "../arithmetic/furiko_compiler.inc"

!> One modulus and many u for C: the object lies in the caller's storage, as numbers that mean nothing to
!> anybody else.
module furiko_c_modulus
   use, intrinsic :: iso_c_binding, only : c_double, c_int64_t, c_size_t
   use furiko_modulus, only : modulus, modulus_from_alpha, modulus_from_amplitude, modulus_from_k, &
      modulus_from_m, modulus_from_mc
   implicit none
   private

   integer, parameter :: wp = c_double
   !> Numbers of the storage in C; some are left for what is to come
   integer, parameter :: room = 63
   !> Says in one more that it was made; any bits would do
   integer(c_int64_t), parameter :: made = 7885350463184921939_c_int64_t
   ! How many of an array are worked on at once: the kernels count by default integers
   integer(c_size_t), parameter :: most = 4096


   !> `furiko_modulus` in C
   type, bind(c) :: c_modulus
      real(c_double) :: opaque(room)
      real(c_double) :: tag
   end type c_modulus


contains


   pure subroutine c_from_k(self, k) bind(c, name='furiko_modulus_from_k')
      type(c_modulus), intent(out) :: self
      real(wp), intent(in), value :: k

      call store(modulus_from_k(k), self)
   end subroutine c_from_k


   pure subroutine c_from_m(self, m) bind(c, name='furiko_modulus_from_m')
      type(c_modulus), intent(out) :: self
      real(wp), intent(in), value :: m

      call store(modulus_from_m(m), self)
   end subroutine c_from_m


   pure subroutine c_from_mc(self, mc) bind(c, name='furiko_modulus_from_mc')
      type(c_modulus), intent(out) :: self
      real(wp), intent(in), value :: mc

      call store(modulus_from_mc(mc), self)
   end subroutine c_from_mc


   pure subroutine c_from_alpha(self, alpha) bind(c, name='furiko_modulus_from_alpha')
      type(c_modulus), intent(out) :: self
      real(wp), intent(in), value :: alpha

      call store(modulus_from_alpha(alpha), self)
   end subroutine c_from_alpha


   pure subroutine c_from_amplitude(self, amplitude) bind(c, name='furiko_modulus_from_amplitude')
      type(c_modulus), intent(out) :: self
      real(wp), intent(in), value :: amplitude

      call store(modulus_from_amplitude(amplitude), self)
   end subroutine c_from_amplitude


   pure subroutine c_complement(self, complement) bind(c, name='furiko_modulus_complement')
      type(c_modulus), intent(in) :: self
      type(c_modulus), intent(out) :: complement
      type(modulus) :: p

      p = stored(self)
      call store(p%complement(), complement)
   end subroutine c_complement


   pure function c_size() result(bytes) bind(c, name='furiko_modulus_size')
      integer(c_size_t) :: bytes
      type(c_modulus) :: self

      bytes = storage_size(self, c_size_t)/8
   end function c_size


   pure function c_k(self) result(f) bind(c, name='furiko_modulus_k')
      type(c_modulus), intent(in) :: self
      real(wp) :: f
      type(modulus) :: p

      p = stored(self)
      f = p%k()
   end function c_k


   pure function c_m(self) result(f) bind(c, name='furiko_modulus_m')
      type(c_modulus), intent(in) :: self
      real(wp) :: f
      type(modulus) :: p

      p = stored(self)
      f = p%m()
   end function c_m


   pure function c_mc(self) result(f) bind(c, name='furiko_modulus_mc')
      type(c_modulus), intent(in) :: self
      real(wp) :: f
      type(modulus) :: p

      p = stored(self)
      f = p%mc()
   end function c_mc


   pure function c_ellipk(self) result(f) bind(c, name='furiko_modulus_ellipk')
      type(c_modulus), intent(in) :: self
      real(wp) :: f
      type(modulus) :: p

      p = stored(self)
      f = p%ellipk()
   end function c_ellipk


   pure function c_ellipe(self) result(f) bind(c, name='furiko_modulus_ellipe')
      type(c_modulus), intent(in) :: self
      real(wp) :: f
      type(modulus) :: p

      p = stored(self)
      f = p%ellipe()
   end function c_ellipe


   pure function c_quarter_period(self) result(f) bind(c, name='furiko_modulus_quarter_period')
      type(c_modulus), intent(in) :: self
      real(wp) :: f
      type(modulus) :: p

      p = stored(self)
      f = p%quarter_period()
   end function c_quarter_period


   pure function c_nome(self) result(f) bind(c, name='furiko_modulus_nome')
      type(c_modulus), intent(in) :: self
      real(wp) :: f
      type(modulus) :: p

      p = stored(self)
      f = p%nome()
   end function c_nome


   pure subroutine c_jacobi(self, u, sn, cn, dn) bind(c, name='furiko_modulus_jacobi')
      type(c_modulus), intent(in) :: self
      real(wp), intent(in), value :: u
      real(wp), intent(out) :: sn, cn, dn
      type(modulus) :: p

      p = stored(self)
      call p%jacobi(u, sn, cn, dn)
   end subroutine c_jacobi


   pure subroutine c_jacobi_v(self, count, u, sn, cn, dn) bind(c, name='furiko_modulus_jacobi_v')
      type(c_modulus), intent(in) :: self
      integer(c_size_t), intent(in), value :: count
      real(wp), intent(in) :: u(count)
      real(wp), dimension(count), intent(out) :: sn, cn, dn
      type(modulus) :: p
      integer(c_size_t) :: first, last

      p = stored(self)
      do first = 1, count, most
         last = min(first + most - 1, count)
         call p%jacobi(u(first:last), sn(first:last), cn(first:last), dn(first:last))
      end do
   end subroutine c_jacobi_v


   pure function c_am(self, u) result(f) bind(c, name='furiko_modulus_am')
      type(c_modulus), intent(in) :: self
      real(wp), intent(in), value :: u
      real(wp) :: f
      type(modulus) :: p

      p = stored(self)
      f = p%am(u)
   end function c_am


   pure subroutine c_am_v(self, count, u, f) bind(c, name='furiko_modulus_am_v')
      type(c_modulus), intent(in) :: self
      integer(c_size_t), intent(in), value :: count
      real(wp), intent(in) :: u(count)
      real(wp), intent(out) :: f(count)
      type(modulus) :: p
      integer(c_size_t) :: first, last

      p = stored(self)
      do first = 1, count, most
         last = min(first + most - 1, count)
         f(first:last) = p%am(u(first:last))
      end do
   end subroutine c_am_v


   pure function c_epsilon(self, u) result(f) bind(c, name='furiko_modulus_epsilon')
      type(c_modulus), intent(in) :: self
      real(wp), intent(in), value :: u
      real(wp) :: f
      type(modulus) :: p

      p = stored(self)
      f = p%epsilon(u)
   end function c_epsilon


   pure subroutine c_epsilon_v(self, count, u, f) bind(c, name='furiko_modulus_epsilon_v')
      type(c_modulus), intent(in) :: self
      integer(c_size_t), intent(in), value :: count
      real(wp), intent(in) :: u(count)
      real(wp), intent(out) :: f(count)
      type(modulus) :: p
      integer(c_size_t) :: first, last

      p = stored(self)
      do first = 1, count, most
         last = min(first + most - 1, count)
         f(first:last) = p%epsilon(u(first:last))
      end do
   end subroutine c_epsilon_v


   !> The object's bits into the caller's storage. A room too small is found by strict compilers.
   pure subroutine store(p, self)
      type(modulus), intent(in) :: p
      type(c_modulus), intent(out) :: self
      integer, parameter :: used = ceiling(storage_size(p)/64.0)
      ! Not an array, which would be allocated
      type :: image
         real(c_double) :: numbers(used)
      end type image
      type(image) :: bits

      bits = transfer(p, bits)
      self%opaque(:used) = bits%numbers
      self%opaque(used + 1:) = 0.0_wp
      self%tag = transfer(made, 1.0_wp)
   end subroutine store


   !> And back; what was never made says NaN, as in Fortran
   pure function stored(self) result(p)
      type(c_modulus), intent(in) :: self
      type(modulus) :: p

      if (transfer(self%tag, made) == made) p = transfer(self, p)
   end function stored

end module furiko_c_modulus
! rooms: 3759241635
