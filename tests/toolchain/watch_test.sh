#!/bin/sh
# watch builds after each save, in whatever way the editor saves.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/shell_test.sh"
need inotifywait setsid

# A fake command records that it was called, and fails on demand.
root="$scratch/check out"
mkdir -p "$scratch/measured" "$root/src" "$root/report/sections" "$root/figures" "$scratch/cases" "$scratch/raw"
cat >"$scratch/build" <<'END'
echo "build $1 ${LITERATE_WATCHES:-}"
if [ -e src/broken.cpp ]; then echo 'broken.cpp:1: error'; exit 1; fi
END
touch "$root/report/sections/a.tex" "$scratch/cases/my.toml"
printf '%s\n' name=report "root=$root" "build=$root/build" "document=$root/report" "case=$scratch/cases/my.toml" \
  "data=$scratch/measured/run 1.dat:$scratch/measured/fit.py" "reads=$scratch/raw/plate.dat" "output=$root/build/report" \
  sources=src "figures=$root/figures" >"$scratch/settings"
status=- said=-
log=$scratch/log

# begin_watching SETTINGS: in the background.
begin_watching() {
  # A shell starts background commands with interrupts ignored; env restores the default.
  setsid env --default-signal=INT bash "$source_dir/src/literate/scripts/watch" "$1" bash "$scratch/build" report >"$log" 2>&1 &
  watch=$!
}

# n_builds N: waits until N builds have ended.
n_builds() {
  for _ in $(seq 100); do
    said=$(cat "$log")
    [ "$(grep -c 'waiting for the next save' "$log")" -ge "$1" ] && break
    sleep 0.1
  done
  sleep 0.3 # so that one too many would show
  said=$(cat "$log")
  test "$(grep -c '^build report' "$log")" -eq "$1"
}
claim_built() { # claim_built TEXT N
  n_builds "$2" && built=yes || built=no
  claim "$1" "$built" = yes
}

begin_watching "$scratch/settings"
claim_built 'it builds at once' 1
claim 'overfull boxes are warnings while someone writes' "$(says 'build report 1')" = yes
sleep 0.5 # until the folders are watched
echo x >"$root/report/sections/a.tex"
claim_built 'a save builds' 2
claim 'what changed is named' "$(says 'changed: report/sections/a.tex')" = yes

echo x >"$root/report/sections/.a.tex.swp"
echo x >"$root/report/sections/4913"
mv "$root/report/sections/a.tex" "$root/report/sections/a.tex~"
echo y >"$root/report/sections/a.new"
mv "$root/report/sections/a.new" "$root/report/sections/a.tex"
claim_built 'an editor that saves by renaming builds once' 3

echo x >"$root/figures/f.gp"
claim_built 'a script of a figure that is saved builds' 4
claim 'it is named' "$(says 'changed: figures/f.gp')" = yes

mkdir "$root/src/new"
sleep 0.3
echo x >"$root/src/new/a.cpp"
claim_built 'a new folder is watched too' 5
echo x >"$scratch/cases/my.toml"
claim_built 'a case elsewhere is watched' 6
echo x >"$scratch/cases/other.toml"
claim_built 'its neighbours are not' 6
echo x >"$scratch/measured/run 1.dat"
claim_built 'data that the paper imports are watched, whatever their ending' 7
echo x >"$scratch/raw/other.dat"
echo x >"$scratch/measured/notes.dat"
claim_built 'their neighbours are not' 7
echo x >"$root/src/results.json"
claim_built 'so is what another program wrote among the sources' 8

touch "$root/src/broken.cpp"
echo x >"$root/src/broken.cpp"
claim_built 'a save that breaks the build builds' 9
claim 'the message is shown' "$(says 'broken.cpp:1: error')" = yes
claim 'a failure is told' "$(says 'failed; waiting for the next save')" = yes
rm "$root/src/broken.cpp"
claim_built 'after a failure it goes on' 10
echo x >"$scratch/raw/plate.dat"
claim_built 'what the scripts of data read is watched' 11

end_watching() {
  kill -INT "-$watch"
  status=0
  wait "$watch" || status=$?
}
end_watching
claim 'the interrupt ends it with 0' "$status" -eq 0
sleep 0.3
claim 'no watcher stays behind' -z "$(ps -o stat= -g "$watch" | grep -v Z)"

# A save that comes while a build runs: the next build begins at once, and nothing failed.
cat >"$scratch/build" <<'END'
echo "build $1"
if [ -e slow ]; then rm slow; echo x >report/sections/a.tex; sleep 0.3; echo 'a.tex:1: half a sentence'; exit 1; fi
END
: >"$log"
begin_watching "$scratch/settings"
claim_built 'the watch begins anew' 1
sleep 0.5
touch "$root/slow"
echo x >"$root/figures/f.gp"
claim_built 'a save during a build builds again' 3
claim 'that build is not called a failure' "$(says 'failed; waiting')" = no
claim 'what happened is told' "$(says 'saved while it was built')" = yes
end_watching

# The last look of a paper finds what was saved since it was read.
mkdir -p "$scratch/out/state" "$scratch/nothing"
echo old >"$scratch/a.tex"
{ sha256sum "$scratch/a.tex"; echo '# done'; } >"$scratch/typeset"
printf '%s\n' name=p project=p "root=$scratch" "build=$scratch/nothing" "program=$scratch/nothing/p" "output=$scratch/out" >"$scratch/looked"
echo new >"$scratch/a.tex"
cp "$scratch/typeset" "$scratch/out/state"
runs bash "$source_dir/src/literate/scripts/look" "$scratch/looked" --tell
claim 'a make tells to build again' "$status$(says 'a.tex is not as it was made, or was saved since; build again')" = 1yes
cp "$scratch/typeset" "$scratch/out/state"
runs env LITERATE_WATCHES=1 bash "$source_dir/src/literate/scripts/look" "$scratch/looked" --tell
claim 'a watch, which builds again by itself, does not' "$status$(says 'build again')" = 0no
claim 'the stage is made again' ! -e "$scratch/out/state/typeset"

# A paper that `literate new` made: its case lies in the root, beside everything else.
paper="$scratch/my paper"
mkdir -p "$paper/build"
cp -R "$source_dir/src/literate/template/." "$paper"
touch "$paper/measured.csv"
printf '%s\n' name=mypaper "root=$paper" "build=$paper/build" "document=$paper/paper" "case=$paper/case.toml" \
  "data=$paper/measured.csv" "output=$paper/build/mypaper" sources=src "figures=$paper/figures" >"$scratch/settings"
: >"$log"
begin_watching "$scratch/settings"
claim_built 'a new paper is built at once' 1
sleep 0.5
n=1
for file in paper/mypaper.tex figures/period.gp figures/style.gp measured.csv src/pendulum.cpp case.toml CMakeLists.txt; do
  begin=$(date +%s%N)
  echo >>"$paper/$file"
  n=$((n + 1))
  for _ in $(seq 40); do
    [ "$(grep -c '^build report' "$log")" -eq "$n" ] && break
    sleep 0.05
  done
  tenths=$((($(date +%s%N) - begin) / 100000000))
  claim_built "in a new paper a save of $file builds" "$n"
  claim "it begins within two seconds ($tenths tenths)" "$tenths" -lt 20
  claim "$file is named" "$(says "changed: $file")" = yes
done
echo x >"$paper/build/made.tex"
claim_built 'what is built is not watched' "$n"
end_watching

finish
