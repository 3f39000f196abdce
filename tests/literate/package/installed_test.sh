#!/usr/bin/env bash
# installed_test.sh SOURCE INSTALLED: the engine alone, built and installed by the manual's commands below the folder
# INSTALLED, where the tests that need an installed engine find it.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
unset MAKEFLAGS MFLAGS MAKELEVEL CALLER CASE CASES J KEYS NAME TARGET V MANIFEST GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE
mkdir -p "$2" && cd "$2" || exit 1
rm -rf 'usr local'

# The engine alone is configured by its own packages, built and installed, by the manual's commands, but in other folders and
# by a compiler in a hurry.
CMAKE_BUILD_PARALLEL_LEVEL=$(nproc)
export CMAKE_BUILD_PARALLEL_LEVEL
python3 -B "$source_dir/tests/literate/manual/manual.py" "$source_dir/src/literate/README.md" 'Install: sh' |
  sed -e 's/ *#.*//' -e "s|src/literate|'$source_dir/src/literate'|" -e 's|build/engine|engine|g' \
  -e "s|~/.local|'$2/usr local'|" -e 's|-DBUILD_TESTING=OFF|& -DCMAKE_CXX_FLAGS_RELEASE=-O0|' >install.sh
runs bash -e install.sh
claim 'the engine is configured by itself, built and installed' "$status" -eq 0
asked=$(sed -n 's/^\(FFTW3\|benchmark\)_.*=.*/\1/p' engine/CMakeCache.txt)
claim "no other folder's packages are looked for" -z "$asked"
claim 'no header names a folder of this machine' -z "$(grep -rl "$source_dir" 'usr local/include' 'usr local/share')"

finish
