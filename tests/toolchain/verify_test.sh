#!/bin/sh
# verify finds the same bytes from elsewhere, or names the first file that differs.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/shell_test.sh"
# shellcheck source=tests/toolchain/toy_checkout.sh
. "$(dirname "$0")/toy_checkout.sh"

toy_make verify DEPTH=traced
claim 'traced without a manifest ends with 2' "$status" -eq 2
claim 'it is said what is missing' "$(says "there is no manifest '$toy/build/report/manifest.json': make the paper, or give MANIFEST=, or PDF= alone")" = yes
claim 'nothing was compiled, nor even configured' ! -e "$toy/build/release"
toy_make verify DEPTH=deep
claim 'a depth that there is not ends with 2' "$status" -eq 2
claim 'those that there are are named' "$(says 'DEPTH: there is no depth deep; it is traced, sampled, full or bare')" = yes
claim 'nothing was made before' ! -e "$toy/build/release"
for depth in sampled full; do
  toy_make verify DEPTH=$depth PDF=CMakeLists.txt
  claim "$depth refuses a PDF, which it would not look at" "$status $(says "PDF: DEPTH=traced alone looks at a PDF, and not DEPTH=$depth")" = '2 yes'
done

toy_make verify
claim 'the toy makes the same bytes' "$status" -eq 0
claim 'it says so' "$(says 'the same bytes: 3 files and the PDF')" = yes
claim 'what was handed in before is not claimed' "$(grep -c '^- what was handed in before this run' "$toy/build/report/certificate-full.txt")" = 1
claim 'so does the certificate' "$(grep -c '^- made again: the same bytes' "$toy/build/report/certificate-full.txt")" = 1

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
  claim "the certificate has it" "$(grep -c '^report, full: something differs\|^- verify: generated/tables/t.tex' "$toy/build/report/certificate-full.txt")" -ge 1
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

# A program that computes one claim, where the last argument's settings say.
toy_make verify DEPTH=sampled
claim 'a sample without a manifest that can be read ends with 2' "$status" -eq 2
cat >"$toy/build/release/halfspace-report" <<'END'
#!/bin/sh
output=$(sed -n 's/^output=//p' "$2")
mkdir -p "$output/generated"
echo '{"claims": {"a": {"found": "refuted", "criteria": []}}}' >"$output/generated/names.json"
END
manifest() {
  printf '{"project": "halfspace", "made_with": {}, "inputs": {}, "outputs": {}, "numbers": {}, "verdicts": {"claim a": "%s"}}' "$1" \
    >"$toy/build/report/manifest.json"
}
manifest refuted
toy_make verify DEPTH=sampled
claim 'a claim that is computed again with the same verdict holds' "$status" -eq 0
claim 'it is named' "$(says 'claims computed again: a (drawn by SEED=1)')" = yes
manifest confirmed
toy_make verify DEPTH=sampled CLAIMS=a
claim 'another verdict is found' "$status" -ne 0
claim 'both are told' "$(says 'claim a is refuted, in the manifest confirmed')" = yes

finish
