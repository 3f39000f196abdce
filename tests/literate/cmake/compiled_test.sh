#!/usr/bin/env bash
# compiled_test.sh SOURCE: a source that is saved while it is compiled is compiled again, and a record tells what was.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
mkdir -p "$scratch/my paper/src" && cd "$scratch/my paper" || exit 1

# A compiler that, when it is done, finds that one of these files was saved meanwhile, once or each time.
cat >../late <<'END'
#!/usr/bin/env bash
"$@" || exit
if [[ -e "$SCRATCH/once" ]]; then mv -- "$SCRATCH/once" "$SCRATCH/my paper/src/a b.hpp"; fi
if [[ -e "$SCRATCH/always" ]]; then touch -- "$SCRATCH/my paper/src/main.cpp"; fi
END
chmod +x ../late
export SCRATCH=$scratch
cat >CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.25)
project(compiled LANGUAGES CXX)
include("$source_dir/src/literate/cmake/AddPaper.cmake")
file(WRITE "\${CMAKE_BINARY_DIR}/made.hpp" "")
add_executable(compiled src/main.cpp)
target_include_directories(compiled PRIVATE "\${CMAKE_BINARY_DIR}")
literate_map_prefix(compiled "\${PROJECT_SOURCE_DIR}")
END
echo 'const int number = 1;' >'src/a b.hpp'
printf '#include <cstdio>\n#include "a b.hpp"\n#include "made.hpp"\nint main() { std::printf("%%d", number); }\n' >src/main.cpp
record=build/CMakeFiles/compiled.dir/src/main.cpp.o.sha256

runs cmake -S . -B build -G Ninja "-DCMAKE_CXX_COMPILER_LAUNCHER=$scratch/late" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
runs cmake --build build
claim "the record has the paper's files that were read, and no others" "$(sort <"$record")" = "$(sha256sum "$PWD"/src/* | sort)"
claim 'tools that read the commands see the compiler alone' "$(grep -c 'scripts/compile' build/compile_commands.json)" -eq 0
echo 'const int number = 2;' >'src/a b.hpp'
echo 'const int number = 3;' >../once
runs cmake --build build
claim 'a file that is saved while it is read is told' "$status$(says 'a b.hpp was saved while it was compiled; it is compiled again')" = 0yes
runs build/compiled
claim 'and is what the program was compiled from' "$said" = 3
claim 'the record says so' "$(sort <"$record")" = "$(sha256sum "$PWD"/src/* | sort)"
touch src/main.cpp ../always
runs cmake --build build
claim 'one that is saved each time ends with an error' "$status$(grep -c 'is compiled again' <<<"$said")" = 15
rm ../always
runs cmake --build build
claim 'and is compiled by the next build' "$status$(says Building)" = 0yes

finish
