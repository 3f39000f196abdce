#!/usr/bin/env bash
# package_test.sh SOURCE INSTALLED: a paper in a folder of its own, by each of the three ways to the engine: installed, as
# installed_test.sh did, FetchContent and add_subdirectory. The paper's project has targets called report, figures and
# system, as any other may.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
cd "$scratch" || exit 1
# What make exports to the tests is not meant for the paper.
unset MAKEFLAGS MFLAGS MAKELEVEL CALLER CASE CASES J KEYS NAME TARGET V MANIFEST GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE

# copied NAME: what the manual tells its readers to run or to write; example NAME: the same without comments.
copied() { python3 -B "$source_dir/tests/literate/manual/manual.py" "$source_dir/src/literate/README.md" "$1"; }
example() { copied "$1" | sed 's/ *#.*//'; }

ln -s "$2/usr local" .

# The manual's smallest paper, as a reader types it
mkdir -p tiny/paper
copied 'The smallest paper: cmake' >tiny/CMakeLists.txt
copied 'The smallest paper: cpp' >tiny/main.cpp
copied 'The smallest paper: latex' >tiny/paper/tiny.tex
echo 'side = 1.5' >tiny/case.toml
runs cmake -S tiny -B tiny/build -G Ninja "-DCMAKE_PREFIX_PATH=$scratch/usr local"
claim "the manual's smallest paper is configured" "$status" -eq 0
runs ninja -C tiny/build tiny
claim 'it is built' "$status" -eq 0
claim 'it says what the manual says' "$(pdftotext tiny/build/tiny/tiny.pdf - | grep -c '^The square has 2.25 m2 *\.$')" -eq 1

# paper FOLDER WHERE-FROM: a new paper that gets the engine by these lines of CMake, and has targets of its own.
paper() {
  runs 'usr local/bin/literate' new "$1" --name rod
  printf '%s\n' "$2" 'add_custom_target(report)' 'add_custom_target(figures)' 'add_library(system INTERFACE)' >engine.cmake
  sed -i -e '/^find_package(literate REQUIRED)$/{r engine.cmake
d}' "$1/CMakeLists.txt"
}
# builds FOLDER: its paper, as a user would.
builds() {
  cd "$scratch/$1" || exit 1
  runs cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_PREFIX_PATH=$scratch/usr local"
  claim "$1 is configured" "$status" -eq 0
  runs ninja -C build rod
  claim "$1 has its PDF" "$status" -eq 0
  claim "$1 reads nothing of the other folders" -z "$(find build -name 'libcontact*' -o -name 'liblibraries*')"
  cd "$scratch" || exit 1
}

# way N: the N-th of the manual's three, from this checkout.
way() {
  example 'Install: cmake' | sed -e "s|GIT_REPOSITORY … GIT_TAG …|SOURCE_DIR \"$source_dir\"|" \
    -e "s|add_subdirectory(halfspace)|add_subdirectory(\"$source_dir\" engine)|" | awk -v RS= "NR == $1"
}
paper 'installed paper' "$(way 1)"
builds 'installed paper'
paper 'fetched paper' "$(way 2)"
builds 'fetched paper'
paper 'added paper' "$(way 3)"
builds 'added paper'

for other in 'fetched paper' 'added paper'; do
  claim "the PDF of the $other has the bytes of the installed one's" "$(cmp 'installed paper/build/rod/rod.pdf' "$other/build/rod/rod.pdf" && echo same)" = same
done
runs pdfinfo 'installed paper/build/rod/rod.pdf'
claim 'the PDF tells its title' "$(printf '%s\n' "$said" | grep -c '^Title: *How much longer a wide swing takes$')" -eq 1
claim 'and its author' "$(printf '%s\n' "$said" | grep -c '^Author: *Your Name$')" -eq 1
text=$(pdftotext -layout 'installed paper/build/rod/rod.pdf' -)
said=$text
# K(sin 45°)·2/π = 1.180340599016… (Abramowitz & Stegun, table 17.1: K = 1.854074677301372)
for wanted in '1.180 340 599' '18.0 %' confirmed refuted src/main.cpp '1.180 340 60' Landau; do
  claim "the PDF says $wanted" "$(says "$wanted")" = yes
done
claim 'no folder of this machine is in it' "$(says "$scratch")" = no

