#!/usr/bin/env bash
# certify_test.sh SOURCE: each depth of verifying finds what it promises, and says what it did not look at.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
unset CLAIMS MANIFEST PDF SEED
need python3 pdfdetach qpdf
cd "$scratch" || exit 1
mkdir -p rod/src rod/out/generated/tables rod/out/state "rod/figures"
cd rod || exit 1

# A paper of one value, one table and three claims, as the engine leaves it.
printf 'project(rod VERSION 1.2 LANGUAGES CXX)\n' >CMakeLists.txt
echo 'int one = 1;' >src/one.cpp
echo 'plot 1' >figures/f.gp
echo 'side = 3' >case.toml
mkdir -p out/generated/figures/f
cp figures/f.gp out/generated/figures/f/script.gp
printf 'key,printed,number\nlength,3 m,3\n' >out/generated/values.csv
echo '1 & 2' >out/generated/tables/t.tex
claims() {
  for id in a b c d; do
    printf '%s"%s": {"found": "%s", "criteria": [{"name": "n", "limit": "≤ %s", "outcome": "holds", "found": "0.5"}]}' "${comma-}" $id "$1" "$2"
    comma=', '
  done
}
names() {
  printf '{"values": {"length": {"number": 3.0, "printed": "3 m", "abs_error": 0.5, "standard": 0.25, "unit": "m"}}, "cells": {}, "flags": {"wet": true}, "words": {"claim a: route": "by eye"}, "checks": {"k": {"passed": true}}, "claims": {%s}}' \
    "$(claims "$@")"
}
names confirmed 1 >out/generated/names.json
(cd out/generated && sha256sum values.csv figures/f/script.gp | sed -E 's|^(\S+)  (figures/.*)|# \2:\n\1  figures-f-script.gp|' >attached.sha256)
attach() {
  qpdf --empty --add-attachment out/generated/values.csv -- --add-attachment out/generated/attached.sha256 -- \
    --add-attachment "${1:-out/generated/figures/f/script.gp}" --filename=figures-f-script.gp -- --deterministic-id "${2:-out/rod.pdf}"
}
attach
echo '{"seconds": 1.25, "cpu_seconds": 2.5, "peak_memory_mb": 7}' >out/state/compute.costs
python3 - <<'END'
import hashlib, json, pathlib
sha = lambda file: hashlib.sha256(pathlib.Path(file).read_bytes()).hexdigest()
made = ["rod.pdf"] + [str(file.relative_to("out")) for file in pathlib.Path("out/generated").rglob("*") if file.is_file()]
ids = "abcd"
json.dump({"project": "rod", "made_with": {"sources": {"version": "1.2", "commit": "unknown"}},
           "inputs": {file: sha(file) for file in ["src/one.cpp", "figures/f.gp", "case.toml"]},
           "outputs": {file: sha("out/" + file) for file in made},
           "numbers": {"length": {"number": 3, "printed": "3 m", "abs_error": 0.5, "standard": 0.25}},
           "units": {"length": "m"},
           "outcomes": {f"claim {id}: n": "holds" for id in ids},
           "texts": {"flag wet": "yes"} | {f"claim {id}: n": "0.5" for id in ids},
           "words": {"claim a: route": "by eye"},
           "verdicts": {"check k": "passed"} | {f"claim {id}": "confirmed" for id in ids},
           "limits": {f"claim {id}: n": "≤ 1" for id in ids}}, open("out/manifest.json", "w"), indent=1)
END
cp -r out whole

more=() # settings
certify() {
  runs env "${@:2}" python3 -B "$source_dir/src/literate/scripts/certify" "$1" name=rod project=rod root="$PWD" output="$PWD/out" \
    case="$PWD/case.toml" "${more[@]}"
}
certificate=out/certificate-traced
json() { python3 -c 'import json, sys; print(eval(sys.argv[2], {"c": json.load(open(sys.argv[1]))}))' "$certificate.json" "$1"; }

