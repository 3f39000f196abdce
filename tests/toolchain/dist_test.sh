#!/bin/sh
# dist makes an archive that typesets anywhere and has the same bytes each time.
# shellcheck source=tests/toolchain/shell_test.sh
. "$(dirname "$0")/shell_test.sh"
# shellcheck source=tests/toolchain/toy_checkout.sh
. "$(dirname "$0")/toy_checkout.sh"
archive=$toy/build/dist/report.tar.gz
echo 'cp "$1" "$2/tables/t.csv"' >>"$toy/compute"
mkdir -p "$toy/build/release"
# halfspace-report describe SETTINGS --folder FOLDER
cat >"$toy/build/release/halfspace-report" <<'END'
#!/bin/sh
[ "$1 $3" = 'describe --folder' ] && [ -f "$2" ] && ls "$4" >"$4/codecheck.yml" && ls "$4" >"$4/ro-crate-metadata.json"
END
chmod +x "$toy/build/release/halfspace-report"

mkdir -p "$toy/report/pictures"
printf 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNgAAAAAgABSK+kcQAAAABJRU5ErkJggg==' | base64 -d \
  >"$toy/report/pictures/rig.png"
sed -i 's/\\begin{document}/\\usepackage{graphicx}&\\includegraphics{pictures\/rig.png}/' "$toy/report/report.tex"
mkdir -p "$toy/build/report/latex" # where LaTeX tells what it read
printf 'INPUT ./report.tex\nINPUT ./pictures/rig.png\n' >"$toy/build/report/latex/report.fls"
mkdir "$toy/raw"
echo 1 >"$toy/raw/plate.dat" # what a script of data reads
sed -i '/^engine=/i reads=${PROJECT_SOURCE_DIR}/raw/plate.dat' "$toy/CMakeLists.txt"
toy_make dist
claim 'the toy is packed' "$status" -eq 0
claim 'it was typeset elsewhere' "$(says 'typeset elsewhere to the same text')" = yes
claim 'it holds what LaTeX reads, and for readers the results with what describes them' \
  "$(tar -tzf "$archive" | grep -v '/$' | LC_ALL=C sort | tr '\n' ' ')" = \
  "$(printf './anc/%s ' CITATION.cff codecheck.yml generated/tables/t.csv manifest.json raw/plate.dat report.pdf \
    ro-crate-metadata.json ruggiero2001.toml)./pictures/rig.png ./report.tex ./repository.tex ./sections/a.tex ./tables/t.csv ./tables/t.tex "
claim 'its files belong to nobody and are as old as the report' \
  "$(tar -tvzf "$archive" --utc --full-time | grep -c ' 0/0 .* 2001-04-23 12:00:00 ')" -ge 5

first=$(sha256sum <"$archive")
sleep 1
touch "$toy/report/sections/a.tex"
(cd "$toy" && umask 077 && TZ=Pacific/Kiritimati make dist >/dev/null 2>&1)
claim 'the same report gives the same archive' "$(sha256sum <"$archive")" = "$first"

printf 'A table: \\input{tables/t} \\input{%s}\n' "$scratch/secret" >"$toy/report/sections/a.tex"
echo 'left at home' >"$scratch/secret.tex"
toy_make report
rm "$scratch/secret.tex"
toy_make dist
claim 'a document that reads files from elsewhere fails' "$status" -ne 0
claim "LaTeX's message is shown with file and line" "$(says './sections/a.tex:1: ')" = yes
claim 'the archive before is left' "$(sha256sum <"$archive")" = "$first"

cp "$toy/report/sections/a.tex" "$toy/report/sections/ä.tex"
toy_make dist
claim 'a name that arXiv refuses is told' "$(says 'arXiv takes no file of the name sections/')" = yes

finish
