#!/bin/sh
# SPDX-License-Identifier: MIT
# Tests src/testdrive.f90 with plain sh and a compiler, no fpm: FC=gfortran FFLAGS= sh self-test.sh
# SRC=FILE tests another version of it: break a copy and see this fail.
here=$(cd "$(dirname "$0")" && pwd) || exit 2
fc=${FC:-gfortran}
src=${SRC:-$here/src/testdrive.f90}
case $src in /*) ;; *) src=$(pwd)/$src ;; esac
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 2' HUP INT TERM
cd "$work" || exit 2
passed=0 failed=0

ok() { # name, result of a command
    if [ "$2" -eq 0 ]; then passed=$((passed + 1)); else
        failed=$((failed + 1)); echo "NOT OK $1"; sed 's/^/  | /' log; fi
}
run() { # runner's arguments
    ./runner "$@" >log 2>&1; code=$?
}
succeeds() { [ "$code" -eq 0 ]; ok "$1" $?; }
fails() { [ "$code" -ne 0 ]; ok "$1" $?; }
prints() { grep -Fqx -e "$2" log; ok "$1: prints '$2'" $?; }
lacks() { ! grep -Fq -e "$2" log; ok "$1: does not print '$2'" $?; }

strict=
case $("$fc" --version 2>/dev/null) in "GNU Fortran"*) strict="-std=f2008 -pedantic -Wall -Wextra -Werror" ;; esac
# The words of strict and FFLAGS are separate options
"$fc" $strict ${FFLAGS-} -c "$src" -o testdrive.o >log 2>&1; ok "compiles without a warning" $?
for program in verdicts runner; do
    "$fc" ${FFLAGS-} "$here/self-test/$program.f90" testdrive.o -o $program >log 2>&1; ok "$program compiles" $?
done
if [ "$failed" -gt 0 ]; then echo "$passed passed, $failed failed"; exit 1; fi

./verdicts " two words " "" >log 2>&1; ok "verdicts" $?
count=$(sed -n 's/^verdicts: \([0-9]*\) passed, 0 failed$/\1/p' log)
count=${count:-0}
[ "$count" -ge 150 ]; ok "verdicts: all were given" $?

run; succeeds "good suite"
prints good "  Starting passes ... (1/4)"
prints good "       ... passes [PASSED]"
prints good "       ... fails-as-it-should [EXPECTED FAIL]"
prints good "       ... skips [SKIPPED]"
prints good "       ... skips-too [SKIPPED]"
prints good "  Message: nothing to run on"
prints good "stat 0"

run bad; fails "bad suite"
prints bad "suite 3"
prints bad "       ... passes [PASSED]"
prints bad "       ... fails [FAILED]"
prints bad "  Message: one is not two"
prints bad "       ... passes-as-it-should-not [UNEXPECTED PASS]"
prints bad "       ... fails-first-only [FAILED]"
prints bad "  Message: the first"
lacks bad "the second"
prints bad "       ... skips [SKIPPED]"
prints bad "stat 3"

run bad fails; fails "one failing test"
prints "bad fails" "test 2"
prints "bad fails" "       ... fails [FAILED]"
lacks "bad fails" "[PASSED]"
prints "bad fails" "stat 1"

run bad passes; succeeds "one passing test of a bad suite"
prints "bad passes" "stat 0"
run good skips; succeeds "one skipped test"
prints "good skips" "stat 0"

run good nosuch; fails "unknown test"
prints "good nosuch" "test 0"
prints "good nosuch" "  - fails-as-it-should"
prints "good nosuch" "stat -2147483647"

run nosuch; fails "unknown suite"
prints nosuch "suite 0"

run none; succeeds "empty suite"
run lost; fails "a failure lost by the test"
lacks lost "[PASSED]"

passed=$((passed + count))
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
