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
             "report/main.tex:3: in figure 'f': " + box + "in paragraph at lines 2--4");
  BOOST_TEST(told("report/main.tex:5: " + box + "detected at line 5") ==
             "report/main.tex:5: in table 't': " + box + "detected at line 5");
  BOOST_TEST(told("report/main.tex:1: " + box + "detected at line 1") ==
             "report/main.tex:1: " + box + "detected at line 1");
}

BOOST_AUTO_TEST_CASE(a_paragraph_that_began_in_another_file_is_told_where_it_goes_on_in_this_one) {
  const TemporaryFolder scratch;
  const auto report = scratch / "report";
  sys::write_file_atomically(
      report / "main.tex",
      "\\fig{other}\n\n\\begin{table}\n\\tab{t}\n\\end{table}\n\nplain\ntext\n");
  const auto told = [&](const std::string& lines) {
    return with_place_of_use(
               "report/main.tex:1: Overfull \\hbox (9.0pt too wide) in paragraph at lines " + lines,
               report)
        .substr(0, 28);
  };

  BOOST_TEST(told("1--5") == "report/main.tex:4: in table ");
  BOOST_TEST(told("1--8") == "report/main.tex:7: Overfull ");
  BOOST_TEST(told("8--8") == "report/main.tex:8: Overfull ");
  BOOST_TEST(told("99--8") == "report/main.tex:7: Overfull ");
}

BOOST_AUTO_TEST_CASE(an_overfull_box_of_a_float_names_none_of_the_floats_before_it) {
  const TemporaryFolder scratch;
  const auto report = scratch / "report";
  sys::write_file_atomically(
      report / "main.tex",
      "\\begin{table}\n\\tab{a}\n\\end{table}\n\\begin{table*}[t]\n\\tab{b}\n"
      "\\end{table*}\n\\begin{figure}\\fig{c}\n\\end{figure}\n");
  const auto told = [&](const std::string& lines) {
    return with_place_of_use(
               "report/main.tex:1: Overfull \\hbox (9.0pt too wide) in paragraph at lines " + lines,
               report)
        .substr(0, 45);
  };

  BOOST_TEST(told("1--6") == "report/main.tex:5: in table 'b': Overfull \\hb");
  BOOST_TEST(told("1--8") == "report/main.tex:7: in figure 'c': Overfull \\h");
}

BOOST_AUTO_TEST_CASE(a_line_of_a_listing_is_told_where_the_document_has_it) {
  const TemporaryFolder scratch;
  const auto report = scratch / "report";
  sys::write_file_atomically(report / "main.tex", "\n\\excerpt{loop}\n");

  BOOST_TEST(with_place_of_use("../generated/excerpts/loop.txt:3: Overfull", report) ==
             "report/main.tex:2: in excerpt 'loop': Overfull (excerpts/loop.txt:3)");
}

BOOST_AUTO_TEST_SUITE_END()
