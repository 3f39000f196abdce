#!/usr/bin/env bash
# alone_test.sh SOURCE INSTALLED: the engine by itself, as who takes nothing else of the repository builds it, passes its own
# tests. Its libraries are those that installed_test.sh has compiled.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
cd "$2" || exit 1
unset MAKEFLAGS MFLAGS MAKELEVEL CALLER CASE CASES J KEYS NAME TARGET V MANIFEST GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE

runs cmake -S "$source_dir/src/literate" -B engine -G Ninja -DBUILD_TESTING=ON -DCMAKE_CXX_FLAGS_RELEASE=-O0
claim 'the engine is configured by itself' "$status" -eq 0
runs cmake --build engine --parallel "$(nproc)"
claim 'it is built with its tests' "$status" -eq 0
# The slow ones are the same programs as in the whole repository, which runs them itself, as it does those that need none.
runs ctest --test-dir engine --label-exclude '^(slow|script)$' --output-on-failure
claim 'all of them pass' "$status" -eq 0
claim 'they are those of the engine and of what it stands on' \
  "$(says unit/literate/main/main)" = yes -a "$(says unit/system/)" = yes -a "$(says unit/config/)" = yes

finish
