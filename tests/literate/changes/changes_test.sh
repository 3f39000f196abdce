#!/usr/bin/env bash
# changes_test.sh SOURCE LITERATE: what `make changes` tells of a tag, a manifest and a tree that differs from its commit, and what of
# bad input. The papers are made by hand, where the script would find those that it made before.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
unset SINCE GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE
literate=$2
cd "$scratch" || exit 1
mkdir -p rod/build/out
cd rod || exit 1
git() { command git -c user.name=t -c user.email=t@example.org -c commit.gpgsign=false "$@"; }

# manifest PROJECT PEAK: one of a value, with its error.
manifest() {
  printf '{"project": "%s", "made_with": {}, "inputs": {}, "outputs": {}, "verdicts": {}, "numbers":
    {"peak": {"number": %s, "printed": "%s psi", "abs_error": 0.1}}}' "$1" "$2" "$2"
}
# make_settings ROOT: what CMake would have written of the paper there.
make_settings() {
  mkdir -p "$1/build/out"
  printf '%s\n' name=rod project=rod "root=$1" "build=$1/build" "literate=$literate" program=true "document=$1/paper" "case=$1/case.toml" main=a.tex \
    "output=$1/build/out" >"$1/build/rod.settings"
  printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\nCMAKE_BUILD_TYPE:STRING=Release\n' "$1" >"$1/build/CMakeCache.txt"
  manifest rod 12 >"$1/build/out/manifest.json"
  mkdir -p "$1/build/out/generated"
  printf '{"values": {}, "places": {"tables": {}, "flags": {}}, "figures": {}, "flags": {}, "excerpts": {}, "claims": {}, "texts": [],
    "faults": [], "files": []}' >"$1/build/out/generated/names.json"
}
changes() { runs env "$@" bash "$source_dir/src/literate/scripts/changes" build/rod.settings; }
# refused WHAT SAID [VARIABLE…]: ends with 2 and one line.
refused() {
  changes "${@:3}"
  claim "$1 ends with 2" "$status" -eq 2
  claim "$1 is told" "$(says "$2")" = yes
  claim "$1 is told in one line" "$(wc -l <<<"$said")" -eq 1
}

git init -q -b main .
echo build/ >.gitignore
git add -A
git commit -qm 'nothing yet'
git tag empty
mkdir paper
echo 'We saw a peak of ten.' >paper/a.tex
git add -A
git commit -qm 'by hand'
git tag hand
echo 'side = 3' >case.toml
printf 'The peak is\n\\val{peak}. It is high.\n' >paper/a.tex
git add -A
git commit -qm 'by the engine'
git tag submitted
make_settings "$PWD"
former=build/out/changes/$(git rev-parse submitted)
mkdir -p "$former/paper"
command git clone -q . "$former/checkout"
manifest rod 10 >"$former/paper/manifest.json"

changes SINCE=submitted
claim 'a tag is compared' "$status" -eq 0
claim 'what moved is told once, with its sentence and the folder of its file' "$(head -n 2 <<<"$said" | tr -s ' ')" = \
  'moved beyond both errors value peak: 12 psi, was 10 psi
 paper/a.tex:1'
claim 'the table has the file' "$(sed -n 2p build/out/changes/changes.csv)" = \
  'moved beyond both errors,value peak,10 psi,12 psi,paper/a.tex,1'
claim 'the page says what was compared' "$(grep -c 'Before: submitted, commit .* After: the sources as they are' build/out/changes/changes.html)" -eq 1
manifest rod 12 >"$former/paper/manifest.json"
changes SINCE=submitted
claim 'what is the same does not differ' "$status $(says 'no value, text, table, figure, listing, verdict or limit differs')" = '0 yes'

claim 'what LaTeX cannot set is told, and the rest stands' "$(says 'changes: marked.pdf is not made, since LaTeX stops at the marked text: ')$(
  cut -d / -f 4 <<<"$said" | tail -n 1)" = yesanswer.md
mkdir bin
printf '#!/bin/sh\necho "it broke" >&2\nexit 1\n' >bin/latexdiff
chmod +x bin/latexdiff
echo stale >build/out/changes/marked.pdf
changes SINCE=submitted PATH="$PWD/bin:$PATH"
claim 'what latexdiff says is told' "$status$(says 'changes: marked.pdf is not made: latexdiff: it broke')" = 0yes
claim 'no marked.pdf of before is left' ! -e build/out/changes/marked.pdf
rm -r bin

echo stale >build/out/changes/answer.md
sed -i s/^program=true/program=false/ build/rod.settings
changes SINCE=submitted
claim 'a verdict that is not as expected is no hindrance' "$status $(grep -c stale build/out/changes/answer.md)" = '0 0'
sed -i "s#^case=.*#case=$scratch/case.toml#" build/rod.settings
echo 'side = 3' >"$scratch/case.toml"
rm -rf "$former"
changes SINCE=submitted
claim 'it is told that a case elsewhere serves both states' "$(says 'is not in the repository: both states have its parameters')" = yes
make_settings "$PWD"
rm -rf "$former"
mkdir -p "$former/paper"
command git clone -q . "$former/checkout"
manifest rod 12 >"$former/paper/manifest.json"

