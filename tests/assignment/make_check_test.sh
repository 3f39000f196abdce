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
grep -qx 'sum: 35 of 35 points; hidden checks and your tests decide on the other 65, and these points count as far as the hidden checks hold' check.log || { cat check.log; fail 'the sum is not shown'; }

# Their own tests run with their own function, and it is said which of their checks do not hold.
grep -qx $'influence-tests\tyour function passes' check.log || { cat check.log; fail 'the own tests are not run'; }
sed -i.right 's/k = std::abs(k);//' src/influence.cpp
make >make.log 2>&1 || { cat make.log; fail 'the solution does not compile'; }
if make check PART=influence >check.log 2>&1; then fail 'a function that fails the own tests is no failure'; fi
grep -qx $'influence-tests\tyour function fails' check.log || { cat check.log; fail 'it is not said that the own tests fail'; }
grep -qx $'\tline [0-9]*: the same on both sides' check.log || { cat check.log; fail 'it is not said which check fails'; }
make check PART=gradient >check.log 2>&1 || { cat check.log; fail 'another exercise fails with the own tests'; }
cp src/influence.cpp.right src/influence.cpp

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

# The numbers of the report have digits that hold: a grid eight times as fine moves none by more than a unit of the last one.
# numbers_of: prints what the report says of half-width and approach, in millimetres.
numbers_of() {
  make >make.log 2>&1 || { cat make.log; fail 'the solution does not compile'; }
  mkdir -p numbers
  build/figures numbers 2>warnings >/dev/null
  sed -n 's/^.newcommand.*{\([0-9.]*\).*/\1/p' numbers/numbers.tex
}
mapfile -t coarse < <(numbers_of)
sed -i.nominal 's/{"nodes", 91.0}/{"nodes", 721.0}/; s/{"spacing", 7.6e-06}/{"spacing", 9.5e-07}/' provided/variant_of_this_handout.hpp
mapfile -t fine < <(numbers_of)
mv provided/variant_of_this_handout.hpp.nominal provided/variant_of_this_handout.hpp
touch provided/variant_of_this_handout.hpp
for i in 0 1; do
  [[ ${#fine[i]} -gt ${#coarse[i]} ]] || fail "a finer grid confirms no more digits than ${coarse[i]}: ${fine[i]}"
  python3 -c 'import decimal, sys
coarse, fine = map(decimal.Decimal, sys.argv[1:])
sys.exit(abs(coarse - fine) > decimal.Decimal(1).scaleb(coarse.as_tuple().exponent))' "${coarse[i]}" "${fine[i]}" ||
    fail "${coarse[i]} has a digit that a finer grid does not confirm: ${fine[i]}"
done

# A half-width that is wrong by a part of the spacing loses digits; one that the spacing alone decides has none, and it is said.
sed -i.right 's/^\( *\)contact.half_width = \(.*\);$/\1contact.half_width = \2 + grid.spacing;/' src/contact_solver.cpp
mapfile -t spoilt < <(numbers_of)
[[ ${#spoilt[0]} -lt ${#coarse[0]} ]] || fail "${spoilt[0]} has as many digits as ${coarse[0]}"
cp src/contact_solver.cpp.right src/contact_solver.cpp
sed -i 's/^\( *\)contact.half_width = \(.*\);$/\1contact.half_width = 1e-9 \/ grid.spacing;/' src/contact_solver.cpp
numbers_of >/dev/null
grep -qF 'figures: half the spacing confirms no digit of \halfwidth' warnings || { cat warnings; fail 'it is not said that no digit holds'; }
