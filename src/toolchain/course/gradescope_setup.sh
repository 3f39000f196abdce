#!/usr/bin/env bash
# Gradescope runs this script once, as root in /autograder/source. It compiles the grader and the toolkit.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
here=$PWD
autograder=${AUTOGRADER:-/autograder}

# These are the packages of the report except for TeX, and those of grading.
if [[ -z ${IS_SET_UP:-} ]]; then
  packages=$(awk '$2 == "report" && $1 !~ /^(texlive|latexmk|lmodern|#)/ { print $1 }' \
    halfspace/src/toolchain/packages.txt)
  apt-get update
  # shellcheck disable=SC2086  # one word a package
  DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $packages \
    bubblewrap libarchive-tools libpugixml-dev libseccomp-dev gnuplot-nox python3
fi
cmake -S halfspace -B halfspace/build/release -G Ninja -DCMAKE_BUILD_TYPE=Release
ninja -C halfspace/build/release halfspace-course
halfspace/build/release/halfspace-course toolkit --assignment halfspace/report/assignment --source halfspace \
  --output "$autograder/toolkit"

# Submissions run as another user, who can read the toolkit but neither the checks nor the seed.
chmod -R go-rwx "$here"
