// SPDX-License-Identifier: GPL-3.0-or-later
// The classes that papers are written in: each typesets the same small paper.
#include <boost/algorithm/string/replace.hpp>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "holds.hpp"
#include "literate/document/document.hpp"
#include "literate/figures/draw.hpp"
#include "literate/page/html_text.hpp"
#include "literate/typesetting/typeset.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(classes_test)

using namespace literate;
namespace fs = std::filesystem;

namespace {

/// How a class is chosen, and what it needs around the same body.
struct DocumentClass {
  std::string file, line, before, after;
  std::string width = "\\columnwidth";
  bool keeps_preamble = true;  ///< elsarticle opens a file in its preamble
};

/// Typesets a paper with value, claims' neighbours and one figure of a column's width; the folder
/// of LaTeX's own files is below `scratch`.
TypesetOptions typeset_in(const DocumentClass& chosen, const fs::path& scratch,
                          const std::string& engine) {
  Document document;
  document.value("load", Value(3, integer()));
  document.value("drift", Value({-0.00471, 0.0017}, uncertain()));
  document.value("resistance", Value(2e-7, exact(), "ohm"));
  document.figure("f", {.width_cm = 5, .height_cm = 4, .texts = {{"name", "$\\nu$"}}});
  document.table(Table("t", {Column("n", integer())}).add_row({12}));
  TypesetOptions options{.source_dir = scratch / "paper",
                         .main_file = "main.tex",
                         .generated_dir = scratch / "out/generated",
                         .build_dir = scratch / "out/latex",
                         .output_pdf = scratch / "out/main.pdf",
                         .engine = engine,
                         .figures = document.figure_places()};
  document.write(options.generated_dir,
                 {{"loop", "src/a.cpp", 3, "for (int i = 0; i < 3; ++i) sum += i;\n"}});
  sys::write_file_atomically(scratch / "figures/style.gp", "# what figures share\n");
  sys::write_file_atomically(scratch / "figures/f.gp", "plot sin(x) title name\n");
  draw_figures(options.generated_dir, scratch / "figures", options.figures);
  sys::write_file_atomically(
      options.source_dir / "main.tex",
      chosen.line + "\n\\usepackage{literate}\n\\begin{document}\n" + chosen.before +
          "The load is \\val{load}, the drift \\val{drift}, the resistance \\val{resistance}, in "
          "bold "
          "\\textbf{\\val{drift}, \\val{resistance}}; see figure~\\ref{f} and table~\\ref{t}.\n"
          "\\begin{figure}\\centering\\fig[width=" +
          chosen.width +
          "]{f}\n"
          "\\caption{A sine.}\\label{f}\\end{figure}\n"
          "\\begin{table}\\centering\\caption{A number.}\\label{t}\\tab{t}"
          "\\end{table}\n" +
          chosen.after + "\\end{document}\n");
  typeset(options);
  return options;
}

void require_typesets(const DocumentClass& chosen, const std::string& engine = "pdflatex") {
  if (std::system(("kpsewhich " + chosen.file + " >/dev/null").c_str()) != 0) {
    BOOST_TEST_MESSAGE(chosen.file + " is not installed");
    return;
  }
  const TemporaryFolder one, other;

  const TypesetOptions first = typeset_in(chosen, one.path(), engine);
  const TypesetOptions second = typeset_in(chosen, other.path(), engine);

  BOOST_TEST(sys::sha256_of_file(first.output_pdf) == sys::sha256_of_file(second.output_pdf));
  BOOST_TEST(fs::exists(first.build_dir / "preamble/preamble.fmt") ==
             (chosen.keeps_preamble && engine == "pdflatex"));
  // Signs of numbers are signs for whoever copies or hears the text, in whatever font.
  const std::string text =
      sys::run({.program = "pdftotext", .arguments = {"-raw", first.output_pdf.string(), "-"}})
          .output;
  // The sign of an ohm and the Greek letter are one sign to Unicode.
  const std::string words = boost::replace_all_copy(without_blanks(text), "\u2126", "\u03a9");
  for (const char* wanted :
       {"drift−0.0047±0.0018,theresistance2×10−7Ω", "bold−0.0047±0.0018,2×10−7Ω"}) {
    BOOST_TEST(holds(words, wanted), wanted << " in " << text);
  }
}

const std::string journal_front =
    "\\begin{frontmatter}\\title{A sum}\\author{N.N.}\\begin{abstract}It is \\val{load}."
    "\\end{abstract}\\end{frontmatter}\n";

}  // namespace

BOOST_AUTO_TEST_CASE(article) {
  require_typesets({"article.cls", "\\documentclass{article}", "", "\\excerpt{loop}\n"});
}

BOOST_AUTO_TEST_CASE(article_by_lualatex) {
  require_typesets({"article.cls", "\\documentclass{article}", "", "\\excerpt{loop}\n"},
                   "lualatex");
}

BOOST_AUTO_TEST_CASE(elsarticle_in_two_columns) {
  require_typesets({"elsarticle.cls", "\\documentclass[final,5p,times,twocolumn]{elsarticle}",
                    journal_front, "\\excerpt{loop}\n", "\\columnwidth", false});
}

BOOST_AUTO_TEST_CASE(ieeetran) {
  require_typesets({"IEEEtran.cls", "\\documentclass[journal]{IEEEtran}",
                    "\\title{A sum}\\author{N.N.}\\maketitle\n", "\\excerpt{loop}\n"});
}

BOOST_AUTO_TEST_CASE(revtex) {
  require_typesets({"revtex4-2.cls", "\\documentclass[aps,pre,twocolumn]{revtex4-2}",
                    "\\title{A sum}\\author{N.N.}\\maketitle\n", "\\excerpt{loop}\n"});
}

BOOST_AUTO_TEST_CASE(beamer) {
  require_typesets({"beamer.cls", "\\documentclass{beamer}", "\\begin{frame}{A sum}\n",
                    "\\end{frame}\n\\begin{frame}[fragile]\n\\excerpt{loop}\n\\end{frame}\n",
                    "0.35\\columnwidth"});
}

BOOST_AUTO_TEST_SUITE_END()