claim 'parameters that are as before are not told' "$(grep -c Parameters build/out/changes/answer.md)" -eq 0
printf '[rod]\nside = 4\n' >case.toml
printf '[rod]\nside = 3\n' >"$former/checkout/case.toml"
changes SINCE=submitted
claim 'parameters that are others are told with their table' "$(sed -n '/^## Parameters/,$p' build/out/changes/answer.md)" = \
  $'## Parameters that are others\n\n```diff\n@@ [rod]\n-side = 3\n+side = 4\n```'
git checkout -q case.toml

printf '%s\n' '\title{Rods}' '\newcommand{\kind}{thin}' '\begin{document}' 'It is \kind.' >paper/a.tex
cp paper/a.tex "$former/checkout/paper/a.tex"
echo '@book{one, year = 1985}' >"$former/checkout/paper/r.bib"
echo '@book{one, year = 1987}' >paper/r.bib
sed -i 's/{thin}/{thick}/' paper/a.tex
changes SINCE=submitted
claim 'a macro of the preamble and a reference that are others are told' "$(sed -n '/^## Lines/,$p' build/out/changes/answer.md)" = \
  $'## Lines that are others in a.tex, before its text\n\n```diff\n@@\n-\\newcommand{\\kind}{thin}\n+\\newcommand{\\kind}{thick}\n```\n
## Lines that are others in r.bib\n\n```diff\n@@\n-@book{one, year = 1985}\n+@book{one, year = 1987}\n```'
rm paper/r.bib
changes SINCE=submitted
claim 'references that are gone are told' "$(grep -A 4 '^## Lines that are others in r.bib' build/out/changes/answer.md | tail -n 1)" = '-@book{one, year = 1985}'
git checkout -q paper
git -C "$former/checkout" checkout -q .
rm "$former/checkout/paper/r.bib"

# A dirty tree
printf 'The peak is\n\\val{peak}. It is very high.\n' >paper/a.tex
changes SINCE=submitted
claim 'words that are not committed are compared as they are' "$status $(grep -c '^> It is very high' build/out/changes/answer.md)" = '0 1'

refused 'nothing' 'SINCE is missing'
refused 'a tag that there is not' 'SINCE: there is neither a file nor a tag or commit none' SINCE=none
refused 'a tag before the paper' 'empty has no document in paper' SINCE=empty
refused 'a tag before the case' 'hand has no case case.toml; build/out/changes/answer.md has what differs in the text alone' SINCE=hand
claim 'what can be told is told: the words' "$(grep -c -e '^> We saw a peak of ten' -e '^> It is very high' build/out/changes/answer.md)" -eq 2
claim 'and no results' ! -e build/out/changes/changes.csv
git checkout -q hand -- paper
echo 'side = 3' >case.toml
git add -A
git commit -qm 'a case, and no engine'
git tag early
changes SINCE=early
claim 'a tag before the engine ends with 2' "$status" -eq 2
claim 'it is told with the reason' "$(says 'changes: early cannot be made here: CMake Error: The source directory')" = yes
claim 'and what else to give' "$(says 'give the manifest.json of a paper that was made of it instead; build/out/changes/answer.md has')" = yes

git checkout -q submitted -- paper
git commit -qam 'the paper as it was submitted'

manifest bar 10 >other.json
refused 'a manifest of another paper' 'is the manifest of another project, "bar"' SINCE=other.json
echo '{"project": "rod", "made_with": {"case": {}}, "inputs": {}, "outputs": {}, "verdicts": {}, "numbers": {}}' >other.json
refused 'a record of results' "'other.json' is a record of results and no manifest" SINCE=other.json
echo '{"project": "rod"}' >other.json
refused 'what is no manifest' "'other.json' is not a manifest" SINCE=other.json
manifest rod 10 >other.json # as earlier versions wrote them, without limits
changes SINCE=other.json
claim 'a manifest is compared' "$status $(says 'value peak: 12 psi, was 10 psi')" = '0 yes'
claim 'it is said what it does not tell' "$(says 'its text is not known')" = yes

# Without history, or git
command git clone -q --depth=1 "file://$PWD" ../shallow
make_settings "$scratch/shallow"
cp other.json ../shallow
cd ../shallow || exit 1
refused 'a tag that a shallow clone does not have' "there is no commit submitted in this shallow clone; 'git fetch --unshallow' brings the others" SINCE=submitted
changes SINCE=other.json
claim 'a manifest is compared there too' "$status $(says 'value peak: 12 psi, was 10 psi')" = '0 yes'
rm -rf .git
refused 'a folder that is no repository' 'is no git repository; give a manifest.json' SINCE=submitted
mkdir ../bin
for tool in bash basename dirname env grep head mkdir mv realpath rm sed; do ln -s "$(command -v $tool)" ../bin; done
refused 'a machine without git' 'there is no git here; give a manifest.json' SINCE=submitted PATH="$scratch/bin"
changes SINCE=other.json PATH="$scratch/bin"
claim 'without git a manifest is compared too' "$status $(says 'value peak: 12 psi, was 10 psi')" = '0 yes'
finish
