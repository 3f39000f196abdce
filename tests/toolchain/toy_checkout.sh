# shellcheck shell=sh
# To be sourced after shell_test.sh: makes a checkout with the real Makefile and scripts around a project that is built in
# no time, with values from a case and a document with one table.
# shellcheck disable=SC2154  # source_dir and scratch are shell_test.sh's
toy="$scratch/toy checkout"
unset MAKEFLAGS MFLAGS MAKELEVEL CASE CLAIMS DEPTH MANIFEST PDF SEED TARGET V GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE
export PWD

mkdir -p "$toy/src" "$toy/figures" "$toy/report/sections"
cp "$source_dir/Makefile" "$source_dir/CMakePresets.json" "$source_dir/CITATION.cff" "$toy"
cp -r "$source_dir/src/toolchain" "$toy/src"
mkdir "$toy/src/literate"
cp -r "$source_dir/src/literate/scripts" "$source_dir/src/literate/cmake" "$toy/src/literate"
echo 'E = 30' >"$toy/report/ruggiero2001.toml"
echo 'A table: \input{tables/t}' >"$toy/report/sections/a.tex"
cat >"$toy/report/report.tex" <<'END'
\documentclass{article}
\pdfinfoomitdate=1 \pdftrailerid{}
\begin{document}
\input{sections/a}
\end{document}
END

# compute CASE OUTPUT: writes what the program would write.
cat >"$toy/compute" <<'END'
#!/bin/sh
mkdir -p "$2/tables"
tr -d '\n' <"$1" >"$2/tables/t.tex"
echo '{"values": {}}' >"$2/names.json"
END
# digest FOLDER
cat >"$toy/digest" <<'END'
#!/bin/sh
cd "$1" && find . -type f -printf '%P\0' | sort -z | xargs -0 sha256sum >../generated.sha256
END
# typeset DOCUMENT OUTPUT
cat >"$toy/typeset" <<'END'
#!/bin/sh
cd "$1" && TEXINPUTS=".:$2/generated:" SOURCE_DATE_EPOCH=0 pdflatex -interaction=batchmode \
  -output-directory="$2" report.tex >"$2/said" && printf '{"made_with": {"sources": {\n  "date": "2001-04-23T12:00:00Z"}}}\n' >"$2/manifest.json"
END
chmod +x "$toy/compute" "$toy/digest" "$toy/typeset"

cat >"$toy/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(toy LANGUAGES NONE)
set(report_CASE "" CACHE FILEPATH "")
set(report_OUTPUT "" CACHE PATH "")
set(to "${report_OUTPUT}")
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/report.settings" CONTENT
"name=report
project=halfspace
root=${PROJECT_SOURCE_DIR}
build=${PROJECT_BINARY_DIR}
latex=pdflatex
program=${PROJECT_BINARY_DIR}/halfspace-report
document=${PROJECT_SOURCE_DIR}/report
main=report.tex
case=${report_CASE}
sources=src
output=${to}
repository=${PROJECT_BINARY_DIR}/repository
engine=${PROJECT_SOURCE_DIR}/src/literate
")
file(GLOB_RECURSE document CONFIGURE_DEPENDS report/*.tex)
list(JOIN document "\n" document)
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/document.list" CONTENT "${document}\n")
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/repository/repository.tex" CONTENT "")
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/repository/repository.json" CONTENT "")
add_custom_target(ask_for_commit COMMAND "${CMAKE_COMMAND}" -E true)
add_custom_target(halfspace-report DEPENDS ask_for_commit)
add_custom_target(report_linked)
add_custom_command(OUTPUT "${to}/generated/names.json" "${to}/generated.sha256"
  COMMAND "${PROJECT_SOURCE_DIR}/compute" "${report_CASE}" "${to}/generated"
  COMMAND "${PROJECT_SOURCE_DIR}/digest" "${to}/generated"
  DEPENDS "${PROJECT_SOURCE_DIR}/compute" "${report_CASE}" COMMENT "compute" USES_TERMINAL VERBATIM)
add_custom_target(report-figures DEPENDS "${to}/generated.sha256")
add_custom_command(OUTPUT "${to}/report.pdf" "${to}/manifest.json"
  COMMAND "${PROJECT_SOURCE_DIR}/typeset" "${PROJECT_SOURCE_DIR}/report" "${to}"
  DEPENDS "${PROJECT_BINARY_DIR}/repository/repository.json" "${to}/generated.sha256" report/report.tex report/sections/a.tex
  COMMENT "typeset" USES_TERMINAL VERBATIM)
add_custom_target(report DEPENDS "${to}/report.pdf")
add_custom_target(report-made DEPENDS "${to}/report.pdf")
END

# toy_make ARGUMENT…: runs make in the toy checkout.
toy_make() {
  cd "$toy" || exit 1
  runs make "$@"
}
