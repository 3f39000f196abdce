#!/bin/sh
# On a terminal make tells how far it is and what it skipped; elsewhere it prints what was done and no more.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/shell_test.sh"
# shellcheck source=tests/toolchain/toy_checkout.sh
. "$(dirname "$0")/toy_checkout.sh"
cat >>"$toy/CMakeLists.txt" <<'END_OF_LISTS'
add_custom_command(OUTPUT part1 COMMAND "${CMAKE_COMMAND}" -E touch part1 COMMENT "Building part 1")
add_custom_command(OUTPUT part2 COMMAND "${CMAKE_COMMAND}" -E touch part2 DEPENDS part1 COMMENT "Linking part 2")
add_custom_target(parts DEPENDS part2)
add_dependencies(halfspace-report parts)
END_OF_LISTS

# on_terminal COMMAND: runs it as a terminal would.
on_terminal() {
  cd "$toy" || exit 1
  runs script -qec "$1" /dev/null
}
erase=$(printf '\r\033[K')

on_terminal 'make report'
claim 'the first report is made' "$status" -eq 0
# Fast steps may be told together, and CMake may have found that it has to run once more, which is a step too.
claim 'the compiler is followed' "$(says ' of ')" = yes
claim 'a stage is told while it works' "$(says "${erase}compute …")" = yes
claim 'so is the last' "$(says "${erase}typeset …")" = yes
claim 'what was not asked for is told' "$(says 'skipped   compile, draw: nothing that they read')" = yes

echo 'Another word. \input{tables/t}' >"$toy/report/sections/a.tex"
on_terminal 'make report'
claim 'prose is typeset alone' "$(says 'skipped   configure, compile, compute, draw: nothing that they read has changed')" = yes
claim 'nothing is computed' "$(says 'compute …')" = no

toy_make report
claim 'elsewhere the name of the report is all that is said' "$said" = build/report/report.pdf

printf '%s\n' '\nonsense' >"$toy/report/sections/a.tex"
on_terminal 'make report'
claim 'a failure stays a failure' "$status" -ne 0

finish
