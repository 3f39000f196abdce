# shellcheck shell=sh
# Sourced: the one form in which every stage tells its time. Integers only, so no locale can turn the point.

# now: nanoseconds.
now() { date +%s%N; }

# stage_line NAME BEGIN
stage_line() {
  stage_tenths=$((($(now) - $2 + 50000000) / 100000000))
  printf '%-9s %5d.%d s\n' "$1" $((stage_tenths / 10)) $((stage_tenths % 10))
}
