#!/usr/bin/env bash
# packages_test.sh SOURCE PROGRAM: a paper with subcaption, amsthm, algorithm2e and TikZ becomes a page: LaTeX sets what
# page.tex names as pictures, and captions, labels and numbers are text, as in the PDF; and so does a paper of constructs of which
# each was once read otherwise than by LaTeX.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../../toolchain/shell_test.sh"
program=$2
missing=$(sh "$source_dir/src/toolchain/missing" html)
for style in algorithm2e.sty tikz.sty cite.sty IEEEtran.cls; do
  if ! kpsewhich "$style" >/dev/null; then missing+=" ${style%.*}"; fi
done
if [[ -n $missing ]]; then
  printf 'skipped: %s missing — run "make setup test html"\n' "${missing//$'\n'/ }"
  exit 77
fi
cd "$scratch" || exit 1
cp -R "$source_dir/tests/literate/page/packages" paper
for name in packages constructs names citations; do
  printf '%s\n' name=$name project=packages "root=$scratch" "build=$scratch" "program=$program" "document=$scratch/paper" main=$name.tex \
    "case=$scratch/case.toml" sources= "figures=$scratch" "output=$scratch" repository= "engine=$source_dir/src/literate" >$name.settings
done
touch case.toml
runs "$program" compute packages.settings
claim 'the program computes' "$status" -eq 0
runs "$program" draw packages.settings
claim 'the program writes what LaTeX reads' "$status" -eq 0

# make_page [NAME]: the PDF, and the page.
make_page() {
  local name=${1:-packages}
  runs "$program" typeset $name.settings
  claim "the paper of $name is typeset" "$status" -eq 0
  runs bash "$source_dir/src/literate/scripts/html" $name.settings
  claim "the paper of $name becomes a page" "$status" -eq 0
}

for name in constructs names citations packages; do
  make_page $name
  runs python3 -B "$source_dir/tests/literate/page/page_and_pdf.py" . paper $name
  claim "page and PDF of $name have the same words, numbers and signs in the same order" "$status" -eq 0
done
said=$(sed -e 's/<[^>]*>//g' -e 's/\xc2\xa0/ /g' citations.html | grep 'It is told')
for cited in 'by one [1],' 'by two [1], [2],' 'by three [1]–[3],' 'by some [1], [3]–[5],' 'with a note [2], [4, p. 3]'; do
  claim "the page cites $cited, as the PDF does" "$(says "$cited")" = yes
done
runs pdftotext -raw citations.pdf -
said=${said//$'\n'/ }
claim 'the PDF cites so' "$(says 'by some [1], [3]–[5],')" = yes
said=$(cat packages.html)
claim 'each algorithm and each drawing is one picture' "$(grep -o '<img class="lit-drawing" src="data:image/svg' packages.html | wc -l)" -eq 4
claim 'its source is what a picture says to who cannot see it' "$(says 'node[midway, right] {$s_2 &lt; 7$ \&amp; more};')" = yes
claim 'a reference leads to the algorithm' "$(says 'id="alg:euclid"')" = yes
runs pdftotext html/typeset.pdf -
claim 'a reference in a picture has the number of the PDF' "$(says 'as in algorithm 2')" = yes
claim 'no caption is told twice' "$(says 'A power')" = no
runs pdfinfo -f 2 -l 2 html/typeset.pdf
claim 'a picture is no wider than it is' "$(sed -n 's/^Page *2 size: *\([0-9]*\).*/\1/p' <<<"$said")" -lt 60

# What did not change is not typeset again, and what did is.
before=$(stat -c %y html/typeset.pdf)
sed -i 's/A remainder is less/Each remainder is less/' paper/packages.tex
make_page
claim 'pictures are not typeset again for a word of the text' "$(stat -c %y html/typeset.pdf)" = "$before"
sed -i 's/{1.385}/{2.77}/' paper/packages.tex
make_page
runs pdfinfo -f 2 -l 2 html/typeset.pdf
claim 'a command of the preamble that changed is seen in a picture' "$(sed -n 's/^Page *2 size: *\([0-9]*\).*/\1/p' <<<"$said")" -gt 70

# What LaTeX cannot set is told, in its words.
sed -i 's/^\\begin{document}/\\AtBeginDocument{\\ifnum\\pdfstrcmp{\\jobname}{typeset}=0 \\let\\Return\\undefined\\fi}\n&/' paper/packages.tex
runs "$program" typeset packages.settings
runs bash "$source_dir/src/literate/scripts/html" packages.settings
claim 'what LaTeX says of a picture is told' "$status" -eq 3 -a "$(says '! Undefined control sequence.')" = yes
finish
