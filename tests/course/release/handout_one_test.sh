#!/bin/sh
# handout_one_test.sh SOURCE PROGRAM: the handout of the real assignment with its sheet, by the script of `make course DO=handout`.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/../../toolchain/shell_test.sh"
command -v latexmk >/dev/null || exit 77

# handout_one FOLDER [STUDENT]: makes one, and says the digest of its zip.
handout_one() {
  runs env HALFSPACE_COURSE="$program" CALLER="$scratch" SEED="${2:+a seed}" bash "$source_dir/src/toolchain/course/handout-one" "$scratch/$1" "${2:-}"
  claim "the handout $1 is made" "$status" -eq 0
  digest=$(sha256sum <"$scratch/$1.zip")
}
program=$2
handout_one handout
first=$digest
claim 'it has a sheet' "$(head -c 5 "$scratch/handout/sheet.pdf")" = '%PDF-'
claim 'nothing else is left' "$(ls "$scratch" | wc -l)" -eq 2
handout_one handout
claim 'it has the same bytes again' "$digest" = "$first"
handout_one alice alice
claim "a student's is another one" "$digest" != "$first"
finish
