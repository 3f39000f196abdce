#!/bin/sh
# handout_test.sh SOURCE PROGRAM: the handout of the real assignment is proved, as by `make course DO=handout`: the solution
# scores all points, and each wrong solution what the list says.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/../toolchain/shell_test.sh"
command -v latexmk >/dev/null || exit 77

runs env HALFSPACE_COURSE="$2" WORK="$scratch/build" bash "$source_dir/src/toolchain/course/handout"
claim 'the handout holds what it says' "$status" -eq 0
claim 'students get it as one file' -s "$scratch/build/handout.zip"
finish