# Its other targets
cd 'installed paper' || exit 1
git init -q . && git add -A && git -c user.name=t -c user.email=t@example.org -c commit.gpgsign=false commit -qm first
commit=$(git rev-parse HEAD | cut -c 1-12)
runs ninja -C build rod rod-check
claim 'its prose passes the check' "$status" -eq 0
claim "the manifest has the commit of the paper" "$(grep -c "\"commit\": \"$commit\"" build/rod/manifest.json)" -eq 1
runs ninja -C build rod-dist
claim 'it is packed, and typesets elsewhere' "$(says 'typeset elsewhere to the same text')" = yes
runs ninja -C build rod-why
claim 'there is nothing to do' "$(says 'nothing to do')" = yes
runs make severity
claim 'each of its faults turns a claim, and each claim is turned' \
  "$status$(says 'faults turn 2 of 2 claims; 0 more do not compile')$(says 'turns nothing')$(says '(program)')" = 0yesnono
rm paper/severity.csv
runs ninja -C build rod-verify
claim 'it is made again elsewhere with the same bytes' "$(says 'the same bytes: ')" = yes
cp build/rod/manifest.json ../theirs.json # in the checkout it would be a file that git does not know
runs make verify MANIFEST=../theirs.json
claim 'it is compared with a manifest, by the name that was given' "$(says "files have the bytes that '../theirs.json' tells of")" = yes
claim 'nothing is said of how it is built' "$(says ninja)" = no
sed 's/"number": 2.3682/"number": 2.3683/' ../theirs.json >../forged.json
runs make verify MANIFEST=../forged.json
claim 'a manifest whose files are right and whose results are not does not hold' \
  "$status$(says "'../forged.json' tells other results than these files hold")$(says 'full: it holds')" = 2yesno
runs make changes SINCE=HEAD
claim 'the same commit makes no difference' "$status$(says 'no value, text, table, figure, listing, verdict or limit differs')" = 0yes
claim 'the program is not compiled again for it' "$(says 'by the program that there is, whose sources are the same')" = yes
cp "build/rod/changes/$(git rev-parse HEAD)/paper/manifest.json" ../by_stages.json
rm -r build/rod/changes
echo '// another source' >>src/main.cpp
runs make changes SINCE=HEAD
claim 'a program of other sources is compiled' "$status$(says 'which may take minutes')" = 0yes
claim 'the paper is the same either way' "$(cmp ../by_stages.json "build/rod/changes/$(git rev-parse HEAD)/paper/manifest.json" && echo same)" = same
git checkout -q src/main.cpp
runs make changes SINCE=no-such-tag
claim 'a tag that is not there is told' "$status$(says 'changes: SINCE: there is neither a file nor a tag or commit no-such-tag')" = 2yes
sed 's/^angle = 90/angle = 91/' case.toml >../other.toml
runs make changes SINCE=../theirs.json CASE=../other.toml
claim 'what another case moves is told with the sentences that print it' \
  "$status$(says 'value relative-period: ')" = 0yes -a "$(grep -c '^moved beyond both errors,value relative-period,.*,paper/rod.tex,' build/rod-other/changes/changes.csv)" -gt 0
runs make configured # its own case again
sed -i 's/^angle = 90/angle = 60/' case.toml
runs make changes SINCE=HEAD
claim 'a number that moved is marked, though no line that prints it changed' \
  "$status$(pdftotext build/rod/changes/marked.pdf - | tr '\n' ' ' | grep -c '\[90°, a wide\] *60°, a narrow swing')" = 01
claim 'a verdict that turned is marked' "$(pdftotext build/rod/changes/marked.pdf - | grep -c '\[was confirmed\]')" -eq 1
git checkout -q case.toml

# A computation that tells nobody that it ends, as a library's may
cp src/main.cpp ../main.cpp
sed -i '/^void compute(.*{$/a std::_Exit(0);' src/main.cpp
runs make
claim 'a computation that ends the program is told' "$status$(says 'rod: the computation ended the program by itself, before it was done')" = 2yes
runs make
claim 'nor are the numbers of the run before taken by the next build' "$status" -eq 2
cp ../main.cpp src/main.cpp
runs make
claim 'without it the paper is made again' "$status" -eq 0

