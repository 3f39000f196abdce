// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/place_of_use.hpp"

#include <boost/test/unit_test.hpp>

#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(place_of_use_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(what_is_wrong_in_a_generated_file_is_told_where_the_document_uses_it) {
  const TemporaryFolder scratch;
  const auto report = scratch / "report";
  sys::write_file_atomically(report / "main.tex", "\\input{part/a}\n\n% \\tab{t}\n\\fig{f}\n");
  sys::write_file_atomically(report / "part/a.tex", "\n Text \\tab{t} and \\fig{f}\n");
  const auto told = [&](const std::string& message) { return with_place_of_use(message, report); };

  BOOST_TEST(told("../my build/generated/tables/t.tex:7: Misplaced \\noalign.\n  l.7 x") ==
             "report/part/a.tex:2: in table 't': Misplaced \\noalign. (tables/t.tex:7)\n  l.7 x");
  BOOST_TEST(
      told("../generated/figures/f/f.tex: Undefined") ==
      "report/main.tex:4 or report/part/a.tex:2: in figure 'f': Undefined (figures/f/f.tex)");
  BOOST_TEST(told("../generated/tables/none.tex:7: Bad") == "../generated/tables/none.tex:7: Bad");
  BOOST_TEST(told("report/part/a.tex:7: Bad") == "report/part/a.tex:7: Bad");
}

BOOST_AUTO_TEST_CASE(an_overfull_box_names_the_figures_in_its_lines) {
  const TemporaryFolder scratch;
  const auto report = scratch / "report";
  sys::write_file_atomically(report / "main.tex",
                             "\n\\centering\n\\fig[width=9cm]{f}\n\n\\tab{t}\n");
  const auto told = [&](const std::string& message) { return with_place_of_use(message, report); };
  const std::string box = "Overfull \\hbox (9.0pt too wide) ";

  BOOST_TEST(told("report/main.tex:2: " + box + "in paragraph at lines 2--4") ==
             "report/main.tex:2: in figure 'f': " + box + "in paragraph at lines 2--4");
  BOOST_TEST(told("report/main.tex:5: " + box + "detected at line 5") ==
             "report/main.tex:5: in table 't': " + box + "detected at line 5");
  BOOST_TEST(told("report/main.tex:1: " + box + "detected at line 1") ==
             "report/main.tex:1: " + box + "detected at line 1");
}

BOOST_AUTO_TEST_SUITE_END()
