# shellcheck shell=sh
# To be sourced by the tests of scripts: makes a scratch folder whose name has a space, and offers claims about what
# commands did. The first argument of the test is the project's folder.
set -u
export source_dir="$1"
scratch=$(mktemp -d "${TMPDIR:-/tmp}/halfspace test.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
n_failed=0

# runs COMMAND…: stores its exit status in $status and its output in $said.
runs() {
  status=0
  said=$("$@" 2>&1 </dev/null) || status=$?
}

# claim TEXT TEST…: fails with TEXT unless `test TEST…` holds.
claim() {
  claim_text=$1
  shift
  if test "$@"; then return; fi
  n_failed=$((n_failed + 1))
  printf 'not so: %s\n  exit status %s, output:\n%s\n' "$claim_text" "$status" "$said" >&2
}

# says TEXT: prints whether the last command's output holds TEXT.
says() { case $said in *"$1"*) echo yes ;; *) echo no ;; esac; }

# need TOOL…: skips the test, with one line that says why, where one of these is not installed.
need() {
  for tool; do
    command -v "$tool" >/dev/null || { printf 'skipped: there is no %s\n' "$tool" && exit 77; }
  done
}

finish() { exit "$((n_failed > 0))"; }
