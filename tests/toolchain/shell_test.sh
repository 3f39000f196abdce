# shellcheck shell=sh
# Sourced by the tests of scripts: a scratch folder whose name has a space, and claims about what commands did.
# Takes the project's folder as the first argument of the test.
set -u
export source_dir="$1"
scratch=$(mktemp -d "${TMPDIR:-/tmp}/halfspace test.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
n_failed=0

# runs COMMAND…: keeps its exit status in $status, what it said in $said.
runs() {
  status=0
  said=$("$@" 2>&1 </dev/null) || status=$?
}

# claim TEXT TEST…: TEST is what follows `test`.
claim() {
  claim_text=$1
  shift
  if test "$@"; then return; fi
  n_failed=$((n_failed + 1))
  printf 'not so: %s\n  exit status %s, output:\n%s\n' "$claim_text" "$status" "$said" >&2
}

# says TEXT: whether the last command said it.
says() { case $said in *"$1"*) echo yes ;; *) echo no ;; esac; }

finish() { exit "$((n_failed > 0))"; }
