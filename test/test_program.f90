! SPDX-License-Identifier: MIT

!> Runs the program that fpm built beside the tests, and brings back what it said.
module test_program
   implicit none
   private
   public :: run_program, run_shell, run_inside, work, line_count, test_folder, contents


contains


   !> Run `furiko` with arguments (shell text, redirections too) and read its two outputs.
   subroutine run_program(arguments, output, errors, code)
      character(len=*), intent(in) :: arguments
      character(len=:), allocatable, intent(out) :: output
      character(len=:), allocatable, intent(out) :: errors
      integer, intent(out) :: code

      call run_shell('furiko ' // arguments, output, errors, code)
   end subroutine run_program


   !> Run a shell command, to which `furiko` is the program under test.
   subroutine run_shell(command, output, errors, code)
      character(len=*), intent(in) :: command
      character(len=:), allocatable, intent(out) :: output
      character(len=:), allocatable, intent(out) :: errors
      integer, intent(out) :: code
      character(len=:), allocatable :: folder, out_file, error_file
      integer :: ignored

      folder = test_folder()
      out_file = folder // '/program.out'
      error_file = folder // '/program.err'
      ! Asked for since flang stops at a command's own exit code otherwise
      ! allow(C181)
      call execute_command_line('furiko() { ' // folder // '/../app/furiko "$@"; }; { ' // command &
         // '; } >' // out_file // ' 2>' // error_file // ' </dev/null', exitstat=code, &
         cmdstat=ignored)
      output = contents(out_file)
      errors = contents(error_file)
   end subroutine run_shell


   !> Run a shell command in a new folder; its output ends with what lies there then.
   subroutine run_inside(command, output, errors, code)
      character(len=*), intent(in) :: command
      character(len=:), allocatable, intent(out) :: output
      character(len=:), allocatable, intent(out) :: errors
      integer, intent(out) :: code

      call run_shell('rm -rf ' // work() // '; mkdir ' // work() // '; program=$(realpath ' // &
         test_folder() // '/../app/furiko); furiko() { "$program" "$@"; }; cd ' // work() // '; ' // &
         command // '; code=$?; ls -A; (exit $code)', output, errors, code)
   end subroutine run_inside


   !> A folder for files beside the test program
   function work()
      character(len=:), allocatable :: work

      work = test_folder() // '/files'
   end function work


   !> Where the running test program lies: build/COMPILER_HASH/test
   function test_folder() result(folder)
      character(len=:), allocatable :: folder
      integer :: length

      call get_command_argument(0, length=length)
      allocate(character(len=length) :: folder)
      call get_command_argument(0, folder)
      folder = folder(:index(folder, '/', back=.true.) - 1)
   end function test_folder


   function contents(file)
      character(len=*), intent(in) :: file
      character(len=:), allocatable :: contents
      integer :: length, unit

      open(newunit=unit, file=file, access='stream', form='unformatted', status='old', action='read')
      inquire(unit, size=length)
      allocate(character(len=length) :: contents)
      read(unit) contents
      close(unit)
   end function contents


   pure function line_count(text)
      character(len=*), intent(in) :: text
      integer :: line_count
      integer :: i

      line_count = count([(text(i:i) == new_line('a'), i=1, len(text))])
   end function line_count

end module test_program
