#!/bin/sh
# The example of src/literate/README.md makes its paper, with its numbers, claims and data.
set -eu
program=$1
checkout=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$program" "$checkout" "$folder/my paper"
text=$(pdftotext -layout "$folder/my paper/pendulum.pdf" -)

# K(sin 45°)·2/π = 1.180340599016… (Abramowitz & Stegun, table 17.1: K = 1.854074677301372)
for wanted in '1.180 340 599 02' '18.0 %' 'confirmed' 'refuted' 'pendulum.cpp' '1.180 340 60'; do
  case $text in
    *"$wanted"*) ;;
    *) echo "not in the PDF: $wanted" >&2; printf '%s\n' "$text" >&2; exit 1 ;;
  esac
done
pdfdetach -list "$folder/my paper/pendulum.pdf" | grep -q 'figures/period/periods.csv'
