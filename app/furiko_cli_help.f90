! SPDX-License-Identifier: MIT

!> What the commands' tables say to people: help, man page, and the completion of three shells.
module furiko_cli_help
   use furiko, only : furiko_version
   use furiko_cli_io, only : put
   use furiko_cli_options, only : command, option
   use furiko_cli_text, only : replaced
   implicit none
   private
   public :: put_help, put_overview, put_manual, put_bash, put_zsh, put_fish


   !> A terminal's 80, the last of which some leave blank
   integer, parameter :: columns = 79
   character(len=*), parameter :: title = 'elliptic functions and the exact pendulum'


contains


   !> The commands, a line each.
   subroutine put_overview(commands)
      type(command), intent(in) :: commands(:)
      integer :: i

      call put('furiko [COMMAND] [OPTIONS]: ' // title)
      call put('')
      do i = 1, size(commands)
         call put('  ' // commands(i)%name // trim(commands(i)%summary))
      end do
      call put('')
      call put_text('', 'furiko help COMMAND tells more; furiko --version prints the version. Without a ' // &
         'command: table.')
   end subroutine put_overview


   subroutine put_help(usage)
      type(command), intent(in) :: usage
      integer :: i, width

      call put(synopsis(usage))
      call put('')
      call put_text('', trim(usage%about))
      width = 0
      do i = 1, size(usage%options)
         width = max(width, len(form(usage%options(i))))
      end do
      if (width > 0) call put('')
      do i = 1, size(usage%options)
         call put_text('  ' // form(usage%options(i)) // repeat(' ', &
            width - len(form(usage%options(i))) + 2), &
            meaning(usage%options(i)))
      end do
      if (usage%notes /= '') then
         call put('')
         call put_text('', trim(usage%notes))
      end if
      if (usage%example == '') return
      call put('')
      call put('Example:')
      call put('')
      call put('  ' // trim(usage%example))
   end subroutine put_help


   pure function synopsis(usage) result(text)
      type(command), intent(in) :: usage
      character(len=:), allocatable :: text

      text = 'furiko ' // trim(usage%name)
      if (usage%operands /= '') text = text // ' ' // trim(usage%operands)
      if (size(usage%options) > 0) text = text // ' [OPTIONS]'
   end function synopsis


   !> As -o, --output FILE
   pure function form(line) result(text)
      type(option), intent(in) :: line
      character(len=:), allocatable :: text

      text = trim(line%name)
      if (line%letter /= '') text = '-' // line%letter // ', ' // text
      if (line%value /= '') text = text // ' ' // trim(place_holder(line))
   end function form


   !> Choices stand in the text; the name of the value, then, is the first letter of the option's.
   pure function place_holder(line) result(text)
      type(option), intent(in) :: line
      character(len=:), allocatable :: text

      text = trim(line%value)
      if (index(text, '|') > 0) text = achar(iachar(line%name(3:3)) - iachar('a') + iachar('A'))
   end function place_holder


   pure function meaning(line) result(text)
      type(option), intent(in) :: line
      character(len=:), allocatable :: text

      text = trim(line%about)
      if (index(line%value, '|') > 0) then
         if (text /= '') text = text // ': '
         text = text // replaced(trim(line%value), '|', ', ')
      end if
      if (line%default /= '') text = trim(text) // ' (default: ' // trim(line%default) // ')'
   end function meaning


   !> A paragraph in lines of 79 columns, the first behind `head`, the others as far in
   subroutine put_text(head, text)
      character(len=*), intent(in) :: head
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: margin, rest
      integer :: last

      margin = head
      rest = text
      do
         last = len(rest)
         if (width_of(margin // rest) > columns .and. index(rest, ' ') > 1) then
            last = last_fitting(rest, columns - len(margin))
         end if
         call put(trim(margin // rest(:last)))
         margin = repeat(' ', len(head))
         rest = rest(min(last + 2, len(rest) + 1):)
         if (len(rest) == 0) exit
      end do
   end subroutine put_text


   !> Where to cut a line: before the last blank within the width, or the first one
   pure function last_fitting(line, width) result(last)
      character(len=*), intent(in) :: line
      integer, intent(in) :: width
      integer :: last
      integer :: i

      last = index(line, ' ') - 1
      do i = last + 2, len(line)
         if (line(i:i) == ' ' .and. width_of(line(:i - 1)) <= width) last = i - 1
      end do
   end function last_fitting


   !> How many characters a text in UTF-8 has
   pure function width_of(text) result(width)
      character(len=*), intent(in) :: text
      integer :: width
      integer :: i

      width = count([(iachar(text(i:i)) < 128 .or. iachar(text(i:i)) >= 192, i=1, len(text))])
   end function width_of


   !> A page for man, in the macros of man(7).
   subroutine put_manual(commands)
      type(command), intent(in) :: commands(:)
      integer :: i, j

      call put('.TH FURIKO 1 "" "furiko ' // furiko_version // '" "User commands"')
      call put('.SH NAME')
      call put('furiko \- ' // title)
      call put('.SH SYNOPSIS')
      call put('.B furiko')
      call put('[COMMAND] [OPTIONS]')
      call put('.SH COMMANDS')
      do i = 1, size(commands)
         call put('.SS ' // roff(synopsis(commands(i))))
         call put(roff(trim(commands(i)%about)))
         do j = 1, size(commands(i)%options)
            call put('.TP')
            call put('.B ' // roff(form(commands(i)%options(j))))
            call put(roff(meaning(commands(i)%options(j))))
         end do
         if (commands(i)%notes /= '') then
            call put('.PP')
            call put(roff(trim(commands(i)%notes)))
         end if
         if (commands(i)%example == '') cycle
         call put('.PP')
         call put('.EX')
         call put('$ ' // roff(trim(commands(i)%example)))
         call put('.EE')
      end do
      call put('.SH EXIT STATUS')
      call put('0: done. 1: the output could not be written. 2: a bad command line, bad ' // &
         'input, or none that can be read. 3: no gnuplot. 4: this build computes wrong numbers.')
   end subroutine put_manual


   !> Text as roff takes it: what means something to it is written otherwise.
   pure function roff(text) result(safe)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: safe
      integer :: i

      safe = ''
      if (scan(text, '.''') == 1) safe = '\&'
      do i = 1, len(text)
         select case (text(i:i))
         case ('\')
            safe = safe // '\e'
         case ('-')
            safe = safe // '\-'
         case default
            safe = safe // text(i:i)
         end select
      end do
   end function roff


   subroutine put_bash(commands)
      type(command), intent(in) :: commands(:)
      integer :: i, j

      call put('# furiko completion bash: to be read by bash (or put into /etc/bash_completion.d)')
      call put('_furiko() {')
      call put('   local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words=')
      call put('   case "$COMP_CWORD ${COMP_WORDS[1]} $before" in')
      call put("      '1 '*) words='" // all_names(commands) // "' ;;")
      do i = 1, size(commands)
         do j = 1, size(commands(i)%options)
            if (index(commands(i)%options(j)%value, '|') > 0) call put("      *' " // &
               trim(commands(i)%name) // ' ' // trim(commands(i)%options(j)%name) // "') words='" // &
               replaced(trim(commands(i)%options(j)%value), '|', ' ') // "' ;;")
         end do
         call put("      *' " // trim(commands(i)%name) // " '*) words='" // &
            option_names(commands(i)) // "' ;;")
      end do
      call put('   esac')
      call put('   COMPREPLY=($(compgen -W "$words" -- "$word"))')
      call put('   case $before in -o | --output) COMPREPLY=($(compgen -f -- "$word")) ;; esac')
      call put('}')
      call put('complete -F _furiko furiko')
   end subroutine put_bash


   subroutine put_zsh(commands)
      type(command), intent(in) :: commands(:)
      integer :: i, j

      call put('#compdef furiko')
      call put('# furiko completion zsh: a file _furiko in a folder of $fpath')
      call put('if ((CURRENT == 2)); then')
      call put('   local -a names=(')
      do i = 1, size(commands)
         call put("      '" // trim(commands(i)%name) // ':' // replaced(trim(commands(i)%summary), &
            "'", '') // "'")
      end do
      call put('   )')
      call put("   _describe command names")
      call put('   return')
      call put('fi')
      call put('local command=$words[2]')
      call put('shift words')
      call put('((CURRENT--))')
      call put('case $command in')
      do i = 1, size(commands)
         call put('   ' // trim(commands(i)%name) // ') _arguments \')
         do j = 1, size(commands(i)%options)
            call put("      '" // zsh_line(commands(i)%options(j)) // "' \")
         end do
         call put("      '*: :_files' ;;")
      end do
      call put('esac')
   end subroutine put_zsh


   !> As --length[metres]:L:
   pure function zsh_line(line) result(text)
      type(option), intent(in) :: line
      character(len=:), allocatable :: text

      text = trim(line%name) // '[' // described(line) // ']'
      if (line%value == '') return
      text = text // ':' // place_holder(line) // ':'
      if (index(line%value, '|') > 0) text = text // '(' // replaced(trim(line%value), '|', ' ') // ')'
      if (line%value == 'FILE') text = text // '_files'
   end function zsh_line


   subroutine put_fish(commands)
      type(command), intent(in) :: commands(:)
      character(len=:), allocatable :: line
      integer :: i, j

      call put('# furiko completion fish: a file furiko.fish in ~/.config/fish/completions')
      call put('complete -c furiko -f')
      do i = 1, size(commands)
         call put('complete -c furiko -n __fish_use_subcommand -a ' // trim(commands(i)%name) // " -d '" // &
            replaced(trim(commands(i)%summary), "'", '') // "'")
         do j = 1, size(commands(i)%options)
            line = 'complete -c furiko -n "__fish_seen_subcommand_from ' // trim(commands(i)%name) // &
               '" -l ' // trim(commands(i)%options(j)%name(3:))
            if (commands(i)%options(j)%letter /= '') line = line // ' -s ' // commands(i)%options(j)%letter
            if (commands(i)%options(j)%value == 'FILE') then
               line = line // ' -rF'
            else if (commands(i)%options(j)%value /= '') then
               line = line // ' -x'
            end if
            if (index(commands(i)%options(j)%value, '|') > 0) line = line // " -a '" // &
               replaced(trim(commands(i)%options(j)%value), '|', ' ') // "'"
            call put(line // " -d '" // described(commands(i)%options(j)) // "'")
         end do
      end do
   end subroutine put_fish


   !> The names of the commands, a blank between
   pure function all_names(commands) result(text)
      type(command), intent(in) :: commands(:)
      character(len=:), allocatable :: text
      integer :: i

      text = '--help --version'
      do i = 1, size(commands)
         text = text // ' ' // trim(commands(i)%name)
      end do
   end function all_names


   pure function option_names(usage) result(text)
      type(command), intent(in) :: usage
      character(len=:), allocatable :: text
      integer :: i

      text = '--help'
      do i = 1, size(usage%options)
         text = text // ' ' // trim(usage%options(i)%name)
      end do
   end function option_names


   !> What an option is for, up to the first mark that a shell's description has no room or another use for
   pure function described(line) result(text)
      type(option), intent(in) :: line
      character(len=:), allocatable :: text

      text = replaced(line%about(:scan(line%about // ';', ';:[]') - 1), "'", '')
      text = trim(text)
   end function described

end module furiko_cli_help
