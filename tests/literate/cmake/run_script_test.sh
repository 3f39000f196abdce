#!/usr/bin/env bash
# run_script_test.sh SOURCE: the build runs a script of data again when the script, or what it reads, is another one.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
cd "$scratch" || exit 1

cat >CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.25)
project(measured LANGUAGES NONE)
include("$source_dir/src/literate/cmake/AddPaper.cmake")
literate_run_script(MAKES measured.csv COMMAND sh measure.sh READS raw.txt)
string(SHA256 id "\${CMAKE_CURRENT_SOURCE_DIR}/measured.csv")
add_custom_target(all_data ALL DEPENDS "\${CMAKE_CURRENT_SOURCE_DIR}/measured.csv" "\$<TARGET_PROPERTY:literate_scripts,sames_\${id}>")
END
# shellcheck disable=SC2016  # it is the script's
echo 'echo run >>runs.txt; { echo x; cat raw.txt; } >measured.csv' >measure.sh
echo 1 >raw.txt
echo 'older than its script' >measured.csv

# edits COMMAND…: does it in a later tick of the file system's clock than that which wrote measured.csv. Ninja takes files of one
# tick, some milliseconds, to be of one age, and this test is fast enough to edit within it.
edits() {
  touch edited
  until [ edited -nt measured.csv ]; do touch edited; done
  "$@"
}

runs cmake -S . -B build -G Ninja
runs cmake --build build
claim 'a file that the build has not made is made anew' "$(cat measured.csv)" = "x
1"
runs cmake --build build
claim 'what has not changed is not run again' "$(wc -l <runs.txt)" -eq 1
edits sed -i 's/1/9/' measured.csv
runs cmake --build build
claim 'a file that was changed by hand is not taken for what the script made' \
  "$status $(says 'measured: CMakeLists.txt:4: measured.csv was changed after the script had made it; delete it, and the script makes it again')" = '1 yes'
runs cmake --build build
claim 'nor is it by the next build' "$status $(cat measured.csv)" = '1 x
9'
rm measured.csv
runs cmake --build build
claim 'deleted, it is made again' "$status $(cat measured.csv)" = '0 x
1'
edits sed -i 's/echo x;/echo y;/' measure.sh
runs cmake --build build
claim 'a changed script is run again' "$(cat measured.csv)" = "y
1"
edits sed -i 's/1/2/' raw.txt
runs cmake --build build
claim 'so it is when what it reads has changed' "$(tail -n 1 measured.csv)" -eq 2
edits sh -c 'echo 3 >old.txt && touch -d "1 hour ago" old.txt && mv old.txt raw.txt'
runs cmake --build build
claim 'so it is when an older file has taken its place' "$status $(tail -n 1 measured.csv)" = '0 3'
n_runs=$(wc -l <runs.txt)
runs cmake --build build
claim 'and then not again' "$(wc -l <runs.txt)" -eq "$n_runs"
# shellcheck disable=SC2016
edits sed -i '$a [ ! -e late ] || { rm late; echo 2 >raw.txt; }' measure.sh
touch late
runs cmake --build build
claim 'what it reads is saved while it runs, and told' \
  "$status $(says 'measured: CMakeLists.txt:4: raw.txt was saved while sh measure.sh ran; build again, and it runs again')" = '1 yes'
claim 'what it made of neither is not left' "$(tail -n 1 measured.csv)" -eq 3
runs cmake --build build
claim 'the next build runs it on what was saved' "$status $(tail -n 1 measured.csv)" = '0 2'
# shellcheck disable=SC2016
edits sed -i '$a echo half >measured.csv; echo a remark; exit 7' measure.sh
runs cmake --build build
claim 'a script that fails stops the build' "$status" -eq 1
claim 'it is named first, with its line and its exit code' "$(says 'FAILED: ')$(grep -A 1 -m 1 ' && ' <<<"$said" | tail -n 1)" = \
  'yesmeasured: CMakeLists.txt:4: sh measure.sh failed with exit code 7'
claim 'then what it said' "$(tail -n 2 <<<"$said" | head -n 1)" = 'a remark'
claim 'the file from before is still there' "$(cat measured.csv)" = "y
2"
rm measured.csv
runs cmake --build build
claim 'a file that did not exist is none' "$status" -eq 1 -a ! -e measured.csv

echo 'echo nothing is written' >measure.sh
runs cmake --build build
claim 'a script that makes no file is told with its line and the file' \
  "$status $(says 'measured: CMakeLists.txt:4: sh measure.sh did not write measured.csv')" = '1 yes'
claim 'nothing is said of an earlier run' "$(says 'earlier run')" = no
echo 'of an earlier run' >measured.csv
runs cmake --build build
claim 'a file of an earlier run does not pass for its own' \
  "$status $(says 'did not write measured.csv, which is still the file of an earlier run')" = '1 yes'
claim 'and stays' "$(cat measured.csv)" = 'of an earlier run'
echo 'cp -p raw.txt measured.csv' >measure.sh
runs cmake --build build
claim 'a script may copy a file with its date' "$status $(cat measured.csv)" = '0 2'

# What it reads tells Ninja nothing here: the script fails for a reason of its own.
echo 'echo half >measured.csv; [ ! -e broken ] || exit 7' >measure.sh
runs cmake --build build
touch broken
rm measured.csv
runs cmake --build build
runs cmake --build build
claim 'half a file is not taken for whole by the next build' "$status" -eq 1

echo 'echo half >measured.csv; exec sleep 60' >measure.sh
LITERATE_TIMEOUT=1 runs cmake --build build
claim 'a script that takes longer than LITERATE_TIMEOUT is stopped, and told with its line' \
  "$status $(says 'measured: CMakeLists.txt:4: sh measure.sh has not ended after 1 s and was stopped')" = '1 yes'
claim 'and its half file is not left' ! -e measured.csv

sed -i 's/sh measure.sh/sh mesure.sh/' CMakeLists.txt
runs cmake -S . -B build -G Ninja
claim 'a command that names no script is refused' "$status $(says "no word of 'sh;mesure.sh' is a file")" = '1 yes'

finish
