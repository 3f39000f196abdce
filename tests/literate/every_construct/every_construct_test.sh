#!/usr/bin/env bash
# every_construct_test.sh SOURCE INSTALLED [CLASS…]: a made-up paper that has every construct of the manual, in each class
# that the manual names: it builds, no word stands on another, it passes the check, is made again elsewhere with the same
# bytes, and is packed so that LaTeX alone typesets it, and typesets what a co-author changes in it.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../toolchain/shell_test.sh"
unset MAKEFLAGS MFLAGS MAKELEVEL CALLER CASE CASES J KEYS NAME TARGET V MANIFEST GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE
installed="$2/usr local"
shift 2
if [[ $# -gt 0 ]]; then classes=("$@"); else classes=(article two-columns ieeetran revtex elsarticle chapters); fi
here=$source_dir/tests/literate/every_construct
cp -R "$here" "$scratch/paper"
cd "$scratch/paper" || exit 1
git init -q . && git add -A && git -c user.name=t -c user.email=t@example.org -c commit.gpgsign=false commit -qm first
runs cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_PREFIX_PATH=$installed"
claim 'the papers are configured' "$status" -eq 0

for class in "${classes[@]}"; do
  runs ninja -C build "$class"
  claim "$class has its PDF" "$status" -eq 0
  runs pdftotext "build/$class/$class.pdf" -
  said=${said//$'\n'/ } # where lines end is another matter in each class
  for wanted in 'sample 7_b' '57.4 %' 'Theorem 1' 'not gone so soon' 'A map of colours' 'Rutherford' 'n0' 'Two panels'; do
    claim "the PDF of $class says $wanted" "$(says "$wanted")" = yes
  done
  for unwanted in '??' '[?]' 'no-such-value' 'sections/'; do
    claim "the PDF of $class does not say $unwanted" "$(says "$unwanted")" = no
  done
  runs python3 -B "$here/overprints.py" "build/$class/$class.pdf"
  claim "no word of $class stands on another" "$status" -eq 0
  runs ninja -C build "$class-check"
  claim "the prose of $class passes the check" "$status" -eq 0
  runs ninja -C build "$class-verify"
  claim "$class is made again elsewhere with the same bytes" "$(says 'the same bytes: ')" = yes
  runs ninja -C build "$class-dist"
  claim "$class is packed, and typesets elsewhere" "$(says 'typeset elsewhere to the same text, the same bytes')" = yes

  if [[ -z $(sh "$source_dir/src/toolchain/missing" html) ]]; then
    runs ninja -C build "$class-html"
    claim "$class has its page" "$status" -eq 0
    runs python3 -B "$source_dir/tests/literate/page/page_and_pdf.py" "build/$class" paper "$class"
    claim "page and PDF of $class have the same words and numbers" "$status" -eq 0
  fi

  # A co-author has LaTeX, and nothing else.
  mkdir "$scratch/$class" && tar -C "$scratch/$class" -xzf "build/dist/$class.tar.gz"
  cd "$scratch/$class" || exit 1
  sed -i 's/width=.columnwidth/width=0.9\\columnwidth/' sections/figures.tex
  sed -i 's/after each of three times/after each of the dozen/' sections/claims.tex
  for _ in 1 2; do runs pdflatex -recorder -interaction=batchmode "$class"; done
  claim "what was packed of $class is typeset after an edit" "$status" -eq 0
  runs pdftotext "$class.pdf" -
  said=${said//$'\n'/ }
  claim "$class has its bibliography without BibTeX" "$(says 'Radio-activity')" = yes
  claim "a sentence that was edited in $class stands in the ledger" "$(says dozen)" = yes
  claim "a figure that was made narrower in $class is shown" "$(grep -c 'INPUT ./figures/decay/decay.pdf' "$class.fls")" -gt 0
  cd "$scratch/paper" || exit 1
done

finish
