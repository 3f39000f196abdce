// SPDX-License-Identifier: GPL-3.0-or-later
// Where the sign of a claim stands on the page.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <regex>

#include "literate/document/document.hpp"
#include "literate/document/names.hpp"
#include "literate/prose/statements.hpp"
#include "literate/typesetting/typeset.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(claim_signs_test)

using namespace literate;

namespace {

constexpr int n_claims = 24;

/// Where a word stands, in points from the left and from the top of its page.
struct Word {
  double left, middle;
  int page;
};

/// Sentences that begin with a word of their own, S1 and so on, each with its claim; two in one
/// line, one that begins a paragraph, one in a footnote, and one in each line of two lists.
std::string body(const std::string& note) {
  std::string text = "\\claim{c1} S1 begins." + note +
                     " It goes on, longer than the line is wide, and so "
                     "into another one with a few words "
                     "more than that, which say nothing at all.\n\n"
                     "S2 is short. \\claim{c2} S3 is, too. \\claim{c3} Both stand in the line.\n\n"
                     "A footnote\\footnote{S4 is small. \\claim{c4}} and \\parbox{3cm}{S5 is "
                     "boxed.\\claim{c5}}\n\n"
                     "\\begin{itemize}\\itemsep0pt\\parskip0pt\n";
  for (int i = 6; i <= 15; ++i) {
    text += "\\item S" + std::to_string(i) + " is so. \\claim{c" + std::to_string(i) + "}\n";
  }
  text += "\\end{itemize}\n\\begin{enumerate}\n";
  for (int i = 16; i <= n_claims; ++i) {
    text += "\\item \\claim{c" + std::to_string(i) + "} S" + std::to_string(i) + " is so.\n";
  }
  return text + "\\end{enumerate}\nThe end.\n";
}

/// Typesets that body in a class, and finds the words of the PDF.
std::map<std::string, Word> words_in(const std::string& document_class, const std::string& note) {
  const TemporaryFolder scratch;
  Document document;
  std::string statements;
  for (int i = 1; i <= n_claims; ++i) {
    const std::string id = "c" + std::to_string(i);
    document.claim(
        id,
        {.route = "counting",
         .expected = Verdict::confirmed,
         .criteria = {Criterion::at_most("n", Value(1, integer()), {LimitKind::data, 2, "two"})}});
    statements += "\\statement[a book]{" + id + "}{It is so.}%\n";
  }
  document.write(scratch / "generated");
  sys::write_file_atomically(scratch / "text/main.tex",
                             document_class +
                                 "\n\\usepackage{literate}\n\\renewcommand*\\LiterateClaimPlacement"
                                 "{margin}\n\\begin{document}\n" +
                                 statements + body(note) + "\\end{document}\n");
  write_statements(scratch / "text", read_names(scratch / "generated/names.json"),
                   scratch / "latex/statements.tex");
  typeset({.source_dir = scratch / "text",
           .main_file = "main.tex",
           .generated_dir = scratch / "generated",
           .build_dir = scratch / "latex",
           .output_pdf = scratch / "main.pdf"});
  const sys::ProcessResult found = sys::run(
      {.program = "pdftotext", .arguments = {"-bbox", (scratch / "main.pdf").string(), "-"}});
  BOOST_TEST_REQUIRE(found.exit_status == 0, found.output);
  const std::regex word(
      "<page|<word xMin=\"(.*?)\" yMin=\"(.*?)\" xMax=\".*?\" yMax=\"(.*?)\">(.*?)</word>");
  std::map<std::string, Word> words;
  int page = 0;
  for (std::sregex_iterator i(found.output.begin(), found.output.end(), word), end; i != end; ++i) {
    if (!(*i)[1].matched) {
      ++page;
      continue;
    }
    words.insert(
        {(*i)[4], {std::stod((*i)[1]), (std::stod((*i)[2]) + std::stod((*i)[3])) / 2, page}});
  }
  return words;
}

/// Every sign stands in the line of its sentence, whatever stands around it, and no two in one
/// place.
void require_signs_beside_sentences(const std::string& document_class,
                                    const std::string& note = "") {
  const std::map<std::string, Word> words = words_in(document_class, note);

  for (int i = 1; i <= n_claims; ++i) {
    const std::string n = std::to_string(i);
    BOOST_TEST_CONTEXT(document_class << ", sentence " << n) {
      const Word& sentence = words.at("S" + n);
      const Word& sign = words.at("C" + n);
      BOOST_TEST(sign.page == sentence.page);
      BOOST_TEST(std::abs(sign.middle - sentence.middle) < 4,
                 sign.middle << " " << sentence.middle);
    }
  }
  BOOST_TEST(std::abs(words.at("C3").left - words.at("C2").left) > 15);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_sign_of_a_claim_stands_beside_its_own_sentence) {
  require_signs_beside_sentences("\\documentclass{article}", "\\marginpar{A note}");
  require_signs_beside_sentences("\\documentclass[twocolumn]{article}");
}

BOOST_AUTO_TEST_CASE(the_sign_of_a_claim_stands_beside_its_own_sentence_in_classes_of_journals) {
  for (const char* file : {"IEEEtran.cls", "revtex4-2.cls"}) {
    if (std::system((std::string("kpsewhich ") + file + " >/dev/null").c_str()) != 0) {
      BOOST_TEST_MESSAGE(file << " is not installed");
      return;
    }
  }
  require_signs_beside_sentences("\\documentclass[journal]{IEEEtran}");
  require_signs_beside_sentences("\\documentclass[journal,onecolumn]{IEEEtran}");
  require_signs_beside_sentences("\\documentclass[aps,pre,onecolumn]{revtex4-2}");
}

BOOST_AUTO_TEST_SUITE_END()
