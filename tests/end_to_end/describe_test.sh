#!/bin/sh
# describe_test.sh PROGRAM SOURCE_DIR: `halfspace-report describe`, whose two files are held against their specifications.
program=$1
shift
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/../toolchain/shell_test.sh"
specifications=$source_dir/tests/literate/deposit/specifications.py

folder="$scratch/my results"
mkdir -p "$folder/generated/tables"
printf 'x (in)\n1\n' >"$folder/generated/tables/50 % of it.csv"
echo 'a document' >"$folder/report.pdf"
echo 'E = 30' >"$folder/case.toml"
cp "$source_dir/CITATION.cff" "$folder"
sum() { sha256sum <"$1" | cut -d ' ' -f 1; }
manifest() { # manifest DATE
  cat <<END
{"project": "halfspace",
 "made_with": {"sources": {"version": "0.1.0", "commit": "0123456789ab", "date": "$1"},
               "libraries": {"GSL": "2.7.1"}, "tools": {"gnuplot": "gnuplot 5.4 patchlevel 4"}},
 "inputs": {"report/case.toml": "$(sum "$folder/case.toml")", "src/a b.cpp": "$(printf x | sum /dev/stdin)"},
 "outputs": {"report.pdf": "$(sum "$folder/report.pdf")",
             "generated/tables/50 % of it.csv": "$(sum "$folder/generated/tables/50 % of it.csv")"},
 "numbers": {},
 "verdicts": {}}
END
}
manifest 2026-11-21T12:00:00Z >"$folder/manifest.json"
printf '%s=%s\n' name report root "$folder" document "$folder" main report.tex figures "$folder" output "$folder" >"$scratch/settings"
describe() { runs "$program" describe "$scratch/settings" --folder "$folder"; }

describe
claim 'the folder is described' "$status" -eq 0
cp "$folder/codecheck.yml" "$folder/ro-crate-metadata.json" "$scratch"
runs python3 "$specifications" "$folder"
claim 'both files are what their specifications demand' "$status" -eq 0
claim 'codecheck.yml lists the outputs and nothing else' "$(grep -c 'file:' "$folder/codecheck.yml")" -eq 2
claim 'what only the codechecker knows is left out' \
  "$(grep -c -E '^(codechecker|report|certificate|check_time)' "$folder/codecheck.yml")" -eq 0

# The check itself: it finds what is wrong.
breaks() { # breaks FILE SED_EXPRESSION
  sed -i "$2" "$folder/$1"
  runs python3 "$specifications" "$folder"
  claim "the check sees '$2' in $1" "$status" -eq 1
  cp "$scratch/$1" "$folder/$1"
}
breaks ro-crate-metadata.json 's/"datePublished": "2026/"datePublished": "the year 2026/'
breaks ro-crate-metadata.json 's/"contentSize": "7"/"contentSize": "8"/'
breaks ro-crate-metadata.json '0,/#program/s//#other/'
breaks codecheck.yml 's/^  title:/  tittle:/'
echo more >>"$folder/report.pdf"
runs python3 "$specifications" "$folder"
claim 'the check sees a file that was changed' "$(says 'report.pdf has another digest')" = yes
echo 'a document' >"$folder/report.pdf"

describe
claim 'the same files give the same bytes' "$(cat "$folder/codecheck.yml" "$folder/ro-crate-metadata.json" | sum /dev/stdin)" = \
  "$(cat "$scratch/codecheck.yml" "$scratch/ro-crate-metadata.json" | sum /dev/stdin)"

manifest unknown >"$folder/manifest.json"
describe
claim 'a manifest without a date ends with 2' "$status" -eq 2
claim 'what to do about it is told' "$(says 'set SOURCE_DATE_EPOCH')" = yes
manifest 2026-11-21T12:00:00Z >"$folder/manifest.json"
printf 'title: a work\nauthors:\n  - alias: nobody\n' >"$folder/CITATION.cff"
describe
claim 'a citation with an author without a name ends with 2' "$status" -eq 2
claim 'its place is told' "$(says 'CITATION.cff:3:5: an author has no name')" = yes
rm "$folder/report.pdf" "$folder/generated/tables/50 % of it.csv"
cp "$source_dir/CITATION.cff" "$folder"
describe
claim 'a folder without results ends with 2' "$status" -eq 2
claim 'it is told' "$(says 'none of the outputs')" = yes

finish
