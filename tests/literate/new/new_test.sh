#!/usr/bin/env bash
# new_test.sh SOURCE PROGRAM: what `literate new` writes, and what it refuses.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
literate=$2
cd "$scratch" || exit 1

runs "$literate" new rod
claim 'a paper is written' "$status" -eq 0
claim 'it says how to go on' "$said" = 'rod: cd there and run make'
claim 'it has all files of the template' "$(find rod -type f | wc -l)" -eq \
  "$(find "$source_dir/src/literate/template" -type f | wc -l)"
claim 'its files bear its name' -e rod/paper/rod.tex
claim 'their text does, too' "$(grep -c 'literate_add_paper(NAME rod PROGRAM rod_program' rod/CMakeLists.txt)" -eq 1
claim "the template's own name is nowhere" -z "$(grep -rl mypaper rod; find rod -name '*mypaper*')"
claim 'nothing lies beside it' "$(ls -A)" = rod
run_yaml='import sys, yaml; print(*yaml.safe_load(open(sys.argv[1]))["jobs"])'
runs /usr/bin/python3 -c "$run_yaml" rod/.github/workflows/ci.yml
claim 'its continuous integration is YAML with a job' "$said" = debian-12
runs /usr/bin/python3 -c "$run_yaml" rod/.github/workflows/pages.yml
claim 'its site is published by two jobs' "$said" = 'site deploy'

mkdir empty
runs "$literate" new empty
claim 'a folder that is empty will do' "$status" -eq 0

runs "$literate" new rod
claim 'a folder with files in it is refused with 2' "$status" -eq 2
claim 'it is named in one line' "$said" = "literate: 'rod' exists and is not empty"
echo text >file
runs "$literate" new file
claim 'a file is refused with 2' "$status" -eq 2

runs "$literate" new 'my paper'
claim 'a name that CMake could not take is refused with 2' "$status" -eq 2
claim 'it is named, with what to do' \
  "$said" = "literate: 'my paper' cannot name a paper: a letter, then letters, digits, '-' and '_'; give another --name"
claim 'nothing was made' ! -e 'my paper'
runs "$literate" new 'my paper' --name beam
claim 'another name may be given' "$status" -eq 0
claim 'the files bear it' -e 'my paper/paper/beam.tex'

for taken in all test install help clean package literate; do
  runs "$literate" new "$taken"
  claim "the name $taken, which is taken, is refused with 2" "$status" -eq 2
  claim "the line says why $taken is refused" \
    "$said" = "literate: '$taken' cannot name a paper: CMake has a target of this name; give another --name"
  claim "there is no folder $taken" ! -e "$taken"
done
# refusal ARGUMENT…: what literate_add_paper says to these.
refusal() {
  printf '%s\n' "include(\"$source_dir/src/literate/cmake/AddPaper.cmake\")" \
    "literate_add_paper(PROGRAM none DOCUMENT paper MAIN a.tex CASE case.toml SOURCES src $*)" >refused.cmake
  runs cmake -P refused.cmake
}
refusal NAME test
claim 'CMake refuses the same names' "$(says 'NAME test is that of another target')" = yes
refusal NAME '"my paper"'
claim 'and names that are none' "$(says 'NAME my paper cannot name targets')" = yes
refusal NAME rod ENGINE xelatex
claim 'an engine that it does not know is named' "$(says 'ENGINE xelatex is neither pdflatex nor lualatex')" = yes

runs "$literate" new
claim 'without a folder it ends with 2' "$status" -eq 2
runs "$literate" new no/such/place
claim 'folders above are made' "$status" -eq 0

finish
