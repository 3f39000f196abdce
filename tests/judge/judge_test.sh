#!/bin/bash
# judge_test.sh SOURCE JUDGE: the command line of a judge, with the toy assignment's checks and programs in the shell.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/../toolchain/shell_test.sh"
judge=$2
# shellcheck disable=SC2016  # for the shell that is the student's program
right='while read -r task a b; do case $task in square) awk "BEGIN { print $a * $a }" ;; sum) awk "BEGIN { print $a + $b }" ;; *) echo 1 2 ;; esac; done'
wrong='while read -r task; do echo 1; done'

runs "$judge" --check square-even -- sh -c "$right"
claim 'a check that holds says nothing' "$status$said" = 0
runs "$judge" --check cube-agrees -- sh -c "$wrong"
claim 'a check that does not hold says what does not' "$status$said" = '1cube-agrees: 0 % of the check holds; the cube is not x times your square'

runs "$judge" --exercise sum --public --student ada -- sh -c "$right"
claim 'the public checks of an exercise are asked apart' "$(printf '%s' "$said" | cut -f 1,2 | head -n 1)" = $'sum-commutes\t1'
claim 'how many questions were answered is told' "$(printf '%s' "$said" | tail -n 1 | cut -f 1,3)" = $'lost\t2'
runs "$judge" --exercise sum --hidden -- sh -c "$wrong"
claim 'so are the hidden ones' "$(printf '%s' "$said" | head -n 1)" = $'sum-right\t0\tthe sum is wrong'

runs "$judge" --numbers --student ada
claim 'numbers are those of the student' "$said" = 'young1 3 Pa'

runs "$judge" --exercise sum --hidden
claim 'without a program nothing is judged' "$status$said" = '3judge: there is no program after --'
runs "$judge" --check square-right -- true
claim 'a hidden check is none that can be run alone' "$status$said" = '3judge: there is no public check square-right'
runs "$judge" --exercise sum --hidden --salt-file "$scratch/none" -- true
claim 'a salt that is not there is no empty salt' "$status$said" = '3judge: --salt-file: there is no salt'
finish
