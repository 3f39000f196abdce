#!/bin/sh
# verify finds the same bytes from elsewhere, or names the first file that differs.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/shell_test.sh"
# shellcheck source=tests/toolchain/toy_checkout.sh
. "$(dirname "$0")/toy_checkout.sh"

toy_make verify
claim 'the toy makes the same bytes' "$status" -eq 0
claim 'it says so' "$(says 'the same bytes: 3 files and the PDF')" = yes

mkdir "$scratch/my cases"
echo 'E = 31' >"$scratch/my cases/other.toml"
toy_make verify CASE="$scratch/my cases/other.toml"
claim 'a case from elsewhere is verified too' "$status" -eq 0

git -C "$toy" init -q
printf 'build/\n' >"$toy/.gitignore"
git -C "$toy" add -A
git -C "$toy" -c user.name=t -c user.email=t@example.org -c commit.gpgsign=false commit -qm first
commit=$(git -C "$toy" rev-parse HEAD)
cat >"$toy/compute" <<'END'
#!/bin/sh
mkdir -p "$2/tables"
printf 'E = 30\n' >"$2/tables/t.tex"
git -C "$(dirname "$0")" status --porcelain=v2 --branch | grep -v '^# branch.head' >"$2/names.json"
END
toy_make verify
claim 'the copy has the commit and the changes of the checkout' "$status" -eq 0
claim 'they were looked at' "$(grep -c "oid $commit" "$toy/build/report/generated/names.json")" = 1

# Folder, time zone, locale and permissions must not matter.
for what in pwd 'date +%Z' 'locale decimal_point' umask 'basename "$HOME"'; do
  printf '#!/bin/sh\nmkdir -p "$2/tables"\necho "first\n$(%s)" >"$2/tables/t.tex"\necho 1 >"$2/names.json"\n' \
    "$what" >"$toy/compute"
  toy_make verify
  claim "a report that depends on '$what' is found out" "$status" -ne 0
  claim "the file is named for '$what', with its line" "$(says 'generated/tables/t.tex differs: line 2')" = yes
done

mkdir "$scratch/without locales"
printf '#!/bin/sh\nexit 1\n' >"$scratch/without locales/localedef"
chmod +x "$scratch/without locales/localedef"
path=$PATH
PATH="$scratch/without locales:$PATH"
toy_make verify
PATH=$path
claim 'without a decimal comma nothing is verified' "$status" -ne 0
claim 'it is said what to install' "$(says 'localedef needs the Debian package locales')" = yes

toy_make verify MANIFEST=none.json
claim 'a manifest that is not there ends with 2' "$status" -eq 2
claim 'it is named' "$(says 'MANIFEST: there is no file none.json')" = yes
# The program judges it: manifest_test and report_test.
printf '#!/bin/sh\necho "$1 $3 $4"\n' >"$toy/build/release/halfspace-report"
chmod +x "$toy/build/release/halfspace-report"
echo '{}' >"$toy/one.json"
toy_make verify MANIFEST=one.json
claim 'the program compares the report with a manifest that is there' "$(says "typeset --against $toy/one.json")" = yes

finish
