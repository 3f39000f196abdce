#!/usr/bin/env bash
# Gradescope runs this script once, as root in /autograder/source. It compiles the grader and the toolkit.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
here=$PWD
autograder=${AUTOGRADER:-/autograder}

# An older system has neither the compiler nor the bubblewrap that are needed.
# shellcheck source=/dev/null
release=$(. "${OS_RELEASE:-/etc/os-release}" && printf '%s %s' "$ID" "${VERSION_ID%%.*}")
case $release in
  'ubuntu 2'[4-9] | 'ubuntu '[3-9][0-9] | 'debian 1'[2-9] | 'debian '[2-9][0-9]) ;;
  *)
    echo "setup.sh: this is ${release}; choose the base image Ubuntu 24.04 or newer in the autograder's configuration" >&2
    exit 2
    ;;
esac

# The packages of grading, without TeX.
if [[ -z ${IS_SET_UP:-} ]]; then
  packages=$(awk '$2 ~ /^(build|draw|course)$/ && $1 !~ /^(#|texlive)/ { sub(/[|].*/, "", $1); print $1 }' halfspace/src/toolchain/packages.txt)
  apt-get update
  # shellcheck disable=SC2086  # one word a package
  DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $packages python3
fi
cmake -S halfspace -B halfspace/build/release -G Ninja -DCMAKE_BUILD_TYPE=Release -DHALFSPACE_PARTS=course
ninja -C halfspace/build/release halfspace-course
halfspace/build/release/halfspace-course toolkit --assignment halfspace/report/assignment --source halfspace \
  --output "$autograder/toolkit"

# Submissions run as another user, who can read the toolkit but neither the checks nor the seed.
chmod -R go-rwx "$here"
