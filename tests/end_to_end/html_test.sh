#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# html_test.sh PROGRAM SOURCE: the page of both cases, as a browser shows it; and that it is the same page again.
set -euo pipefail
program=$1 source_dir=$2
for stage in html html-test; do
  missing=$(sh "$source_dir/src/toolchain/missing" "$stage")
  if [[ -n $missing ]]; then
    printf 'skipped: %s missing — run "make setup STAGES=%s"\n' "${missing//$'\n'/ }" "$stage"
    exit 77
  fi
done
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
export TMPDIR=$scratch/temporary
mkdir "$TMPDIR"
touch "$TMPDIR/of-another-program"

# page FOLDER: FOLDER/page.html from FOLDER/generated, by the settings that the build would write.
page() {
  printf '%s\n' name=page project=halfspace "root=$source_dir" "build=$1" "program=$program" \
    "document=$source_dir/report" main=report.tex case= sources=src "output=$1" "repository=$1" "engine=$source_dir/src/literate" \
    >"$1/page.settings"
  bash "$source_dir/src/literate/scripts/html" "$1/page.settings"
}

for case in report/ruggiero2001.toml tests/end_to_end/steel_mm.toml; do
  echo "$case"
  rm -rf "$scratch/generated"
  "$program" compute --case "$source_dir/$case" --output "$scratch/generated" --source "$source_dir" >/dev/null
  "$program" draw --generated "$scratch/generated" --scripts "$source_dir/figures" >/dev/null
  page "$scratch"
  python3 -B "$source_dir/tests/end_to_end/html_test.py" "$scratch/page.html" "$scratch/generated/names.json"
done

mkdir "$scratch/again"
cp -R "$scratch/generated" "$scratch/again"
page "$scratch/again"
cmp "$scratch/page.html" "$scratch/again/page.html"
[[ -e $TMPDIR/of-another-program ]] || { echo 'a temporary file of another program was removed'; exit 1; }
echo 'no errors'
