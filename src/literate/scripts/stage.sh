# shellcheck shell=sh
# To be sourced: the form in which every stage prints its time. It computes with integers, so that no locale can change
# the decimal point.

# now: nanoseconds.
now() { date +%s%N; }

# stage_line NAME BEGIN
stage_line() {
  stage_tenths=$((($(now) - $2 + 50000000) / 100000000))
  printf '%-9s %5d.%d s\n' "$1" $((stage_tenths / 10)) $((stage_tenths % 10))
}
