# shellcheck shell=bash
# The scripts of this folder source this file before they change to another folder.
caller=${CALLER:-$PWD}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
root=$(cd "$here/../../.." && pwd -P)
build=${WORK:-$root/build}
# shellcheck disable=SC2034  # the scripts use them
work=$build/course assignment=${ASSIGNMENT:-$root/report/assignment}
export HALFSPACE_COURSE=${HALFSPACE_COURSE:-$root/build/release/halfspace-course}

# given SCRIPT VARIABLE PATH: prints the absolute path of what the user named; a relative PATH starts from the folder in
# which the user called make.
given() {
  if (cd "$caller" && [[ -e $3 ]]); then
    (cd "$caller" && realpath -- "$3")
  else
    printf '%s: %s: there is no %q\n' "$1" "$2" "$3" >&2
    exit 2
  fi
}

# add_given SCRIPT VARIABLE FLAG: adds FLAG and the path in VARIABLE to the array `options`, unless the user left it out.
add_given() {
  if [[ -z ${!2:-} ]]; then return; fi
  local path
  path=$(given "$1" "$2" "${!2}") || exit
  options+=("$3" "$path")
}

# SEED_FILE=file takes the place of SEED=text, which everybody on the machine can read on the command line of make.
if [[ -n ${SEED_FILE:-} ]]; then
  if [[ -n ${SEED:-} ]]; then
    printf '%s: SEED and SEED_FILE exclude each other\n' "${0##*/}" >&2
    exit 2
  fi
  seed_file=$(given "${0##*/}" SEED_FILE "$SEED_FILE") || exit 2
  SEED=$(<"$seed_file")
  export SEED
  unset SEED_FILE
  if [[ -z $SEED ]]; then
    printf '%s: SEED_FILE: %q is empty\n' "${0##*/}" "$seed_file" >&2
    exit 2
  fi
fi

# keep_seed FILE: writes SEED to a file that only the user can read. On a command line everybody on the machine could
# read it.
keep_seed() {
  rm -f "$1"
  (umask 077 && printf '%s\n' "$SEED" >"$1")
}

# pack ZIP FOLDER ENTRY: packs what stands in FOLDER below ENTRY. A zip keeps times and rights, so these are set in a copy:
# the same files give the same bytes.
pack() (
  copy=$(mktemp -d "${TMPDIR:-/tmp}/halfspace packing.XXXXXX")
  trap 'rm -rf "$copy"' EXIT
  cp -R "$2" "$copy/folder"
  chmod -R u=rwX,go=rX "$copy/folder"
  find "$copy/folder" -exec touch -d 2000-01-01T00:00:00Z {} +
  (cd "$copy/folder" && find "$3" -type f | LC_ALL=C sort | TZ=UTC zip -q -X -D ../packed.zip -@)
  mkdir -p "$(dirname "$1")"
  mv "$copy/packed.zip" "$1"
)
