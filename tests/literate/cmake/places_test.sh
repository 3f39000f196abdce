#!/usr/bin/env bash
# places_test.sh SOURCE: a program names its source files from the paper's folder on, wherever it is built and whether the
# compiler was told whole names or, as by ccache with a base_dir, names that begin at the build folder.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
mkdir -p "$scratch/my paper/src/deep" && cd "$scratch/my paper" || exit 1

cat >CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.25)
project(places LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
include("$source_dir/src/literate/cmake/AddPaper.cmake")
add_library(used STATIC src/deep/used.cpp)
add_executable(places src/main.cpp)
target_include_directories(places PRIVATE src/deep)
target_link_libraries(places PRIVATE used)
literate_map_prefix(places "\${PROJECT_SOURCE_DIR}")
END
echo '#include <source_location>
inline const char* header() { return std::source_location::current().file_name(); }
const char* used();' >src/deep/used.hpp
echo '#include <source_location>
const char* used() { return std::source_location::current().file_name(); }' >src/deep/used.cpp
# shellcheck disable=SC2028  # the program has the escape
echo '#include <cstdio>
#include "used.hpp"
int main() { std::printf("%s %s %s\n", std::source_location::current().file_name(), header(), used()); }' >src/main.cpp

# What ccache does to the names, for machines that have none
cat >../relative <<'END'
#!/usr/bin/env bash
for word; do
  shift
  case $word in
    "$CCACHE_BASEDIR"/*) word=$(realpath -m --relative-to=. -- "$word") ;;
    -I"$CCACHE_BASEDIR"/*) word=-I$(realpath -m --relative-to=. -- "${word#-I}") ;;
  esac
  set -- "$@" "$word"
done
exec "$@"
END
chmod +x ../relative

export CCACHE_BASEDIR="$scratch" CCACHE_DIR="$scratch/cache"
for launcher in '' "$scratch/relative" "$(command -v ccache)"; do
  for build in build 'deep/er/build' '../another build'; do
    runs cmake -S . -B "$build" -G Ninja "-DCMAKE_CXX_COMPILER_LAUNCHER=$launcher"
    runs cmake --build "$build" --clean-first
    runs "$build/places"
    claim "places begin at the paper's folder, built in '$build' through '$launcher'" \
      "$said" = 'src/main.cpp src/deep/used.hpp src/deep/used.cpp'
  done
done

finish
