! SPDX-License-Identifier: MIT

!> `furiko eval`: a function of the catalogue on rows of arguments from standard input.
module furiko_cli_eval
   use furiko_catalogue, only : catalogue, catalogue_entry, find_entry
   use furiko_cli_io, only : finish, put
   use furiko_cli_options, only : command, command_line, option, word
   use furiko_cli_request, only : request_for
   use furiko_cli_rows, only : evaluate_rows
   use furiko_cli_sheet, only : format_option
   use furiko_cli_text, only : suggestion
   implicit none
   private
   public :: eval_usage


contains


   function eval_usage() result(usage)
      type(command) :: usage

      usage = command('eval', 'functions of the library on rows of arguments', 'NAME', 1, &
         'The function NAME on rows of arguments read from standard input, one row of results for each, ' // &
         'with digits enough to read it back exactly. Angles are in radians.', &
         'Arguments stand apart by semicolons if the row has one; if not, by commas; if not, by tabs; ' // &
         'if not, by blanks. Nothing between two semicolons, commas or tabs is refused. Numbers have a ' // &
         'decimal point and may stand in quotes; inf and nan are numbers. Blank lines and lines that ' // &
         'begin with # are skipped; the first row may be one of names, which csv and json print for the ' // &
         'columns that pass through. A bad row ends it, with its line and column; the rows before it ' // &
         'have been answered. A line has at most a million characters.', &
         'echo 0.25 | furiko eval ellipke_m', options=[ &
         option('--list', about='the functions, their arguments and results'), &
         option('--kind', 'real32|real64|real128', 'real64', 'of the numbers'), &
         option('--columns', 'LIST', '', 'which arguments and results to print, as phi,m,F (all results)'), &
         format_option], run=eval_command)
   end function eval_usage


   subroutine eval_command(line)
      type(command_line), intent(in) :: line
      type(catalogue_entry) :: entry
      type(word) :: columns, form, kind_name
      integer :: i

      if (line%given('--list')) then
         call print_list()
         return
      end if
      if (size(line%operands) == 0) call line%reject('name a function; furiko eval --list names all')
      entry = find_entry(line%operands(1)%text)
      if (entry%name == '') call line%reject("no function '" // line%operands(1)%text // "'; " // &
         suggestion(line%operands(1)%text, [(catalogue(i)%name, i=1, size(catalogue))], &
         'furiko eval --list names all'))
      columns = line%value('--columns')
      if (line%given('--columns') .and. columns%text == '') call line%reject('--columns names no column')
      form = line%value('--format')
      kind_name = line%value('--kind')
      call evaluate_rows(request_for(entry, form%text, columns%text), kind_name%text)
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

end module furiko_cli_eval
