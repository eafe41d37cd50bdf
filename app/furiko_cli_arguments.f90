! SPDX-License-Identifier: MIT

!> The words of the command line, one after the other; `--name=value` counts as two words.
module furiko_cli_arguments
   use furiko_cli_terminal, only : refuse
   implicit none
   private
   public :: argument_reader, value_of


   !> Walks the words: `word()` is the one it stands at, `advance` goes to the next.
   type :: argument_reader
      private
      integer :: index = 1
      !> Whether it stands at the value of `--name=value`
      logical :: at_value = .false.
   contains
      procedure :: done
      procedure :: word
      procedure :: advance
   end type argument_reader


contains


   pure function done(self)
      class(argument_reader), intent(in) :: self
      logical :: done

      done = self%index > command_argument_count()
   end function done


   function word(self)
      class(argument_reader), intent(in) :: self
      character(len=:), allocatable :: word
      integer :: equals

      word = argument(self%index)
      equals = split_at(word)
      if (self%at_value) then
         word = word(equals + 1:)
      else if (equals > 0) then
         word = word(:equals - 1)
      end if
   end function word


   subroutine advance(self)
      class(argument_reader), intent(inout) :: self

      if (split_at(argument(self%index)) > 0 .and. .not. self%at_value) then
         self%at_value = .true.
      else
         self%at_value = .false.
         self%index = self%index + 1
      end if
   end subroutine advance


   !> The word that an option of a command takes.
   function value_of(command, option, arguments) result(word)
      character(len=*), intent(in) :: command
      character(len=*), intent(in) :: option
      type(argument_reader), intent(inout) :: arguments
      character(len=:), allocatable :: word

      if (arguments%done()) call refuse(command // ': ' // option // ' needs a value')
      word = arguments%word()
      call arguments%advance()
   end function value_of


   !> Where `--name=value` has its equals sign; 0 for any other word.
   pure function split_at(word) result(equals)
      character(len=*), intent(in) :: word
      integer :: equals

      equals = 0
      if (index(word, '--') == 1) equals = index(word, '=')
   end function split_at


   function argument(i)
      integer, intent(in) :: i
      character(len=:), allocatable :: argument
      integer :: length

      call get_command_argument(i, length=length)
      allocate(character(len=length) :: argument)
      call get_command_argument(i, argument)
   end function argument

end module furiko_cli_arguments
