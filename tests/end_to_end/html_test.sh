#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# html_test.sh PROGRAM SOURCE: the page of both cases, as a browser shows it; and that it is the same page again.
set -euo pipefail
program=$1 source_dir=$2 lacks_axe=no
missing=$(sh "$source_dir/src/toolchain/missing" html)
if ! command -v chromium >/dev/null; then missing+=' chromium'; fi
if [[ -n $missing ]]; then
  printf 'skipped: %s missing — run "make setup test-all"\n' "${missing//$'\n'/ }"
  exit 77
fi
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
export TMPDIR=$scratch/temporary
mkdir "$TMPDIR"
touch "$TMPDIR/of-another-program"

# settings FOLDER CASE [SETTING…]: those that the build would write, as FOLDER/page.settings.
settings() {
  printf '%s\n' name=page project=halfspace "root=$source_dir" "build=$1" "program=$program" \
    "document=$source_dir/report" main=report.tex "case=$source_dir/$2" sources=src "figures=$source_dir/figures" "output=$1" \
    "engine=$source_dir/src/literate" "${@:3}" >"$1/page.settings"
}

# page FOLDER: FOLDER/page.html from FOLDER/generated, by FOLDER/page.settings.
page() {
  "$program" draw "$1/page.settings" >/dev/null
  "$program" typeset "$1/page.settings" >/dev/null
  bash "$source_dir/src/literate/scripts/html" "$1/page.settings"
}

for case in report/ruggiero2001.toml tests/end_to_end/steel_mm.toml; do
  echo "$case"
  rm -rf "$scratch/generated"
  settings "$scratch" "$case"
  "$program" compute "$scratch/page.settings" >/dev/null
  page "$scratch"
  python3 -B "$source_dir/tests/literate/page/page_and_pdf.py" "$scratch" "$source_dir/report" report page
  # The report's own case is looked at in every way; axe-core is not everywhere.
  ways=() status=0
  if [[ $case = report/* ]]; then ways=(--as-read); fi
  python3 -B "$source_dir/tests/end_to_end/html_test.py" "$scratch/page.html" "$scratch/generated/names.json" "${ways[@]}" || status=$?
  if [[ $status -eq 77 ]]; then lacks_axe=yes; elif [[ $status -ne 0 ]]; then exit "$status"; fi
done

mkdir "$scratch/again"
cp -R "$scratch/generated" "$scratch/again"
settings "$scratch/again" "$case"
page "$scratch/again"
cmp "$scratch/page.html" "$scratch/again/page.html"
# A drawing is that of the PDF: neither shrunk by rounding, nor with larger letters.
if grep -lE 'matrix\(\.9[0-9]{0,2} ' "$scratch"/html/figures/*.svg; then echo 'drawings are shrunk'; exit 1; fi
[[ $(pdffonts "$scratch/html/figures.pdf") == *LMRoman9-Regular* ]] || { echo 'the letters of figures have another size'; exit 1; }
# A figure that did not change is not drawn again, and one that did is.
before=$(stat -c %y "$scratch/html/figures/surface-gradient.svg")
page "$scratch" >/dev/null
[[ $(stat -c %y "$scratch/html/figures/surface-gradient.svg") = "$before" ]] || { echo 'a figure was drawn again in vain'; exit 1; }
cp -R "$source_dir/figures" "$scratch/scripts"
sed -i '1i set title "changed"' "$scratch/scripts/surface-gradient.gp"
settings "$scratch" "$case" "figures=$scratch/scripts"
page "$scratch" >/dev/null
[[ $(stat -c %y "$scratch/html/figures/surface-gradient.svg") != "$before" ]] || { echo 'a changed figure was not drawn'; exit 1; }

# A command that the page does not know is told with its place, before anything else is made.
mkdir "$scratch/unknown"
cp -R "$source_dir/report" "$scratch/unknown/report"
printf '\n\\unheard{x}\n' >>"$scratch/unknown/report/sections/results.tex"
status=0
settings "$scratch" "$case" "document=$scratch/unknown/report"
said=$("$program" page "$scratch/page.settings" 2>&1) || status=$?
[[ $status -eq 2 && $said == *'report/sections/results.tex:'*': \unheard is not known to the page'* ]] || {
  printf 'the page says with status %s: %s\n' "$status" "$said"
  exit 1
}

# The site.
settings "$scratch" "$case"
printf '%%PDF sheet\n' >"$scratch/sheet.pdf"
SITE=https://example.org/report BESIDE=$scratch/sheet.pdf bash "$source_dir/src/literate/scripts/site" "$scratch/page.settings"
tables=("$scratch"/generated/tables/*.csv)
for file in index.html page.pdf sheet.pdf picture.png CITATION.cff page-citation.bib .nojekyll data/values.csv data/names.json \
  "data/tables/$(basename "${tables[0]}")"; do
  [[ -e $scratch/site/$file ]] || { echo "the site has no $file"; exit 1; }
done
for said in 'citation_pdf_url" content="https://example.org/report/page.pdf"' 'og:image" content="https://example.org/report/picture.png"' \
  '<a href="sheet.pdf">sheet.pdf</a>'; do
  grep -qF -- "$said" "$scratch/site/index.html" || { echo "the site's page does not say: $said"; exit 1; }
done
[[ $(od -An -tu1 -j16 -N8 "$scratch/site/picture.png" | tr -s ' ') == ' 0 0 4 176 0 0 2 118' ]] || { echo 'the picture is not 1200 x 630'; exit 1; }
refused() {
  local status=0
  env "$1" bash "$source_dir/src/literate/scripts/site" "$scratch/page.settings" >"$scratch/said" 2>&1 || status=$?
  [[ $status -eq 2 ]] && grep -qF -- "$2" "$scratch/said" || { echo "$1: status $status: $(cat "$scratch/said")"; exit 1; }
}
refused SITE=example.org "'example.org' is no address"
refused "BESIDE=$scratch/none.pdf" "there is no file '$scratch/none.pdf'"
[[ -e $scratch/site/index.html ]] || { echo 'a site that was refused took the last one with it'; exit 1; }
[[ -e $TMPDIR/of-another-program ]] || { echo 'a temporary file of another program was removed'; exit 1; }
[[ $lacks_axe = no ]] || exit 77
echo 'no errors'
