#!/bin/sh
# mutants: the project's own list fits the checkout. On a checkout of two files: what the script prints, and that it
# works only in its own folder.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/shell_test.sh"
unset ONLY

need python3
export PYTHONDONTWRITEBYTECODE=1

runs python3 "$source_dir/src/toolchain/mutants" --check
claim 'every fault of the list has its text once in the checkout' "$status" -eq 0

checkout=$scratch/check\ out
mkdir -p "$checkout/src/toolchain" "$checkout/src/literate/scripts" "$checkout/src/a" "$checkout/tests/mutants" "$checkout/report"
cp "$source_dir/src/toolchain/mutants" "$checkout/src/toolchain"
cp "$source_dir/src/literate/scripts/planted.py" "$checkout/src/literate/scripts"
printf 'one = 1\ntwo = 2\ntwo = 2\nsix = 6\n' >"$checkout/src/a/data.txt"
: >"$checkout/report/ruggiero2001.toml"
# The test notices a change of «one», the report a change of «two», and nothing a change of «six».
cat >"$checkout/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(small LANGUAGES NONE)
enable_testing()
add_test(NAME unit/a/data COMMAND grep -q "one = 1" "${CMAKE_SOURCE_DIR}/src/a/data.txt")
file(WRITE "${CMAKE_BINARY_DIR}/report.settings" "name=report\noutput=${CMAKE_BINARY_DIR}/report\n")
file(WRITE "${CMAKE_BINARY_DIR}/halfspace-report" "#!/bin/sh
test \"$1\" = compute && output=$(sed -n 's/^output=//p' \"$2\") && mkdir -p \"$output/generated\" || exit 2
test $(grep -c 'two = 2' '${CMAKE_SOURCE_DIR}/src/a/data.txt') = 2 || fault='\"claim twos is refuted\"'
echo \"{\\\"faults\\\": [$fault]}\" >\"$output/generated/names.json\"
")
file(CHMOD "${CMAKE_BINARY_DIR}/halfspace-report" PERMISSIONS OWNER_READ OWNER_EXECUTE)
add_custom_target(halfspace-report)
END

# fault ID BEFORE AFTER [LINE]: an entry of the list.
fault() {
  printf '[[mutant]]\nid = "%s"\nwrong = "%s"\nfile = "src/a/data.txt"\nbefore = "%s"\nafter = "%s"\n%s\n' \
    "$1" "$1 is wrong" "$2" "$3" "${4:-}"
}
list=$checkout/tests/mutants/mutants.toml
plant() { runs python3 "$checkout/src/toolchain/mutants"; }

{ fault first 'one = 1' 'one = 2' && fault second 'two = 2' 'two = 3' 'occurrence = 2'; } >"$list"
plant
claim 'faults that are noticed end well' "$status" -eq 0
claim 'the test that noticed is named' "$(says 'red by unit/a/data')" = yes
claim 'the claim that noticed is named' "$(says 'red by report: claim twos')" = yes
claim 'they are counted' "$(says '2 of 2 red')" = yes
claim 'the checkout is as it was' "$(grep -c 'two = 2' "$checkout/src/a/data.txt")" = 2
claim 'so is the copy' "$(grep -c 'two = 2' "$checkout/build/mutants/tree/src/a/data.txt")" = 2

export ONLY=second
plant
claim 'one can be planted alone' "$(says '1 of 1 red')" = yes
export ONLY=none
plant
claim 'one that is not there is named' "$status $(says "no mutant 'none'")" = '2 yes'
unset ONLY

{ fault first 'one = 1' 'one = 2' && fault third 'six = 6' 'six = 7'; } >"$list"
plant
claim 'a fault that survives fails' "$status" -eq 1
claim 'it is named' "$(says 'SURVIVED: third is wrong')" = yes

# refused TEXT ENTRY…: claims that a list with a wrong second entry is refused.
refused() {
  refused_text=$1
  shift
  { fault first 'one = 1' 'one = 2' && "$@"; } >"$list"
  plant
  claim "a list is refused: $refused_text" "$status $(says "$refused_text")" = '2 yes'
  claim "with its line: $refused_text" "$(says 'tests/mutants/mutants.toml:8: ')" = yes
}
refused 'stands 2 times' fault twice 'two = 2' 'two = 3'
refused 'stands 0 times' fault gone 'ten = 10' 'ten = 11'
refused 'occurrence 3 of 2' fault third 'two = 2' 'two = 3' 'occurrence = 3'
refused 'changes nothing' fault same 'six = 6' 'six = 6'
refused 'two of this name' fault first 'six = 6' 'six = 7'
refused 'unknown key' fault third 'six = 6' 'six = 7' 'reason = 1'
refused "there is no test 'unit/b'" fault third 'six = 6' 'six = 7' 'noticed_by = "unit/b"'

printf 'one = 7\n' >"$checkout/src/a/data.txt"
fault red 'one = 7' 'one = 8' 'noticed_by = "unit/a/data"' >"$list"
plant
claim 'what is red without a fault notices none' "$status $(says 'red without any fault')" = '2 yes'

finish
