# shellcheck shell=bash
# Sourced by scripts of this folder before they go to another.
caller=${CALLER:-$PWD}

# given SCRIPT VARIABLE PATH: what the user named, from where they called.
given() {
  if (cd "$caller" && [[ -e $3 ]]); then
    (cd "$caller" && realpath -- "$3")
  else
    printf '%s: %s: there is no %q\n' "$1" "$2" "$3" >&2
    exit 2
  fi
}

# keep_seed FILE: writes SEED there for the user alone; on a command line everybody on the machine could read it.
keep_seed() {
  rm -f "$1"
  (umask 077 && printf '%s\n' "$SEED" >"$1")
}
