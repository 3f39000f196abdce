// SPDX-License-Identifier: GPL-3.0-or-later
// The marks at the ends of captions, which tell where a figure or table comes from.
#include <boost/test/unit_test.hpp>
#include <regex>
#include <string>
#include <vector>

#include "holds.hpp"
#include "literate/document/document.hpp"
#include "literate/typesetting/typeset.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(captions_test)

using namespace literate;

namespace {

/// What pdftotext tells of a document with three tables.
std::string text_of(const std::string& preamble, const std::string& body,
                    const std::vector<std::string>& options = {}) {
  const TemporaryFolder scratch;
  Document document;
  for (const char* name : {"left", "right", "one"}) {
    document.table(Table(name, {Column("n", integer())}).add_row({12}));
  }
  document.write(scratch / "generated");
  scratch.write("paper/main.tex", preamble + "\\usepackage{literate}\n\\begin{document}\nText.\n" +
                                      body + "\nEnd.\n\\end{document}\n");
  const auto pdf = scratch / "main.pdf";
  typeset({.source_dir = scratch / "paper",
           .main_file = "main.tex",
           .generated_dir = scratch / "generated",
           .build_dir = scratch / "latex",
           .output_pdf = pdf});
  std::vector<std::string> arguments = options;
  arguments.insert(arguments.end(), {pdf.string(), "-"});
  const std::string text = sys::run({.program = "pdftotext", .arguments = arguments}).output;
  return options.empty() ? std::regex_replace(text, std::regex("\\s+"), " ") : text;
}

void require_says(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) BOOST_TEST(holds(text, part));
}

const std::string column = "\\documentclass[journal]{IEEEtran}\n";
const std::string page = "\\documentclass{article}\n";

}  // namespace

BOOST_AUTO_TEST_CASE(a_mark_stays_in_its_column_however_long_the_last_line_is) {
  std::string figures;
  for (std::size_t n = 1; n <= 24; ++n) {
    figures += "\\begin{table}\\caption{A caption of a line that is about as long as this one is " +
               std::string(n, 'i') + "}\\tab{one}\\end{table}\n";
  }
  const std::string words = text_of(column, figures + "\\provenance", {"-bbox"});

  const std::regex mark("xMin=\"([0-9.]+)\"[^>]*xMax=\"([0-9.]+)\"[^>]*>source<");
  std::size_t n_marks = 0;
  for (std::sregex_iterator found(words.begin(), words.end(), mark), end; found != end; ++found) {
    ++n_marks;
    constexpr double width = 252, left = 48.96, right = 311.04;  // of IEEEtran on letter paper
    const double begin = std::stod((*found)[1]), last = std::stod((*found)[2]);
    const double from = begin < left + width ? left : right;
    BOOST_TEST(begin >= from);
    BOOST_TEST(last <= from + width + 0.1);
  }
  BOOST_TEST(n_marks == 24U);
}

BOOST_AUTO_TEST_CASE(each_panel_has_the_mark_of_its_own_data) {
  const std::string text =
      text_of(page + "\\usepackage{subcaption}\n",
              "\\begin{figure}\n"
              "\\begin{subfigure}{.4\\linewidth}\\tab{left}\\caption{Left.}\\end{subfigure}\n"
              "\\begin{subfigure}{.4\\linewidth}\\tab{right}\\caption{Right.}\\end{subfigure}\n"
              "\\caption{Two.}\\end{figure}\n"
              "\\begin{figure}\n"
              "\\begin{subfigure}{.4\\linewidth}\\tab{one}\\caption{Part.}\\end{subfigure}\n"
              "\\tab{left}\\caption{Three.}\\end{figure}\n\\attachdata");
  require_says(text, {"(a) Left. [left]", "(b) Right. [right]", "1: Two. ", "(a) Part. [one]",
                      "2: Three. [left]"});
  BOOST_TEST(lacks(text, "Two. ["));
}

BOOST_AUTO_TEST_CASE(of_subfloats_the_whole_has_the_marks) {
  const std::string panels =
      "\\begin{figure}\\subfloat[Left.]{\\rule{3cm}{0pt}\\tab{left}} "
      "\\subfloat[Right.]{\\rule{3cm}{0pt}\\tab{right}}"
      "\\caption{Two.}\\end{figure}\n"
      "\\begin{figure}\\subfloat[Part.]{\\rule{3cm}{0pt}\\tab{one}}\\caption{Next.}\\end{figure}"
      "\n\\attachdata";
  for (const std::string& preamble :
       {column + "\\usepackage[caption=false]{subfig}\n", page + "\\usepackage{subfig}\n"}) {
    const std::string text = text_of(preamble, panels);
    require_says(text, {"Two. [left] [right]", "Next. [one]"});
    BOOST_TEST(lacks(text, "Left. ["));
    BOOST_TEST(lacks(text, "Part. ["));
  }
}

BOOST_AUTO_TEST_CASE(a_caption_has_the_marks_of_its_own_float) {
  require_says(text_of(page,
                       "\\begin{table}\\caption{Above.}\\tab{left}\\tab{right}\\end{table}\n"
                       "\\begin{table}\\tab{one}\\caption{Below.}\\end{table}\n\\attachdata"),
               {"Above. [left] [right]", "Below. [one]"});
}

BOOST_AUTO_TEST_SUITE_END()
