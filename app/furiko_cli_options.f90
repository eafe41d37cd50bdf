! SPDX-License-Identifier: MIT

!> What a command takes, as a table: its help, the reading of a command line, the completion of the
!> shells and the man page all follow from it.
module furiko_cli_options
   use furiko_cli_io, only : refuse
   use furiko_cli_text, only : replaced, suggestion
   implicit none
   private
   public :: command, command_line, option, word, read_command_line, argument, demand


   !> A line of a command's table
   type :: option
      !> As --length
      character(len=18) :: name = ''
      !> What stands for its value in the help; a|b|c where it is one of these; empty for a switch
      character(len=24) :: value = ''
      !> The value where the option is not given, as it would be typed
      character(len=16) :: default = ''
      character(len=400) :: about = ''
      !> As o for -o
      character(len=1) :: letter = ' '
   end type option


   !> A command: `run` answers a command line
   type :: command
      character(len=12) :: name = ''
      !> A line of the program's help
      character(len=80) :: summary = ''
      !> The words that it takes beside options, as 'A B', and how many at most
      character(len=24) :: operands = ''
      integer :: most_operands = 0
      !> A paragraph above the options, and one below
      character(len=1600) :: about = ''
      character(len=1200) :: notes = ''
      character(len=120) :: example = ''
      type(option), allocatable :: options(:)
      procedure(answer), pointer, nopass :: run => null()
   end type command


   !> A word of the command line and what a message calls it, as 'furiko motion: --length'
   type :: word
      character(len=:), allocatable :: what
      character(len=:), allocatable :: text
   end type word


   !> What was typed behind a command
   type :: command_line
      !> As furiko motion
      character(len=:), allocatable :: name
      type(option), allocatable :: options(:)
      !> Of each option: its value, or that it was given, or no text at all
      type(word), allocatable :: values(:)
      type(word), allocatable :: operands(:)
   contains
      procedure :: given
      procedure :: value
      procedure :: reject
   end type command_line


   abstract interface
      subroutine answer(line)
         import :: command_line
         implicit none
         type(command_line), intent(in) :: line
      end subroutine answer
   end interface


