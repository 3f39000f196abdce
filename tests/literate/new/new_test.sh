#!/usr/bin/env bash
# new_test.sh SOURCE PROGRAM: what `literate new` writes, and what it refuses.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
literate=$2
cd "$scratch" || exit 1

runs "$literate" new rod
claim 'a paper is written' "$status" -eq 0
claim 'it says how to go on' "$said" = 'rod: cd there and run make'
claim 'it has all files of the template' "$(find rod -type f | wc -l)" -eq \
  "$(find "$source_dir/src/literate/template" -type f | wc -l)"
claim 'its files bear its name' -e rod/paper/rod.tex
claim 'their text does, too' "$(grep -c 'literate_add_paper(NAME rod PROGRAM rod_program' rod/CMakeLists.txt)" -eq 1
claim "the template's own name is nowhere" -z "$(grep -rl mypaper rod; find rod -name '*mypaper*')"
claim 'nothing lies beside it' "$(ls -A)" = rod
run_yaml='import sys, yaml; print(*yaml.safe_load(open(sys.argv[1]))["jobs"])'
runs /usr/bin/python3 -c "$run_yaml" rod/.github/workflows/ci.yml
claim 'its continuous integration is YAML with a job' "$said" = debian-12
runs /usr/bin/python3 -c "$run_yaml" rod/.github/workflows/pages.yml
claim 'its site is published by two jobs' "$said" = 'site deploy'

# A CMake that writes down what it is asked.
mkdir bin
printf '#!/bin/sh\nprintf "%%s\\n" "$@" >"%s/asked"\n' "$scratch" >bin/cmake
chmod +x bin/cmake
cp rod/case.toml 'rod/steel rod.toml'
runs env -u CASE PATH="$scratch/bin:$PATH" make -C rod configured
claim 'the case of the paper is made in its folder' "$(grep -c -- '^-Urod_OUTPUT$' asked)" -eq 1
runs env PATH="$scratch/bin:$PATH" make -C rod configured CASE='steel rod.toml'
claim 'another case is made beside it' "$(grep -c -- '^-Drod_OUTPUT:PATH=/.*/build/rod-steel rod$' asked)" -eq 1
mkdir -p rod/build
printf 'rod_CASE:FILEPATH=%s\n' "$(realpath rod/case.toml)" >rod/build/CMakeCache.txt
rm -f asked
runs env -u CASE PATH="$scratch/bin:$PATH" make -C rod configured
claim 'a configuration that failed is tried again' -e asked

# A CMake that ends when another make says that it waits; without a turn the two would run at once.
cat >bin/cmake <<END
#!/bin/sh
echo begin >>"$scratch/turns"
for _ in \$(seq 100); do
  if grep -qs waits "$scratch/second" || [ "\$(wc -l <"$scratch/turns")" -gt 1 ]; then break; fi
  sleep 0.1
done
echo end >>"$scratch/turns"
END
rm -rf rod/build
env -u CASE PATH="$scratch/bin:$PATH" make -C rod configured >/dev/null 2>&1 &
for _ in {1..200}; do [[ ! -s turns ]] || break; sleep 0.05; done
env PATH="$scratch/bin:$PATH" make -C rod configured CASE='steel rod.toml' >second 2>&1
wait
claim 'two makes at once have their turns' "$(tr '\n' ' ' <turns)" = 'begin end begin end '
claim 'the second one says that it waits' "$(grep -c 'another make runs here, and this one waits for it' second)" -eq 1
rm -rf bin asked turns second 'rod/steel rod.toml' rod/build rod/build.log

commit=$(git -C "$source_dir" rev-parse HEAD 2>/dev/null | cut -c 1-12)
for workflow in ci pages; do
  claim "the $workflow takes the engine that made the paper" \
    "$(grep -c "ENGINE_COMMIT: \"${commit:-unknown}\"" rod/.github/workflows/$workflow.yml)" -eq 1
done

mkdir empty
runs "$literate" new empty
claim 'a folder that is empty will do' "$status" -eq 0

runs "$literate" new rod
claim 'a folder with files in it is refused with 2' "$status" -eq 2
claim 'it is named in one line' "$said" = "literate: 'rod' exists and is not empty"
echo text >file
runs "$literate" new file
claim 'a file is refused with 2' "$status" -eq 2

runs "$literate" new 'my paper'
claim 'a name that CMake could not take is refused with 2' "$status" -eq 2
claim 'it is named, with what to do' \
  "$said" = "literate: 'my paper' cannot name a paper: a letter, then letters, digits, '-' and '_'; give another --name"
claim 'nothing was made' ! -e 'my paper'
runs "$literate" new 'my paper' --name beam
claim 'another name may be given' "$status" -eq 0
claim 'the files bear it' -e 'my paper/paper/beam.tex'

