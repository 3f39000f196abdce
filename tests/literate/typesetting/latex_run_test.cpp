// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/typesetting/typeset.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>

#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(latex_run_test)

using namespace literate;
namespace fs = std::filesystem;

namespace {

/// A document with a package of its own, in folders with spaces in their names.
class Paper {
 public:
  explicit Paper(const std::string& preamble = "\\usepackage{own}\n") {
    write_file("own.sty", "\\newcommand\\word{one}\n");
    sys::write_file_atomically(options.generated_dir / "values.tex", "");
    write(preamble, "\\word\n");
  }

  void write(const std::string& preamble, const std::string& body) const {
    write_file("main.tex", "\\documentclass{minimal}\n" + preamble + "\\begin{document}\n" + body +
                               "\\end{document}\n");
  }
  void write_file(const std::string& file, const std::string& text) const {
    sys::write_file_atomically(options.source_dir / file, text);
  }

 private:
  TemporaryFolder scratch_;

 public:
  TypesetOptions options{.source_dir = scratch_ / "my report",
                         .main_file = "main.tex",
                         .generated_dir = scratch_ / "out put/generated",
                         .build_dir = scratch_ / "out put/tex",
                         .output_pdf = scratch_ / "out put/report.pdf"};
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_preamble_is_kept_and_a_changed_body_leaves_it) {
  const Paper paper;

  const PreambleFormat first = keep_preamble(paper.options);
  paper.write("\\usepackage{own}\n", "Another \\word\n");
  const PreambleFormat second = keep_preamble(paper.options);

  BOOST_TEST(first.is_usable);
  BOOST_TEST(first.is_new);
  BOOST_TEST(fs::file_size(first.folder / "preamble.fmt") > 0U);
  BOOST_TEST(second.is_usable);
  BOOST_TEST(!second.is_new);
}

BOOST_AUTO_TEST_CASE(a_changed_preamble_or_package_or_date_makes_the_format_anew) {
  Paper paper;
  keep_preamble(paper.options);

  paper.write("\\usepackage{own}\n\\frenchspacing\n", "\\word\n");
  BOOST_TEST(keep_preamble(paper.options).is_new);
  paper.write_file("own.sty", "\\newcommand\\word{two}\n");
  BOOST_TEST(keep_preamble(paper.options).is_new);
  paper.options.source_date_epoch = 86400;
  BOOST_TEST(keep_preamble(paper.options).is_new);
  BOOST_TEST(!keep_preamble(paper.options).is_new);
}

BOOST_AUTO_TEST_CASE(a_file_that_could_be_read_instead_of_another_makes_the_format_anew) {
  const Paper paper;
  keep_preamble(paper.options);
  paper.write_file("notes.txt", "");
  BOOST_TEST(!keep_preamble(paper.options).is_new);

  paper.write_file("minimal.cls", "\\LoadClass{article}\n");

  BOOST_TEST(keep_preamble(paper.options).is_new);
}

BOOST_AUTO_TEST_CASE(after_an_interruption_or_damage_the_format_is_made_anew) {
  const Paper paper;
  const fs::path folder = keep_preamble(paper.options).folder;

  sys::write_file_atomically(folder / "preamble.fmt", "half of a form");
  BOOST_TEST(keep_preamble(paper.options).is_new);
  fs::remove(folder / "preamble.sha256");
  BOOST_TEST(keep_preamble(paper.options).is_new);
  BOOST_TEST(!keep_preamble(paper.options).is_new);
}

BOOST_AUTO_TEST_CASE(a_preamble_that_cannot_be_kept_is_tried_once) {
  for (const std::string preamble :
       {"\\newwrite\\log\\immediate\\openout\\log=notes.log\n",  // would not be open any more
        "\\input{main.old}\n",                                   // an earlier pass wrote it
        "\\nonsense\n",                                          // has an error
        "\\relax"}) {                                            // ends within a line
    BOOST_TEST_CONTEXT(preamble) {
      const Paper paper(preamble);
      sys::write_file_atomically(paper.options.build_dir / "main.old.tex", "");

      BOOST_TEST(!keep_preamble(paper.options).is_usable);
      BOOST_TEST(!keep_preamble(paper.options).is_new);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_preamble_that_was_mended_is_kept) {
  const Paper paper("\\nonsense\n");
  BOOST_TEST(!keep_preamble(paper.options).is_usable);

  paper.write("", "Text.\n");

  BOOST_TEST(keep_preamble(paper.options).is_usable);
}

BOOST_AUTO_TEST_SUITE_END()
