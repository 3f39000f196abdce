#!/bin/sh
# octave_test.sh PROGRAM SOURCE_DIR: runs the paper's programs in Octave, in a copy of report/octave, and has PROGRAM
# compare what they write. Exit status 77, which CTest takes for skipped, where there is no Octave.
set -eu
program=$1 source_dir=$2

if ! command -v octave-cli >/dev/null; then
  echo 'skipped: octave-cli is not installed (make setup test-all)' >&2
  [ "${CI:-}" = true ] && exit 1
  exit 77
fi

scratch=$(mktemp -d "${TMPDIR:-/tmp}/halfspace octave.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
cp "$source_dir"/report/octave/*.m "$scratch"
for script in tri_dist run_contact_m; do
  if ! (cd "$scratch" && HOME="$scratch" octave-cli --no-init-file --no-history "$script.m" >"$script.said" 2>&1 </dev/null); then
    echo "$script.m failed:" >&2
    cat "$scratch/$script.said" >&2
    exit 1
  fi
done
HALFSPACE_OCTAVE_RESULTS="$scratch" "$program" --color_output=no
