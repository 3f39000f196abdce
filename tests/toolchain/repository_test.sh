#!/bin/sh
# WriteRepository.cmake writes the commit and whether the checkout differs from it.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/shell_test.sh"
unset SOURCE_DATE_EPOCH
unset GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE

checkout=$scratch/checkout
state=$scratch/state
written=$state/repository.json
mkdir -p "$checkout/report"

ask() { # ask FOLDER: the commit and the flag, as the document would tell them
  runs cmake "-DSOURCE=$1" "-DOUTPUT=$state" -P "$source_dir/src/literate/cmake/WriteRepository.cmake"
}
has() { grep -qF "$1" "$written" && echo yes || echo no; }
git_here() { git -C "$checkout" -c user.name=t -c user.email=t@example.org -c commit.gpgsign=false "$@" >/dev/null 2>&1; }

ask "$checkout"
claim 'outside a checkout the commit is unknown' "$(has '"commit": "unknown"')" = yes
claim 'outside a checkout nothing counts as modified' "$(has '"modified": false')" = yes
claim 'and there is no date' "$(has '"date": "unknown"')" = yes
claim 'LaTeX is told the same' "$(cat "$state/repository.tex")" = '\LiterateRepository{unknown}{false}{unknown}'

git_here init
ask "$checkout"
claim 'before the first commit it is unknown' "$(has '"commit": "unknown"')" = yes

echo /ignored >"$checkout/.gitignore"
echo a >"$checkout/report/case.toml"
echo a >"$checkout/report/report.tex"
git_here add -A
git_here commit -m first
commit=$(git -C "$checkout" rev-parse HEAD | cut -c 1-12)
ask "$checkout"
claim 'the commit has twelve digits' "$(has "\"commit\": \"$commit\"")" = yes
claim 'a fresh commit is not modified' "$(has '"modified": false')" = yes

claim "the date is the commit's" "$(has "$(TZ=UTC git -C "$checkout" log -1 --date=format-local:%Y-%m-%dT%H:%M:%SZ --format='"date": "%cd"')")" = yes
SOURCE_DATE_EPOCH=988027200 ask "$checkout"
claim 'or the one that is asked for' "$(has '"date": "2001-04-23T12:00:00Z"')" = yes
ask "$checkout"

touch -d 2001-04-23 "$written"
before=$(stat -c %Y "$written")
touch "$checkout/ignored"
ask "$checkout"
claim 'ignored files do not count, and an unchanged answer is not written again' \
  "$(stat -c %Y "$written")" = "$before"

# The engine is another checkout, an installed folder, or the same checkout.
engine=$scratch/engine
ask_with_engine() { runs cmake "-DSOURCE=$checkout" "-DENGINE=$1" "-DOUTPUT=$state" -P "$source_dir/src/literate/cmake/WriteRepository.cmake"; }
ask_with_engine "$checkout/src/literate"
claim "an engine in the paper's checkout has its commit" "$(has "\"engine\": {\"commit\": \"$commit\", \"modified\": false}")" = yes
mkdir -p "$engine/share/literate"
ask_with_engine "$engine/share/literate"
claim 'of an engine that nobody knows it is unknown' "$(has '"engine": {"commit": "unknown", "modified": false}')" = yes
echo '{"commit": "abcdefabcdef", "modified": true}' >"$engine/share/literate/repository.json"
ask_with_engine "$engine/share/literate"
claim 'an installed one has kept it' "$(has '"engine": {"commit": "abcdefabcdef", "modified": true}')" = yes
ask "$checkout"

echo b >"$checkout/report/report.tex"
ask "$checkout"
claim 'changed prose counts' "$(has '"modified": true')" = yes
echo a >"$checkout/report/report.tex"

touch "$checkout/new file"
ask "$checkout"
claim 'a new file counts' "$(has '"modified": true')" = yes
rm "$checkout/new file"
echo b >"$checkout/report/case.toml"
ask "$checkout"
claim 'a changed file counts' "$(has '"modified": true')" = yes

mkdir "$checkout/archive"
ask "$checkout/archive"
claim 'an archive unpacked inside another checkout does not report its commit' "$(has '"commit": "unknown"')" = yes

finish
