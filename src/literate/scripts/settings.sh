# shellcheck shell=bash
# Sourced with the file that literate_add_paper wrote for a paper: a line «name=value» for each variable that its
# stages and scripts read. They are the name of the paper's targets, its project, the folders root, build, document, figures,
# output, repository (its state) and engine, the LaTeX that typesets it, the files program, literate and case, the
# document's main file, and with colons between the folders of sources, from the root on, the data that are imported, and the list of
# planted faults.
# shellcheck disable=SC2034  # read by the scripts
name='' project='' root='' build='' program='' literate='' document='' main='' case='' sources='' figures='' output='' \
  data='' reads='' faults='' repository='' engine='' latex=''
while IFS= read -r setting; do
  printf -v "${setting%%=*}" '%s' "${setting#*=}"
done <"$1"
settings=$(realpath -- "$1")
cd "$root" || exit

# cached VARIABLE: its value in CMake's cache.
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

# shown FILE: its name from the root on, if it lies below.
shown() { printf '%s\n' "${1#"$root"/}"; }
