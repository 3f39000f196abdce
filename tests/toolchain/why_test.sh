#!/bin/sh
# why prints the first cause of a rebuild in one line.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/shell_test.sh"
# shellcheck source=tests/toolchain/toy_checkout.sh
. "$(dirname "$0")/toy_checkout.sh"

toy_make why
claim 'before the first build that is the reason' "$(says 'nothing has been built yet')" = yes
claim 'asking builds nothing' ! -e "$toy/build/release"

toy_make report
claim 'the toy is built' "$status" -eq 0
toy_make why
claim 'after a build there is nothing to do' "$said" = 'nothing to do'

touch -d '1 minute' "$toy/report/sections/a.tex"
toy_make why
claim 'changed prose is named, and what is older' \
  "$said" = 'report/sections/a.tex changed after build/report/report.pdf was made'

# The first edit after a commit changes the state of the repository as well.
touch -d '1 minute' "$toy/build/release/repository/repository.json"
toy_make why
claim 'the edit is named, and not what follows from it' \
  "$said" = 'report/sections/a.tex changed after build/report/report.pdf was made'
touch -d '1 hour ago' "$toy/report/sections/a.tex"
toy_make why
claim 'a commit is named in words' \
  "$said" = 'the commit, or whether files differ from it, is another'
touch "$toy/build/release/repository/repository.json"

touch -d '1 minute' "$toy/report/ruggiero2001.toml"
toy_make why
claim 'the first of two causes is named alone' \
  "$said" = 'report/ruggiero2001.toml changed after build/report/generated/names.json was made'
touch "$toy/report/ruggiero2001.toml" "$toy/report/sections/a.tex"

echo 'E = 31' >"$scratch/other.toml"
toy_make why CASE="$scratch/other.toml"
claim 'another case is a reason' "$said" = "the case is $scratch/other.toml, and was report/ruggiero2001.toml"

# It has a folder of its own, and leaves the report of the first case as it is.
first=$(sha256sum "$toy/build/report/report.pdf")
echo 'E = 31' >"$scratch/a:b c.toml"
toy_make report CASE="$scratch/a:b c.toml"
made=$(printf '%s\n' "$said" | tail -n 1)
claim "another case's report lies beside the first" "${made%%-[0-9]*}" = build/report-a_b_c
claim 'it has the values of its case' "$(cat "$toy/${made%/*}/generated/tables/t.tex")" = 'E = 31'
echo 'E = 32' >"$scratch/a_b:c.toml"
toy_make report CASE="$scratch/a_b:c.toml"
claim 'a name that looks alike has a folder of its own' "$(printf '%s\n' "$said" | tail -n 1)" != "$made"
claim 'the report of the first case is as it was' "$(sha256sum "$toy/build/report/report.pdf")" = "$first"
toy_make report
claim 'make without a case means the first again' "$(says 'build/report/report.pdf')" = yes

toy_make report
rm "$toy/build/report/report.pdf"
toy_make why
claim 'what was removed is named' "$said" = 'build/report/report.pdf is not there'
toy_make report
touch -d '1 minute' "$toy/CMakeLists.txt"
toy_make why
claim 'a changed CMakeLists.txt is named' "$(says 'CMakeLists.txt changed after')" = yes
touch "$toy/CMakeLists.txt"
toy_make report

# Generated files are watched too
echo forged >"$toy/build/report/generated/tables/t.tex"
toy_make why
claim 'a file changed by hand is named' "$said" = 'build/report/generated/tables/t.tex was changed by hand or damaged'
toy_make report
claim 'it is made again, and it says so' \
  "$(says 'build/report/generated/tables/t.tex: changed by hand or damaged; made again')" = yes
claim 'nothing of it is left' "$(cat "$toy/build/report/generated/tables/t.tex")" = 'E = 30'
toy_make report
claim 'once is enough' "$(says 'by hand')" = no

# Results that were computed before drawing failed differ from the list of those before.
mkdir -p "$toy/build/report/state"
echo '# done' >"$toy/build/report/state/compute"
echo 'E = 29' >"$toy/build/report/generated/tables/t.tex"
toy_make report
claim 'what was computed before drawing failed was not changed by hand' "$(says 'by hand')" = no
claim 'it is computed again' "$(cat "$toy/build/report/generated/tables/t.tex")" = 'E = 30'

finish
