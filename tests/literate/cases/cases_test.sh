#!/usr/bin/env bash
# cases_test.sh SOURCE: `cases` sets the results of several cases side by side.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
cases=$source_dir/src/literate/scripts/cases
cd "$scratch" || exit 1
named=$(grep -o 'scripts/[a-z]* ' "$source_dir/src/literate/README.md" | sort -u)
for script in $named; do
  runs test -x "$source_dir/src/literate/$script"
  claim "the manual's $script can be run" "$status" -eq 0
done

# a_case NAME EXIT_CODE PRINTED VERDICT: names longer than what a string keeps in itself.
a_case() {
  mkdir -p "$1/generated"
  echo "$2" >"$1/exit_code"
  touch "$1/computed"
  cat >"$1/generated/names.json" <<END
{"values": {"deflection-of-the-free-end": {"number": 1.5, "printed": "$3", "abs_error": 0.3, "below": 0.2, "above": 0.3},
            "title-of-this-case": {"printed": "a"}},
 "claims": {"uniform-load-suffices": {"found": "$4"}}}
END
}
a_case one 0 '1.5 mm' confirmed
a_case two 1 '2.5 mm' refuted
printf 'length = {value = 1, unit = "m"}\nload = 3\n' >one/case.toml
printf 'length = {value = 2, unit = "m"}\nload = 3\n' >two/case.toml

runs "$cases" one two --output cases.csv
claim 'cases are compared without being told what' "$status" -eq 0
name=deflection-of-the-free-end
claim 'each case is a row, with what varies, all numbers, printed, unrounded and with their errors, and all claims' "$(cat cases.csv)" = \
  "case,exit code,parameter length,$name,\"$name, unrounded\",\"$name, abs_error\",\"$name, below\",\"$name, above\",claim uniform-load-suffices
one,0,1 m,1.5 mm,1.5,0.3,0.2,0.3,confirmed
two,1,2 m,2.5 mm,1.5,0.3,0.2,0.3,refuted"

runs python3 -B "$cases" one two --keys title-of-this-case --output cases.csv
claim 'a key that is asked for stands there' "$(cut -d, -f4 cases.csv | tr '\n' ' ')" = 'title-of-this-case a a '

cat >two/case.toml <<'END'
title = 'a "b"'
n = 12
x = 0.1
is_on = true
length = {value = 39.4, unit = "in"}
angles = [10,
  30]
[load.edge]
x = {value = 30e6, unit = "psi"}
[[body]]
name = 'first'
[[body]]
name = 'second'
END
runs python3 -B "$cases" one two --keys title-of-this-case --output cases.csv
claim 'each parameter is one text under its whole key' "$(sed -n '1p;3p' cases.csv)" = 'case,exit code,parameter angles,parameter body.1.name,parameter body.2.name,parameter is_on,parameter length,parameter load,parameter load.edge.x,parameter n,parameter title,parameter x,title-of-this-case,claim uniform-load-suffices
two,1,"[10, 30]",first,second,true,39.4 in,,30000000 psi,12,"a ""b""",0.1,a,refuted'

echo 'not = ' >two/case.toml
runs python3 -B "$cases" one two --output cases.csv
claim 'a case file that cannot be read leaves the others' "$(sed -n 3p cases.csv)" = 'two,1,,,2.5 mm,1.5,0.3,0.2,0.3,refuted'

echo 2 >two/exit_code
runs python3 -B "$cases" one two --output cases.csv
claim 'a case that was computed and whose prose is wrong has its values' "$(sed -n 3p cases.csv)" = 'two,2,,,2.5 mm,1.5,0.3,0.2,0.3,refuted'
rm two/computed
runs python3 -B "$cases" one two --output cases.csv
claim 'one that could not be computed has none of a run before' "$(sed -n 3p cases.csv)" = 'two,2,,,,,,,,'

runs python3 -B "$cases" one two --keys titel --output other.csv
claim 'a key that no case has is refused with 2' "$status $(says "no case has a value 'titel'")" = '2 yes'
claim 'and nothing is written' ! -e other.csv
runs python3 -B "$cases" one three --output other.csv
claim 'a folder that is none of a case is named, with 2' "$status $(says 'three/exit_code')" = '2 yes'

# `case` alone: what it needs is looked for before anything is written.
case=$source_dir/src/literate/scripts/case
runs "$case"
claim 'case without arguments says what it takes' "$status $(says 'case: it takes three arguments, the settings of a paper, a parameter file and a folder')" = '2 yes'
runs "$case" none.settings one/case.toml new
claim 'settings that are not there are named, with 2' "$status $said" = "2 case: there is no file 'none.settings'"
runs "$case" one/case.toml none.toml new
claim 'so is a parameter file' "$status $said" = "2 case: there is no file 'none.toml'"
claim 'and no folder is made' ! -e new

finish
