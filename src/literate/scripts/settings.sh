# shellcheck shell=bash
# Sourced with the file that literate_add_paper wrote for a paper: a line «name=value» for each variable that its
# stages and scripts read. They are the name of the paper's targets, its project, the folders root, build, document, figures,
# output, repository (its state) and engine, the LaTeX that typesets it, the files program, literate and case, the
# document's main file, and with colons between the folders of sources, from the root on, the data that are imported, what their
# scripts read and what runs these, the records of what was read and made for it before the stages; the list of the program's objects; and the list of planted faults.
# shellcheck disable=SC2034  # read by the scripts
name='' project='' root='' build='' program='' literate='' document='' main='' case='' sources='' figures='' output='' \
  data='' reads='' tools='' records='' objects='' faults='' repository='' engine='' latex=''
while IFS= read -r setting; do
  printf -v "${setting%%=*}" '%s' "${setting#*=}"
done <"$1"
settings=$(realpath -- "$1")
cd "$root" || exit

# cached VARIABLE: its value in CMake's cache.
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

# as_here CHECKOUT BUILD CASE OUTPUT: sets $configured to the command that configures another checkout as this one is: with the same
# compiler, flags, engine and prefixes, but for a cache of the compiler. The project may lie below the paper's repository.
as_here() {
  local place setting
  place=$(cached CMAKE_HOME_DIRECTORY)
  configured=(cmake -S "$1${place#"$root"}" -B "$2" -G Ninja "-D${name}_CASE:FILEPATH=$3" "-D${name}_OUTPUT=$4")
  while IFS= read -r setting; do configured+=("-D$setting"); done < <(
    grep -E -e '^(literate_DIR|CMAKE_PREFIX_PATH|FETCHCONTENT_[A-Z_]*):[A-Z]+=.' \
      -e '^CMAKE_(BUILD_TYPE|UNITY_BUILD|CXX_COMPILER|CXX_FLAGS|CXX_FLAGS_RELEASE):' "$build/CMakeCache.txt" |
      grep -v '^FETCHCONTENT_BASE_DIR:' || true)
}

# forget_objects: removes those that were compiled from other files than there are now: of an older file in the place of one that
# was compiled, its time tells Ninja nothing.
forget_objects() {
  local object
  while IFS= read -r object; do
    if [[ -s $object.sha256 ]] && ! sha256sum --status --check "$object.sha256" 2>/dev/null; then rm -f -- "$object"; fi
  done <"$objects"
}

# figure_error LOG: what LaTeX stopped at in a figure, the last one that it read, with the line of the script that has the command.
figure_error() {
  local message figure command place
  message=$(grep -m 1 -A 9 -E '^(.*\.[a-z]+:[0-9]+: |!)' "$1") || return 0
  figure=$(grep -oE 'figures/[^/]+/[^/ ()]+\.tex' "$1" | tail -n 1)
  figure=$(basename "$figure" .tex)
  command=$(sed -nE '2,$s/^.*(\\[A-Za-z]+) *$/\1/p' <<<"$message" | head -n 1)
  place=$(cd "$figures" && grep -snF -m 1 -- "${command:-$1}" "$figure.gp" style.gp | sed -nE '1s#^([^:]*:[0-9]+):.*#\1#p') || true
  message=$(head -n 1 <<<"$message")
  printf '%s: LaTeX: %s%s\n' "$(basename "$figures")/${place:-$figure.gp}" "${message##*:[0-9]*: }" "${place:+ $command}"
}

# fail MESSAGE [EXIT]: ends the script with a message that begins with its name: with 3, since a tool failed, or another code.
fail() {
  printf '%s: %s\n' "${0##*/}" "$1" >&2
  exit "${2:-3}"
}

# here_git ARGUMENT…: git, whoever owns the checkout.
here_git() { git -c "safe.directory=$root" "$@"; }

# settings_with NAME=VALUE…: prints the settings with these in place of their own.
settings_with() {
  local setting names=()
  for setting; do names+=(-e "^${setting%%=*}="); done
  grep -v "${names[@]}" -- "$settings"
  printf '%s\n' "$@"
}

# shown FILE: its name from the root on, if it lies below.
shown() { printf '%s\n' "${1#"$root"/}"; }