for taken in all test install help clean package literate; do
  runs "$literate" new "$taken"
  claim "the name $taken, which is taken, is refused with 2" "$status" -eq 2
  claim "the line says why $taken is refused" \
    "$said" = "literate: '$taken' cannot name a paper: CMake has a target of this name; give another --name"
  claim "there is no folder $taken" ! -e "$taken"
done
# refusal ARGUMENT…: what literate_add_paper says to these.
refusal() {
  printf '%s\n' "include(\"$source_dir/src/literate/cmake/AddPaper.cmake\")" \
    "literate_add_paper(PROGRAM none DOCUMENT paper MAIN a.tex CASE case.toml SOURCES src $*)" >refused.cmake
  runs cmake -P refused.cmake
}
refusal NAME test
claim 'CMake refuses the same names' "$(says 'NAME test is that of another target')" = yes
refusal NAME '"my paper"'
claim 'and names that are none' "$(says 'NAME my paper cannot name targets')" = yes
refusal NAME rod ENGINE xelatex
claim 'an engine that it does not know is named' "$(says 'ENGINE xelatex is neither pdflatex nor lualatex')" = yes

# A paper and its slides are two calls with one program.
mkdir -p two/src two/talk
printf '// begin excerpt: %s\nint x;\n// end excerpt: %s\n' a a >two/src/a.cpp
printf '// begin excerpt: %s\nint x;\n// end excerpt: %s\n' b b >two/talk/b.cpp
touch two/case.toml two/make_it.py two/raw.txt
cat >two/main.cpp <<'END'
#include <cstdio>
#include "literate/main/paper.hpp"
int main() {
  const literate::Paper& paper = literate::this_paper();
  for (const auto& folder : paper.source_folders) std::printf("%s ", folder.c_str());
  for (const char c : paper.excerpts) {
    if (c == '\n') std::printf("line ");
  }
}
END
cat >two/CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.25)
project(two VERSION 1 LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
add_library(engine INTERFACE)
target_include_directories(engine INTERFACE "$source_dir/src")
add_library(literate::literate ALIAS engine)
add_executable(literate::program IMPORTED)
set_target_properties(literate::program PROPERTIES IMPORTED_LOCATION "$literate")
include("$source_dir/src/literate/cmake/AddPaper.cmake")
add_executable(both main.cpp)
literate_run_script(MAKES made.csv COMMAND python3 make_it.py READS raw.txt)
literate_add_paper(NAME paper PROGRAM both DOCUMENT paper MAIN paper.tex CASE case.toml SOURCES src DATA made.csv)
literate_add_paper(NAME slides PROGRAM both DOCUMENT slides MAIN slides.tex CASE case.toml SOURCES src talk)
END
runs cmake -S two -B two/build -G Ninja
claim 'CMake takes two papers from one program' "$status" -eq 0
claim 'the stages know what runs the script of data, and what it reads' \
  "$(grep -E '^(reads|tools)=' two/build/paper.settings | sed "s|$scratch/||g" | tr '\n' ' ')" = 'reads=two/make_it.py:two/raw.txt tools=python3 '
runs ninja -C two/build both
claim 'their program links' "$status" -eq 0
runs two/build/both
claim 'it knows the code and the excerpts of both' "$said" = 'src talk line line '
runs ninja -C two/build -t commands slides-made
claim 'it is told which of them to compute' "$(says '/slides.settings')" = yes

# A script that went away is noticed by the list of those that are there: nothing that is there would be newer.
runs ninja -C two/build -t inputs paper-made
claim 'drawing depends on the list of scripts' "$(says generated/paper/scripts.list)" = yes
mkdir two/figures
touch two/figures/a.gp
runs ninja -C two/build build.ninja
claim 'a new script is listed' "$(grep -c 'figures/a.gp$' two/build/generated/paper/scripts.list)" -eq 1
rm two/figures/a.gp
runs ninja -C two/build build.ninja
claim 'one that is gone is not' "$(grep -c 'figures/a.gp$' two/build/generated/paper/scripts.list)" -eq 0

touch two/figures/b.gp
runs bash "$source_dir/src/literate/scripts/ninja" two/build/paper.settings build.ninja
claim 'CMake does not say what it does then' "$status$said" = 0

# What the page alone reads does not typeset the paper again.
mkdir two/paper
touch two/paper/paper.tex
runs ninja -C two/build build.ninja
touch two/paper/page.tex
runs ninja -C two/build build.ninja
runs ninja -C two/build -t inputs paper-made
claim 'the paper depends on its prose' "$(says two/paper/paper.tex)" = yes
claim 'and not on the preamble of the page' "$(says two/paper/page.tex)" = no
claim 'nor on a list of files that names it' "$(grep -c page.tex two/build/generated/paper/document.list)" -eq 0
runs ninja -C two/build -t inputs paper-html
claim 'the page does' "$(says two/paper/page.tex)" = yes

runs "$literate" new
claim 'without a folder it ends with 2' "$status" -eq 2
runs "$literate" new no/such/place
claim 'folders above are made' "$status" -eq 0

finish
