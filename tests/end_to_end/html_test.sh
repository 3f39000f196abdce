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

for case in report/ruggiero2001.toml tests/end_to_end/steel_mm.toml; do
  echo "$case"
  rm -rf "$scratch/generated"
  "$program" report --case "$source_dir/$case" --output "$scratch/generated" --source "$source_dir" >/dev/null
  "$program" draw --generated "$scratch/generated" --scripts "$source_dir/figures" >/dev/null
  bash "$source_dir/src/toolchain/html" "$source_dir/report" "$scratch/generated" "$scratch/html" "$scratch/page.html"
  python3 -B "$source_dir/tests/end_to_end/html_test.py" "$scratch/page.html" "$scratch/generated/names.json"
done

mv "$scratch/page.html" "$scratch/first.html"
bash "$source_dir/src/toolchain/html" "$source_dir/report" "$scratch/generated" "$scratch/again" "$scratch/page.html"
cmp "$scratch/first.html" "$scratch/page.html"
echo 'no errors'