TIMEFORMAT=%U
seconds=$({ time certify traced; } 2>&1)
claim 'traced takes less than a second of the processor' "${seconds%.*}" -eq 0
certify traced
claim 'what is as it was made holds' "$status" -eq 0
cp -r out kept
certify traced MANIFEST=case.toml
claim 'where nothing could be looked at no certificate of an earlier run is left' ! -e $certificate.txt -a ! -e $certificate.json
rm -r out && mv kept out
claim 'the certificate says what was checked' "$(json 'sorted(c["checked"])')" = \
  "['PDF', 'attachments', 'generated files', 'limits', 'outcomes', 'sources', 'texts', 'values', 'verdicts', 'words']"
claim 'and what was not' "$(json '"nothing was compiled" in c["not_checked"][0]')" = True
claim 'it has the form of CODECHECK' "$(json 'c["manifest"][0]["file"], c["summary"]')" = "('rod.pdf', 'rod, traced: it holds')"
claim 'and what the making had cost' "$(json 'c["costs"]["compute"]["cpu_seconds"]')" = 2.5
claim 'the text has the same' "$(grep -c -e '^rod, traced: it holds' -e '^- sources: 3 of 3' -e '2.5 s of processor, 7 MB' $certificate.txt)" -eq 3
claim 'without git the commit is not known' "$(grep -c 'commit: not known' $certificate.txt)" -eq 1

# tampered WHAT SAID COMMAND…: traced finds one thing, and names it.
tampered() {
  cp -r src figures case.toml "$scratch"
  eval "$3"
  certify traced
  claim "$1 that was tampered with is found" "$status" -eq 1
  claim "$1 is named" "$(says "$2")" = yes
  rm -rf out src figures
  cp -r whole out
  mv "$scratch/src" "$scratch/figures" "$scratch/case.toml" .
}
tampered 'a PDF' 'PDF: rod.pdf has other bytes' 'echo "% more" >>out/rod.pdf'
tampered 'a value' 'generated files: generated/names.json has other bytes' 'sed -i s/3.0/4.0/ out/generated/names.json'
tampered 'a value of the manifest' \
  'values: length is 3.0 (3 m; abs_error 0.5; standard 0.25; m), in the manifest 4.0 (3 m; abs_error 0.5; standard 0.25; m)' \
  'sed -i "s/\"number\": 3/\"number\": 4/" out/manifest.json'
tampered 'an uncertainty of the manifest' 'abs_error 0.5; standard 0.25; m), in the manifest 3.0 (3 m; abs_error 0.5; standard 0.1; m)' \
  'sed -i "s/0.25/0.1/" out/manifest.json'
tampered 'a unit of the manifest' 'standard 0.25; km)' 'sed -i "s/\"length\": \"m\"/\"length\": \"km\"/" out/manifest.json'
tampered 'a flag of the manifest' 'texts: flag wet is yes, in the manifest no' 'sed -i "/flag wet/s/yes/no/" out/manifest.json'
tampered 'what a criterion found' 'texts: claim c: n is 0.5, in the manifest 0.7' 'sed -i "/claim c: n/s/0.5/0.7/" out/manifest.json'
tampered 'an outcome of the manifest' 'outcomes: claim c: n is holds, in the manifest fails' 'sed -i "/claim c: n/s/holds/fails/" out/manifest.json'
tampered 'a route of the manifest' 'words: claim a: route is by eye, in the manifest by ear' 'sed -i "s/by eye/by ear/" out/manifest.json'
tampered 'a verdict of the manifest' 'verdicts: claim b is confirmed, in the manifest refuted' 'sed -i "/claim b/s/confirmed/refuted/" out/manifest.json'
tampered 'a table' 'generated files: generated/tables/t.tex has other bytes' 'echo "1 & 3" >out/generated/tables/t.tex'
tampered 'a table that was put beside' 'generated/tables/u.tex is not recorded' 'echo 1 >out/generated/tables/u.tex'
tampered 'a source' 'sources: src/one.cpp has other bytes' 'echo "int one = 2;" >src/one.cpp'
tampered 'a source that is gone' 'sources: src/one.cpp is not there' 'rm src/one.cpp'
tampered 'a case' 'sources: case.toml has other bytes' 'echo "side = 4" >case.toml'
tampered 'an attachment' 'attachments: figures-f-script.gp has other bytes' 'echo "plot 2" >"$scratch/other"; attach "$scratch/other"'

