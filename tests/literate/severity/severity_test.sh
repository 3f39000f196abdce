#!/usr/bin/env bash
# severity_test.sh SOURCE: the script plants faults in a copy of a paper of one file, and records which claims they turn.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
unset ONLY
need python3
export PYTHONDONTWRITEBYTECODE=1
cd "$scratch" || exit 1
mkdir -p rod/src rod/paper rod/other
cd rod || exit 1

# A program that says of two claims what its numbers make of them.
cat >src/rod.cpp <<'END'
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
int one() { return 1; }
int two() { return 2; }
int main(int, char** arguments) {
  std::string line, output;
  for (std::ifstream settings(arguments[2]); std::getline(settings, line);)
    if (line.rfind("output=", 0) == 0) output = line.substr(7);
  if (two() == 7) {
    std::puts("rod: two is 7; the last thing registered was value 'one' (src/rod.cpp:4)");
    return 3;
  }
  std::filesystem::create_directories(output + "/generated");
  const auto verdict = [](bool holds) { return holds ? "confirmed" : "refuted"; };
  std::ofstream(output + "/generated/names.json")
      << R"({"claims": {"odd": {"found": ")" << verdict(one() % 2 == 1) << R"("}, "even": {"found": ")"
      << verdict(two() % 2 == 0) << R"("}}, "checks": {"small": {"passed": )" << (two() < 9 ? "true" : "false") << "}}}";
}
END
echo 'int unused() { return 1; }' >src/unused.cpp
echo 'four = 4' >other/other.txt
echo 'side = 3' >case.toml
cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.25)
project(rod LANGUAGES CXX)
add_executable(rod_program src/rod.cpp)
add_custom_target(rod_linked COMMAND sh -c "sha256sum '${CMAKE_SOURCE_DIR}/src/rod.cpp' >rod.compiled" DEPENDS rod_program VERBATIM)
set(rod_OUTPUT "${CMAKE_BINARY_DIR}/rod" CACHE PATH "")
file(WRITE "${CMAKE_BINARY_DIR}/rod.settings" "name=rod
project=rod
root=${CMAKE_SOURCE_DIR}
build=${CMAKE_BINARY_DIR}
program=${CMAKE_BINARY_DIR}/rod_program
document=${CMAKE_SOURCE_DIR}/paper
case=${CMAKE_SOURCE_DIR}/case.toml
faults=${CMAKE_SOURCE_DIR}/faults.toml
output=${rod_OUTPUT}
")
END
cmake -S . -B build -G Ninja >/dev/null

# fault ID BEFORE AFTER [FILE]: an entry of the list.
fault() {
  printf '[[mutant]]\nid = "%s"\nwrong = "%s is wrong"\nfile = "%s"\nbefore = "%s"\nafter = "%s"\n' \
    "$1" "$1" "${4:-src/rod.cpp}" "$2" "$3"
}
list() {
  echo 'computes = ["src", "case.toml"]'
  fault even 'return 1; }' 'return 2; }'
  fault odd 'return 2; }' 'return 3; }'
  fault crash 'return 2; }' 'return 7; }'
  fault large 'return 2; }' 'return 10; }'
  fault broken 'return 2; }' 'return two; }'
  fault elsewhere four five other/other.txt
  fault uncompiled 'return 1' 'return 2' src/unused.cpp
}
plant() { runs python3 "$source_dir/src/literate/scripts/severity" build/rod.settings; }

list >faults.toml
plant
claim 'a paper whose every claim is turned is measured' "$status" -eq 0
claim 'only faults in what is computed count' "$(says '2 claims; 5 of 7 faults are in what computes them')" = yes
claim 'one that does not compile is counted apart' "$(says '4 faults turn 2 of 2 claims; 1 more do not')" = yes
claim 'the record is claim by fault' "$(sed 1d paper/severity.csv)" = 'claim,even,odd,crash,large
even,,refuted,,
odd,refuted,,,
(checks),,,,small
(program),,,rod: two is 7,'
digest() {
  python3 - "$source_dir/src/literate/scripts/severity" "$@" <<'END'
import importlib.machinery, importlib.util, pathlib, sys
loader = importlib.machinery.SourceFileLoader("severity", sys.argv[1])
severity = importlib.util.module_from_spec(importlib.util.spec_from_loader("severity", loader))
loader.exec_module(severity)
print(severity.digest_of_code(pathlib.Path(sys.argv[2]), sys.argv[3:]))
END
}
claim 'its first line has the digest of the code' "$(head -n 1 paper/severity.csv)" = \
  "# $(digest . src case.toml) of src:case.toml"
claim 'the checkout is as it was' "$(grep -c 'two() { return 2; }' src/rod.cpp)" -eq 1
claim 'so is the copy' "$(grep -c 'two() { return 2; }' build/severity/rod/tree/src/rod.cpp)" -eq 1
claim 'what was found is kept' "$(find build/severity/rod/results -name '*.json' | wc -l)" -eq 5
# The C++ that reads the record is tested with the same digest of the same files.
mkdir -p fixed/src
printf 'int a = 1;  // one\n' >fixed/src/a.cpp
printf 'side = 3\n' >fixed/case.toml
claim 'the digest is that which the program computes' "$(digest fixed src case.toml)" = \
  9c72fe8173df2cec29647e97bc78aa0bf5647a4da597a63a528c377d584c3690

rm paper/severity.csv
sed -i 's/"confirmed"/"hushed"/' build/severity/rod/results/*.json
plant
claim 'a run that was stopped goes on with what it found' "$status $(test -e paper/severity.csv && echo yes)" = '0 yes'
rm paper/severity.csv
export ONLY=odd
plant
claim 'one fault alone is told and not recorded' "$status $(says 'turns even') $(ls paper)" = '0 yes '
export ONLY=none
plant
claim 'one that is not there is named' "$status $(says "no fault 'none'")" = '2 yes'
unset ONLY

list | sed '/^id = "odd"/,/^after/s/return 3/return 4/' >faults.toml
plant
claim 'a claim that nothing turns is named' "$status $(says 'claim even: none of 4 planted faults turns it')" = '1 yes'
claim 'so is a fault that turns nothing' "$(says 'fault odd: turns neither claim nor check')" = yes

# refused TEXT: claims that the list is refused.
refused() {
  plant
  claim "a list is refused: $1" "$status $(says "$1")" = '2 yes'
}
{ list && fault gone 'return 9' 'return 8'; } >faults.toml
refused 'stands 0 times'
list | sed 1d >faults.toml
refused 'computes does not name the case case.toml'
list | sed 's/"src", /"source", /' >faults.toml
refused 'computes: there is no source'
echo "data=$PWD/other/other.txt" >>build/rod.settings
list >faults.toml
refused 'other/other.txt is data; faults are planted in code and in the case alone'
echo 'computes = [' >faults.toml
refused 'faults.toml: '
sed -i '/^faults=/d' build/rod.settings
refused 'literate_add_paper names no FAULTS'

finish
