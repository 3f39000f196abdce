#!/bin/sh
# What make says before it starts anything.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/shell_test.sh"
unset MAKEFLAGS MFLAGS MAKELEVEL CASE V
export PWD

# A checkout without a project: a command that passes the first checks fails at once.
mkdir -p "$scratch/check out/src" "$scratch/cases"
cp "$source_dir/Makefile" "$scratch/check out"
cp -r "$source_dir/src/toolchain" "$source_dir/src/course" "$scratch/check out/src"
mkdir "$scratch/check out/src/literate"
cp -r "$source_dir/src/literate/scripts" "$source_dir/src/literate/cmake" "$scratch/check out/src/literate"
cd "$scratch/check out" || exit 1

runs make help
claim 'help succeeds' "$status" -eq 0
for target in report halfspace html site dist figures watch check-report severity why test test-all faults mutants verify bench course tidy setup clean help; do
  claim "help tells what $target does" "$(says "make $target ")" = yes
done
for variable in CASE=file.toml NAME=name MANIFEST=file V=1; do
  claim "help has a line for $variable" "$(printf '%s\n' "$said" | grep -c "^ *$variable ")" = 1
done
runs make reports
claim 'a target that there is not is told' "$(says "there is no target reports; 'make help' lists them")" = yes

runs make course
claim 'without DO the commands of the course are listed' "$status$(says 'prove ')$(says 'grade ')$(says 'gradescope ')" = 0yesyesyes
runs make course DO=grade
claim 'submissions that are not named stop make' "$status $(says 'SUBMISSIONS: name the folder or the zip of the submissions')" = '2 yes'

# Names that CMake or Ninja would take for something else, such as a[bc].toml for a pattern
for name in 'a;b' 'a\b' 'a|b' 'a?b' 'a[bc]' 'a
b' 'a '; do
  printf 'title = "x"\n' >"$scratch/$name"
  runs env CASE="$scratch/$name" bash "$source_dir/src/toolchain/build" report
  claim "the name '$name' is refused" "$status" -eq 2
  claim "that is told in one line" "$(printf '%s\n' "$said" | wc -l)" -eq 1
  claim "which says where and what to do" "$(says 'CASE: ')$(says 'rename it')" = yesyes
done

runs make report CASE='no such.toml'
claim 'a case that does not exist stops make' "$status" -ne 0
claim 'the case is named' "$(says 'there is no file no such.toml')" = yes
claim 'nothing was started' ! -e build/release

runs make report CASE="$scratch/cases/none.toml"
claim 'a missing case with a whole path is named' "$(says "there is no file $scratch/cases/none.toml")" = yes

touch one.toml "$scratch/cases/one.toml"
cd "$scratch/cases" || exit 1
runs make -C "$scratch/check out" report CASE=one.toml
claim 'a case that could be either of two files is refused' "$(says 'give the whole path')" = yes

cd "$scratch/check out" || exit 1
runs make figures NAME=none
claim 'a figure without a script is named' "$(says 'NAME: there is no script figures/none.gp')" = yes

# An exported variable without a value would be empty, and TIMEOUT= lifts the limits of all tools.
printf 'include Makefile\n.DEFAULT_GOAL := shown\nshown:\n\t@env | grep ^TIMEOUT || echo unset\n' >shown.mk
unset TIMEOUT
runs make -f shown.mk
claim 'without TIMEOUT the limits of the tools stay' "$said" = unset
runs make -f shown.mk TIMEOUT=
claim 'TIMEOUT= reaches the scripts' "$said" = TIMEOUT=
printf 'include Makefile\n.DEFAULT_GOAL := shown\nshown:\n\t@echo "$${NAME-unset}"\n' >shown.mk
runs env NAME=machine make -f shown.mk
claim "a shell's own NAME is none of a figure" "$said" = unset
runs make -f shown.mk NAME=gap
claim 'NAME= reaches the scripts' "$said" = gap
rm shown.mk

# A process that is told to end may have started another one since they were counted, as drawing starts gnuplot.
require=src/toolchain/require
mv "$require" kept
cat >"$require" <<'END'
trap 'sleep 30 & : >told; exit 1' TERM
: >running
while :; do sleep 0.05; done
END
setsid make report >said 2>&1 &
make=$!
for _ in $(seq 100); do if [ -e running ]; then break; fi; sleep 0.05; done
begin=$(date +%s%N)
kill -TERM "$make"
wait "$make" 2>/dev/null
status=$? said=$(cat said)
for _ in $(seq 80); do if flock -n build/lock true; then break; fi; sleep 0.05; done
tenths=$((($(date +%s%N) - begin) / 100000000))
claim 'the process that held the lock was told to end' -e told
claim "what it started last is ended with it, at once and not by force after two seconds ($tenths tenths)" "$tenths" -lt 15
claim 'nothing holds the lock' "$(flock -n build/lock echo free)" = free

# gnuplot hears an interrupt by itself, and may hang then; the program beside it is gone. Started in the background of a script,
# make is not told of interrupts at all, and ends because the build failed.
printf 'sleep 30 >/dev/null 2>&1 &\nexit 1\n' >"$require"
runs make report
claim 'a build that failed ends with 2' "$status" -eq 2
claim 'and leaves nothing running' "$(flock -n build/lock echo free)" = free
mv kept "$require"

runs bash "$scratch/check out/src/toolchain/build" nonsense
claim 'an unknown target is named' "$(says 'there is no target nonsense')" = yes
runs make setup nonsense
claim 'nothing is installed for an unknown target' "$status$(says "there is no target nonsense; 'make help' lists them")$(says setup)" = 2yesno

finish