certify traced PDF=none.pdf
claim 'a PDF that is not there is bad input' "$status $(says "PDF: there is no file 'none.pdf'")" = '2 yes'
more=('said=cannot read none.json' status=2)
certify full MANIFEST=none.json
claim 'where a manifest cannot be read nothing is said to differ' "$status $(says 'full: not all could be told') $(says differs)" = '2 yes no'
sed 's/"commit": "[^"]*"/"commit": "of another"/' out/manifest.json >theirs.json
more=($'said=typeset     0.4 s  rod.pdf\n3 files have the bytes that theirs.json tells of' status=0)
certify full MANIFEST=theirs.json
claim 'a comparison with a manifest is called one, without the progress of stages' \
  "$(grep -c "^- compared with 'theirs.json': 3 files have the bytes that theirs.json tells of$" out/certificate-full.txt)" -eq 1
claim 'it is not called made again' "$(grep -c '^- made again' out/certificate-full.txt) $(grep -c '^- .*nothing was made again' out/certificate-full.txt)" = '0 1'
claim 'the files and the commit told are those of the paper here' "$(grep -c -e '^- manifest.json: ' -e 'of another' out/certificate-full.txt)" -eq 1
more=($'said=rod: compiler: GNU 12 there, GNU 13 here\nverify: one: 1 there, 2 here' status=1)
certify full MANIFEST=theirs.json
claim 'each difference is a line' "$(sed -n '/^Differs/,/^$/p' out/certificate-full.txt | grep -c '^- ')" -eq 2
more=()
rm theirs.json

# A reviewer who has the PDF.
cp whole/rod.pdf "$scratch/paper.pdf"
mv out gone
certify traced PDF="$scratch/paper.pdf"
claim 'a PDF alone is held against its own list' "$status" -eq 0
claim 'its scripts are held against the checkout' "$(says 'files of the checkout beside those attached: 1 of 1')" = yes
claim 'and its pages were not checked' "$(grep -c 'the pages of the PDF' $certificate.txt)" -eq 1
certify traced PDF="$scratch/paper.pdf" MANIFEST=whole/manifest.json
claim 'with the manifest its values are' "$status $(says 'values: 1 of 1') $(says 'attachments: 3 of 3')" = '0 yes yes'
echo 'plot 2' >"$scratch/other"
cp -r whole/generated out
attach "$scratch/other" "$scratch/paper.pdf"
certify traced PDF="$scratch/paper.pdf"
claim 'an attachment that was exchanged is found without a manifest' "$status $(says 'attachments: figures-f-script.gp has other bytes')" = '1 yes'
qpdf --empty "$scratch/bare.pdf"
certify traced PDF="$scratch/bare.pdf"
claim 'a PDF without attachments ends with 2' "$status $(says 'has no attachment attached.sha256; give MANIFEST=')" = '2 yes'
echo text >"$scratch/bare.pdf"
certify traced PDF="$scratch/bare.pdf"
claim 'what is no PDF ends with 2' "$status $(says "the attachments of '$scratch/bare.pdf' cannot be read")" = '2 yes'
rm -rf out
mv gone out

