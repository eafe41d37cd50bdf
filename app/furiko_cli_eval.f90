! SPDX-License-Identifier: MIT

!> `furiko eval`: any function of the library on rows of arguments from standard input.
module furiko_cli_eval
   use furiko_catalogue, only : catalogue, catalogue_entry, find_entry
   use furiko_cli_arguments, only : argument_reader, value_of
   use furiko_cli_rows, only : evaluate_rows
   use furiko_cli_terminal, only : finish, put, refuse
   implicit none
   private
   public :: eval_command


   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: help = &
      'furiko eval NAME [--kind real32|real64|real128]' // nl // &
      'furiko eval --list' // nl // nl // &
      'The function NAME on rows of arguments read from standard input, one row of results for' // &
      nl // 'each, with digits enough to read it back exactly. Arguments stand apart by blanks, tabs' // &
      nl // 'or commas; inf and nan are numbers; blank lines and lines that begin with # are skipped.' // &
      nl // 'A bad row ends it, with its line number; the rows before it have been answered.' // nl // &
      '--list names the functions, their arguments and results; angles are in radians.' // nl // &
      'Example:' // nl // nl // &
      '  echo 0.25 | furiko eval ellipke_m'


contains


   !> Parse the words that follow `eval`, then answer.
   subroutine eval_command(arguments)
      type(argument_reader), intent(inout) :: arguments
      type(catalogue_entry) :: entry
      character(len=:), allocatable :: kind_name, word

      entry = catalogue_entry('', '', '', '')
      kind_name = 'real64'
      do while (.not. arguments%done())
         word = arguments%word()
         call arguments%advance()
         select case (word)
         case ('-h', '--help')
            call put(help)
            call finish()
            return
         case ('--list')
            call print_list()
            return
         case ('--kind')
            kind_name = value_of('furiko eval', word, arguments)
            if (all(kind_name /= [character(len=7) :: 'real32', 'real64', 'real128'])) then
               call reject("--kind '" // kind_name // "' is none of real32, real64, real128")
            end if
         case default
            if (entry%name /= '') call reject("unknown word '" // word // "'; see furiko eval --help")
            entry = find_entry(word)
            if (entry%name == '') then
               call reject("no function '" // word // "'; furiko eval --list names all")
            end if
         end select
      end do
      if (entry%name == '') call reject('name a function; furiko eval --list names all')
      call evaluate_rows(entry, kind_name)
      call finish()
   end subroutine eval_command


   subroutine print_list()
      integer :: i

      do i = 1, size(catalogue)
         call put(catalogue(i)%name // ' ' // catalogue(i)%arguments // catalogue(i)%results // ' ' // &
            trim(catalogue(i)%about))
      end do
      call finish()
   end subroutine print_list


   subroutine reject(message)
      character(len=*), intent(in) :: message

      call refuse('furiko eval: ' // message)
   end subroutine reject

end module furiko_cli_eval