contains


   !> The words from the number `first` on, by the table of a command. An option that is not in it, or is
   !> given twice, or without its value, and a word too many are refused; `asks_help` is all that is
   !> told of a line with -h or --help.
   subroutine read_command_line(usage, first, line, asks_help)
      type(command), intent(in) :: usage
      integer, intent(in) :: first
      type(command_line), intent(out) :: line
      logical, intent(out) :: asks_help
      character(len=:), allocatable :: text
      integer :: i
      logical :: ended

      line%name = 'furiko ' // trim(usage%name)
      allocate(line%options(size(usage%options)), line%values(size(usage%options)), line%operands(0))
      line%options(:) = usage%options
      asks_help = .false.
      ended = .false.
      i = first
      do while (i <= command_argument_count())
         text = argument(i)
         i = i + 1
         asks_help = .not. ended .and. (text == '-h' .or. text == '--help')
         if (asks_help) return
         if (text == '--' .and. .not. ended) then
            ended = .true.
         else if (ended .or. .not. is_option(text)) then
            call add_operand(line, usage, text)
         else
            call read_option(line, text, i)
         end if
      end do
   end subroutine read_command_line


   !> Whether a word is an option: with a - in front, and no number
   pure function is_option(text) result(yes)
      character(len=*), intent(in) :: text
      logical :: yes

      yes = index(text, '-') == 1 .and. len(text) > 1
      if (yes) yes = scan(text(2:2), '.0123456789') == 0
   end function is_option


   subroutine add_operand(line, usage, text)
      type(command_line), intent(inout) :: line
      type(command), intent(in) :: usage
      character(len=*), intent(in) :: text
      type(word), allocatable :: longer(:)
      integer :: i

      if (size(line%operands) == usage%most_operands) call refuse(line%name // ": unknown word '" // text // &
         "'; see " // line%name // ' --help')
      allocate(longer(size(line%operands) + 1))
      do i = 1, size(line%operands)
         longer(i) = line%operands(i)
      end do
      longer(size(longer)) = word(line%name // ': ' // name_of_operand(trim(usage%operands), &
         size(longer)), text)
      call move_alloc(longer, line%operands)
   end subroutine add_operand


   !> B for the second of 'A B'; A for that of 'A [A ...]'
   pure function name_of_operand(operands, which) result(name)
      character(len=*), intent(in) :: operands
      integer, intent(in) :: which
      character(len=:), allocatable :: name
      integer :: blank

      blank = index(operands // ' ', ' ')
      name = operands(:blank - 1)
      if (which > 1 .and. blank < len(operands)) then
         if (operands(blank + 1:blank + 1) /= '[') name = operands(blank + 1:)
      end if
   end function name_of_operand


   !> An option, with its value in the same word behind = or in the next one, of the number `next`
   subroutine read_option(line, text, next)
      type(command_line), intent(inout) :: line
      character(len=*), intent(in) :: text
      integer, intent(inout) :: next
      integer :: equals, i, which

      equals = index(text, '=')
      if (equals == 0 .or. index(text, '--') /= 1) equals = len(text) + 1
      which = place_of(line, text(:equals - 1))
      if (which == 0) call refuse(line%name // ": unknown option '" // text(:equals - 1) // "'; " // &
         suggestion(text(:equals - 1), [(line%options(i)%name, i=1, size(line%options))], 'see ' // &
            line%name // ' --help'))
      if (line%given(trim(line%options(which)%name))) call refuse(line%name // ': ' // &
         text(:equals - 1) // ' is given twice')
      line%values(which)%what = line%name // ': ' // text(:equals - 1)
      if (line%options(which)%value == '') then
         if (equals <= len(text)) call refuse(line%values(which)%what // ' takes no value')
         line%values(which)%text = ''
      else if (equals <= len(text)) then
         line%values(which)%text = text(equals + 1:)
      else
         if (next > command_argument_count()) call refuse(line%values(which)%what // ' needs a value')
         line%values(which)%text = argument(next)
         next = next + 1
      end if
      call check_choice(line%values(which), trim(line%options(which)%value))
   end subroutine read_option


   !> Where there are choices, the value is one of them.
   subroutine check_choice(given, choices)
      type(word), intent(in) :: given
      character(len=*), intent(in) :: choices

      if (index(choices, '|') == 0) return
      if (index('|' // choices // '|', '|' // given%text // '|') > 0 .and. index(given%text, '|') == 0) return
      call refuse(given%what // " '" // given%text // "' is none of " // &
         replaced(choices, '|', ', '))
   end subroutine check_choice


   !> Which option bears a name; 0 if none does.
   pure function place_of(self, name) result(place)
      class(command_line), intent(in) :: self
      character(len=*), intent(in) :: name
      integer :: place

      do place = size(self%options), 1, -1
         if (self%options(place)%name == name) return
         if (self%options(place)%letter /= '' .and. name == '-' // self%options(place)%letter) return
      end do
   end function place_of


   pure function given(self, name)
      class(command_line), intent(in) :: self
      character(len=*), intent(in) :: name
      logical :: given

      given = allocated(self%values(place_of(self, name))%text)
   end function given


   !> An option's value as it was typed, or the table's
   function value(self, name)
      class(command_line), intent(in) :: self
      character(len=*), intent(in) :: name
      type(word) :: value
      integer :: place

      place = place_of(self, name)
      if (allocated(self%values(place)%text)) then
         value = self%values(place)
      else
         value = word(self%name // ': ' // name, trim(self%options(place)%default))
      end if
   end function value


   !> Refuse the command line.
   subroutine reject(self, message)
      class(command_line), intent(in) :: self
      character(len=*), intent(in) :: message

      call refuse(self%name // ': ' // message)
   end subroutine reject


   !> Refuse a value that is outside its range.
   subroutine demand(inside, given, range)
      logical, intent(in) :: inside
      type(word), intent(in) :: given
      character(len=*), intent(in) :: range

      if (.not. inside) call refuse(given%what // ' ' // given%text // ' is outside ' // range)
   end subroutine demand


   function argument(i)
      integer, intent(in) :: i
      character(len=:), allocatable :: argument
      integer :: length

      call get_command_argument(i, length=length)
      allocate(character(len=length) :: argument)
      call get_command_argument(i, argument)
   end function argument

end module furiko_cli_options
