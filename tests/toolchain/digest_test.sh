#!/bin/sh
# WriteDigest.cmake changes its file if and only if something below the folder changes.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/shell_test.sh"

folder=$scratch/generated
digest=$scratch/digest
mkdir -p "$folder/tables"
echo 1 >"$folder/values.tex"
echo 2 >"$folder/tables/a b.tex"

write() {
  runs cmake "-DFOLDER=$folder" "-DOUTPUT=$digest" -P "$source_dir/src/literate/cmake/WriteDigest.cmake"
}
is_rewritten() { [ "$(stat -c %Y "$digest")" = "$old" ] && echo no || echo yes; }
age() {
  touch -d 2001-04-23 "$digest"
  old=$(stat -c %Y "$digest")
}

write
claim 'the digest has the form that sha256sum checks' \
  "$(cd "$folder" && sha256sum --quiet -c "$digest" && wc -l <"$digest")" = 2

age
touch "$folder/values.tex"
write
claim 'a new time stamp alone changes nothing' "$(is_rewritten)" = no

echo 3 >"$folder/tables/a b.tex"
write
claim 'changed content does' "$(is_rewritten)" = yes

age
rm "$folder/values.tex"
write
claim 'a file that went does' "$(is_rewritten)" = yes

finish