# Of the claims that were computed anew, here by hand
certify sampled CLAIMS='a none'
claim 'a claim that there is not ends with 2' "$status $(says 'CLAIMS: the manifest has no claim none; it has a, b, c, d')" = '2 yes'
claim 'in one line' "$(wc -l <<<"$said")" -eq 1
mkdir again
sampled() {
  more=("again=$PWD/again")
  certify sampled "$@"
  more=()
}
certificate=out/certificate-sampled
names confirmed 1 >again/names.json
sampled SEED=1
claim 'a sample that has the same verdicts holds' "$status" -eq 0
first=$(json 'c["checked"]["claims computed again"]')
claim 'at least three claims are drawn' "$(tr -cd , <<<"$first" | wc -c)" -eq 2
sampled SEED=1
claim 'by the same seed the same' "$(json 'c["checked"]["claims computed again"]')" = "$first"
drawn=$(for seed in 1 2 3 4 5 6; do sampled SEED=$seed; json 'c["checked"]["claims computed again"].split(" (")[0]'; done | sort -u | wc -l)
claim 'by another one others' "$drawn" -gt 1
names refuted 1 >again/names.json
sampled CLAIMS='b'
claim 'a verdict that is another is found' "$status $(says 'verdicts: claim b is refuted, in the manifest confirmed')" = '1 yes'
claim 'the claim is named, and no other' "$(says 'claims computed again: b (named)') $(says 'claim a')" = 'yes no'
names confirmed 2 >again/names.json
sampled CLAIMS='a b'
claim 'and so is a limit' "$status $(says 'limits: claim b: n is ≤ 2, in the manifest ≤ 1')" = '1 yes'
names confirmed 1 >again/names.json
cp -r src "$scratch"
echo 'int one = 2;' >src/one.cpp
sampled CLAIMS=a
claim 'a source that was tampered with is found by a sample' "$status $(says 'sources: src/one.cpp has other bytes')" = '1 yes'
rm -r src
mv "$scratch/src" .
echo '% more' >>out/rod.pdf
echo '1 & 3' >out/generated/tables/t.tex
sampled CLAIMS=a
claim 'a sample does not look at PDF and tables' "$status" -eq 0
claim 'and says so' "$(json 'c["not_checked"][0]')" = 'PDF, generated files and attachments (DEPTH=traced)'
rm -rf out
cp -r whole out
certificate=out/certificate-traced

# Bad input
# refused WHAT SAID [VARIABLE…]: ends with 2 and one line.
refused() {
  certify traced "${@:3}"
  claim "$1 ends with 2" "$status" -eq 2
  claim "$1 is told" "$(says "$2")" = yes
  claim "$1 is told in one line" "$(wc -l <<<"$said")" -eq 1
}
refused 'a manifest that is not there' "there is no manifest 'none.json'" MANIFEST=none.json
sed 's/"project": "rod"/"project": "bar"/' whole/manifest.json >other.json
refused 'a manifest of another paper' 'is the manifest of another project, bar, and not of rod' MANIFEST=other.json
echo '{"project": "rod"}' >other.json
refused 'what is no manifest' "'other.json' is not a manifest" MANIFEST=other.json
python3 -c 'print("[" * 200000)' >other.json
refused 'what is no JSON' "'other.json' is not JSON" MANIFEST=other.json
sed 's/"version": "1.2"/"version": "1.1"/' whole/manifest.json >other.json
certify traced MANIFEST=other.json
claim 'a manifest of another version ends with 2' "$status $(says 'is the manifest of version 1.1, and the sources are 1.2')" = '2 yes'
claim 'what can be told is told' "$(says 'sources: 3 of 3')" = yes
claim 'of a paper that holds nothing unexpected is told' "$(grep -c 'not as expected' $certificate.txt)" -eq 0
sed -i '0,/"found": "confirmed"/s//&, "expected": "refuted"/; s/"passed": true/"passed": false/' out/generated/names.json
certify traced
claim 'what the paper itself calls unexpected is told' \
  "$(grep -cxF -e '- not as expected, as the paper itself says: claim a, check k' $certificate.txt)" -eq 1
cp whole/generated/names.json out/generated
rm out/rod.pdf
certify traced
claim 'a PDF that is gone is told' "$status $(says 'PDF: rod.pdf is not there')" = '1 yes'
cp whole/rod.pdf out

git init -q .
git add src figures case.toml CMakeLists.txt
git -c user.name=t -c user.email=t@example.org -c commit.gpgsign=false commit -qm first
certify traced
claim 'a checkout at another commit is noted' "$(grep -c '^- the checkout is at commit' $certificate.txt)" -eq 1
sed -i "s/\"commit\": \"unknown\"/\"commit\": \"$(git rev-parse --short=12 HEAD)\"/" out/manifest.json
certify traced
claim 'files that differ from the commit are counted' "$(grep -c "manifest's commit, .*, and $(git status --porcelain | wc -l) files differ from it" $certificate.txt)" -eq 1
finish
