#!/usr/bin/env bash
# make_check_test.sh PROGRAM SOURCE: what a student sees of `make check`, in the instructor's solution of the assignment.
set -euo pipefail
program=$1 source=$2
work=$(mktemp -d "${TMPDIR:-/tmp}/make check XXXXXX")
trap 'rm -rf "$work"' EXIT
unset MAKEFLAGS MAKELEVEL MFLAGS

fail() {
  printf 'make_check_test: %s\n' "$1" >&2
  exit 1
}

"$program" solution --assignment "$source/report/assignment" --source "$source" --output "$work/project" >/dev/null
cd "$work/project"

# The points of each check and their sum, of which the instructor's solution has all.
make >make.log 2>&1 || { cat make.log; fail 'the solution does not compile'; }
make check >check.log 2>&1 || { cat check.log; fail 'the solution does not pass every public check'; }
grep -qx $'2 of 2\tgradient-odd' check.log || { cat check.log; fail 'the points of a check are not shown'; }
grep -qx 'sum: 37 of 37 points; hidden checks decide on the other 63, and these points count as far as those hold' check.log || { cat check.log; fail 'the sum is not shown'; }

# A project that was copied with its build folder builds.
cp -a "$work/project" "$work/a copy"
(cd "$work/a copy" && make >make.log 2>&1) || { cat "$work/a copy/make.log"; fail 'a copy with its build folder does not build'; }
rm -rf "$work/a copy"

# A line that was left over from the search for an error is told, and is no part of the answer.
sed -i 's|^  const double nu = material.poisson;|  std::cout << "nu = " << material.poisson << std::endl;\n&|; 1i#include <iostream>' src/closed_form.cpp
make >make.log 2>&1 || { cat make.log; fail 'the solution does not compile'; }
make check PART=gradient >check.log 2>&1 || { cat check.log; fail 'a program that prints something fails'; }
grep -q 'your program printed "nu = 0.3"' check.log || { cat check.log; fail 'it is not said what the program printed'; }
echo 207e9 0.3 6.9e6 2.54e-4 1e-4 | build/assignment gradient >answer 2>printed
[[ $(wc -l <answer) == 1 ]] || fail 'what the program prints is among its answer'
grep -q '^nu = 0.3$' printed || fail 'what the program prints is lost'