# A source whose time is older than that of what was compiled
older() { cp "$1" older && touch -d '1 hour ago' older && mv older "$2"; }
digest() { sha256sum "$1" | cut -d ' ' -f 1; }
in_manifest() { grep -c "\"src/main.cpp\": \"$(digest "$1")\"" build/rod/manifest.json; }
{ cat src/main.cpp; echo '// and more'; } >../more.cpp
older ../more.cpp src/main.cpp
runs build/rod_program typeset build/rod.settings
claim 'the manifest has a source as it was compiled' "$status$(in_manifest ../main.cpp)" = 01
runs ninja -C build rod-why
claim 'what was compiled is another, and told' "$(says 'src/main.cpp is another than the one that was read')" = yes
runs ninja -C build rod
claim 'an older source in the place of the one that was compiled is told by the build' \
  "$status$(says 'src/main.cpp is not as it was made, or was saved since; build again, and it is made anew')" = 1yes
runs ninja -C build rod
claim 'and the next one compiles it' "$status$(in_manifest ../more.cpp)" = 01
older ../main.cpp src/main.cpp
runs make
claim 'make compiles it at once' "$status$(in_manifest ../main.cpp)" = 01

# A limit that is changed when its result is known
committed() { git add -A && git -c user.name=t -c user.email=t@example.org -c commit.gpgsign=false commit -qm more; }
runs make check RECORD=1
claim 'the results are recorded' "$status" -eq 0 -a -s paper/results.json
committed
commit=$(git rev-parse HEAD | cut -c 1-12)
sed -i 's/LimitKind::data, 0.1, "a tenth"/LimitKind::data, 0.15, "a tenth"/' src/*.cpp
runs make check
claim 'a record of another limit is told' "$status$(says 'results.json is not of these results, the limit of claim longer: excess is another')" = 2yes
runs make check RECORD=1
claim 'a limit that was chosen after the result is told with the commits' "$status$(says "claim longer: excess: the limit was chosen after the result: '≥ 15 %' is in no committed results.json, and commit $commit has a result at '≥ 10 %'")" = 0yes
committed
runs make
claim 'the ledger says so, of this limit alone' "$(pdftotext build/rod/rod.pdf - | tr '\n' ' ' | grep -o 'limit chosen after the result' | wc -l)" -eq 1
runs make check
claim 'git and the record agree' "$status" -eq 0
cp build/rod/rod.pdf ../whole.pdf
git rev-parse HEAD >.git/shallow
rm build/rod/rod.pdf build/rod/state/typeset
runs make
claim 'a shallow clone has the same PDF' "$(cmp build/rod/rod.pdf ../whole.pdf && echo same)" = same
runs make check
claim 'what it cannot know is told' "$status$(says 'or a limit chosen, is not known: there is no git history, or a part of one')" = 2yes
rm .git/shallow
mkdir ../bin
for tool in gnuplot env setpriv; do ln -s "$(command -v $tool)" ../bin; done
runs env PATH="$scratch/bin" build/rod_program check build/rod.settings
claim 'nor is it without git' "$status$(says 'or a limit chosen, is not known: there is no git history')" = 2yes
if [[ -z $(sh "$source_dir/src/toolchain/missing" html) ]]; then
  runs ninja -C build rod-site
  claim 'its page and its site are made' "$status" -eq 0 -a -s build/rod/site/index.html
  said=$(cat build/rod/rod.html)
  for wanted in 'data-figure="period"' 'data-table="periods"' 'id="claim-longer"' 'id="bib-landau"' 'src/pendulum.cpp</code>, lines'; do
    claim "the page has $wanted" "$(says "$wanted")" = yes
  done
  runs python3 -B "$source_dir/tests/literate/page/page_and_pdf.py" build/rod paper rod
  claim 'page and PDF have the same words and numbers' "$status" -eq 0
  runs python3 -B "$source_dir/tests/literate/page/any_page_test.py" build/rod/rod.html
  claim 'its page is whole in every way of reading it' "$status" -eq 0 -o "$status" -eq 77
fi

# What the script of data reads is part of what the paper is made from.
sed -i '/^literate_add_paper/i literate_run_script(MAKES made.csv COMMAND python3 make_it.py READS raw.txt)' CMakeLists.txt
sed -i 's/^literate_add_paper(/&DATA made.csv /' CMakeLists.txt
echo 'import shutil; shutil.copy("raw.txt", "made.csv")' >make_it.py
echo 1 >raw.txt
runs ninja -C build rod-dist
claim 'the manifest has what the script of its data reads' "$status$(grep -c '"raw.txt": ' build/rod/manifest.json)" = 01
claim 'and the interpreter that ran it' "$(grep -c '"python3": "Python 3' build/rod/manifest.json)" -eq 1
claim 'and both are packed with the paper' "$(tar -tzf build/dist/rod.tar.gz | grep -cE '^\./anc/(raw\.txt|make_it\.py)$')" -eq 2
sed -i '/^literate_run_script/d' CMakeLists.txt
echo 'literate_run_script(MAKES made.csv COMMAND python3 make_it.py READS raw.txt)' >>CMakeLists.txt
sed -i 's/^import/# told after the paper\n&/' make_it.py
runs ninja -C build rod-dist
claim 'so they are where the script is told after the paper' "$status$(grep -c '"raw.txt": ' build/rod/manifest.json)" = 01 \
  -a "$(tar -tzf build/dist/rod.tar.gz | grep -cE '^\./anc/(raw\.txt|make_it\.py)$')" -eq 2
echo 2 >raw.txt
runs make verify DEPTH=traced
claim 'an edit of what the script reads is found without a build' "$status$(says 'verify: sources: raw.txt has other bytes')" = 2yes
runs make
echo 'by hand' >../by_hand.csv
older ../by_hand.csv made.csv
runs make
claim 'an older file in the place of what the script made is told' \
  "$status$(says 'made.csv is not as it was made, or was saved since; build again, and it is made anew')" = 2yes
runs make why
claim 'and why it would be made' "$(says 'what a script of data read or made is another')" = yes
runs make
claim 'the script makes it anew' "$status$(cat made.csv)" = 02
git checkout -q CMakeLists.txt && rm raw.txt make_it.py made.csv

# A label may hold what siunitx prints; what LaTeX does not know is told with the script's line.
sed -i 's/^plot/set xlabel "angle (\\\\si{\\\\degree})"\n&/' figures/period.gp
runs make figure NAME=period
claim 'a figure with a unit of siunitx is drawn alone' "$status" -eq 0 -a -s build/figures/period.png
sed -i 's/si{/unheardof{/' figures/period.gp
line=$(grep -n unheardof figures/period.gp | cut -d : -f 1)
runs make figure NAME=period
claim 'a command that LaTeX does not know is told where the script has it' \
  "$status$(says "figures/period.gp:$line: LaTeX: Undefined control sequence")" = 2yes
runs make
claim 'so does the whole paper, which names the command too' \
  "$status$(says "figures/period.gp:$line, drawn for paper/rod.tex:")$(says 'angle (\unheardof')" = 2yesyes
git checkout -q figures/period.gp
runs ninja -C build pendulum_test
runs ctest --test-dir build
claim 'its test passes' "$status" -eq 0

setsid env --default-signal=INT make watch >watch.log 2>&1 &
watch=$!
for _ in $(seq 600); do
  if grep -q 'waiting for the next save' watch.log; then break; fi
  sleep 0.1
done
pdf_before=$(sha256sum <build/rod/rod.pdf)
sleep 1 # until the folders are watched
cp -p case.toml case.before
sed 's/^angle = 90/angle = 91/' case.toml >case.older
touch -d '2020-01-01' case.older
mv case.older case.toml
for _ in $(seq 300); do
  if [[ $(grep -c 'waiting for the next save' watch.log) -ge 2 ]]; then break; fi
  sleep 0.1
done
kill -INT "-$watch"
wait "$watch"
claim 'make says nothing of a watch that is interrupted' "$(grep -c 'waiting for' watch.log)$(grep -c '^make' watch.log)" = 20
claim 'an older case that is put in its place makes the paper anew' "$(sha256sum <build/rod/rod.pdf)" != "$pdf_before"
mv case.before case.toml
touch case.toml
runs make
setsid make watch >watch.log 2>&1 &
watch=$!
for _ in {1..300}; do
  if grep -q 'waiting for the next save' watch.log; then break; fi
  sleep 0.1
done
kill -KILL "$watch"
wait "$watch" 2>/dev/null
for _ in {1..100}; do
  if ! pgrep -g "$watch" >/dev/null; then break; fi
  sleep 0.1
done
claim 'a watch ends when make is killed' -z "$(pgrep -g "$watch")"
rm watch.log

mv "$scratch/installed paper" "$scratch/moved paper" && cd "$scratch/moved paper" || exit 1
runs make
claim 'where its folder was moved its build folder is made anew, with the same engine' \
  "$status$(says 'this folder was moved, and build is made anew')" = 0yes -a "$(tail -n 1 <<<"$said")" = build/rod/rod.pdf

# Many cases, one of which is not right
mkdir cases
for angle in 80 120 200; do sed "s/^angle = 90/angle = $angle/" case.toml >"cases/angle $angle.toml"; done
runs env 'CASES=cases/*.toml' J=2 KEYS=relative-period ninja -C build rod-reports
claim 'a case that fails is told with its message' \
  "$(says 'angle 200 failed with 2: rod: ')" = yes
claim 'and shows in the exit code' "$status" -ne 0
said=$(cat build/reports/cases.csv)
claim 'all cases stand below one another' "$(cut -d, -f1 build/reports/cases.csv | tr '\n' ' ')" = 'case angle 120 angle 200 angle 80 '
claim 'with exit code, what varies, the chosen value, the number behind it and verdicts' \
  "$(says 'case,exit code,parameter angle,relative-period,"relative-period, unrounded","relative-period, abs_error",claim longer')" = yes
claim 'a case that is computed has all of them' "$(sed -n 2p build/reports/cases.csv | grep -c '^angle 120,0,120,1.37288.*,confirmed,')" -eq 1
claim 'one that failed has its parameters' "$(says 'angle 200,2,200,,,,')" = yes
claim 'each has its PDF and its manifest' -e 'build/reports/angle 80/rod.pdf' -a -e 'build/reports/angle 80/manifest.json'
sed 's/^angle = 90/angle = 30/' case.toml >'cases/angle 30.toml'
runs env 'CASES=cases/angle?30.toml' ninja -C build rod-reports
claim 'of a case with two verdicts that are not the expected ones both are told' \
  "$status $(grep -c '^angle 30 failed with 1: rod: .*: claim .*, not ' <<<"$said") $(grep -c '^angle 30 failed' <<<"$said")" = '1 2 2'

# The engine's scripts by themselves, as the manual says to run them, of either engine
by_script() {
  engine=$(sed -n 's/^engine=//p' build/rod.settings)
  runs "$engine/scripts/case" build/rod.settings "$1" 'one case'
  claim "scripts/case of $engine makes a case" "$status$(cat 'one case/exit_code')" = 00 -a -s 'one case/rod.pdf'
  runs "$engine/scripts/cases" 'one case' --output one.csv --keys relative-period
  claim "scripts/cases of $engine reads it" "$status$(grep -c '^one case,0,1.' one.csv)" = 01
  rm -rf 'one case' one.csv
}
by_script 'cases/angle 120.toml'
cd "$scratch/added paper" || exit 1
by_script case.toml
claim 'the engine of a checkout is its own' "$engine" = "$source_dir/src/literate"
cd "$scratch/moved paper" || exit 1

echo 'At \val{anglee} or so.' >>paper/note.tex
runs ninja -C build rod
claim 'an unknown name stops the paper' "$status" -ne 0
claim 'it is told with its place and the nearest name' \
  "$(says "rod: paper/note.tex:1:4: unknown value 'anglee', did you mean 'angle'?")" = yes
runs make
claim 'with make it is the last that is said' "$(grep -v '^make: ' <<<"$said" | tail -n 1)" = \
  "rod: paper/note.tex:1:4: unknown value 'anglee', did you mean 'angle'?"
rm paper/note.tex
sed -i 's/sum += 1 /sum += 1.0 /' src/pendulum.cpp
runs build/rod_program compute build/rod.settings
claim 'an excerpt that the program was not compiled from ends with 2' "$status" -eq 2
claim 'it is named' "$(says "rod: src/pendulum.cpp: excerpt 'rod-period' is not what this program was compiled from")" = yes
runs ninja -C build rod
claim 'the build compiles it' "$status" -eq 0

sed -i 's/^angle = 90/angle = 200/' case.toml
runs ninja -C build rod
claim 'a parameter that is not right is told with its place' "$(says 'case.toml:2:')" = yes
cd "$scratch" || exit 1

finish
