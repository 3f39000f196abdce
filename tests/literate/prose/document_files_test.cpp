// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/document_files.hpp"

#include <boost/test/unit_test.hpp>

#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(document_files_test)

using namespace literate;

BOOST_AUTO_TEST_CASE(each_picture_of_the_document_is_listed_once) {
  const TemporaryFolder scratch;
  const auto folder = scratch / "report";
  sys::write_file_atomically(folder / "pictures/rig.png", "picture");
  sys::write_file_atomically(scratch / "elsewhere.png", "picture");
  sys::write_file_atomically(
      folder / "main.tex",
      "\\includegraphics[width=3cm]{pictures/rig.png}\\includegraphics{./pictures/rig.png}\n"
      "\\includegraphics{logo}\\includegraphics{none.png}\\includegraphics{../elsewhere.png}\n"
      "\\includegraphics{main.tex} % \\includegraphics{other.png}\n");

  BOOST_TEST(images_of(folder) == std::vector<std::string>{"pictures/rig.png"},
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(own_commands_stand_in_the_text_and_in_styles_beside_it) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "report/main.tex", "\\newcommand\\len[1]{\\val{len.#1}}\n");
  sys::write_file_atomically(scratch / "report/own.sty", "\\newcommand\\wide{\\val{width}}\n");
  const OwnCommands own = own_commands_of(scratch / "report");
  BOOST_TEST(own.find("len")->second.n_arguments == 1U);
  BOOST_TEST(own.find("wide")->second.body == "\\val{width}");
}

BOOST_AUTO_TEST_CASE(a_part_that_is_not_there_is_told_with_its_place_and_the_nearest_name) {
  const TemporaryFolder scratch;
  const auto folder = scratch / "report";
  sys::write_file_atomically(folder / "main.tex",
                             "\\input{parts/theory}\\input{parts/theory.tex}\n"
                             "% \\input{none}\n \\include{parts/teory}\\input{values}\\input{\\x}\n"
                             "\\IfFileExists{local.tex}{\\input{local}}{}\n");
  sys::write_file_atomically(folder / "parts/theory.tex", "");
  sys::write_file_atomically(scratch / "generated/values.tex", "");

  BOOST_TEST(missing_inputs(folder, scratch / "generated") ==
                 (std::vector<std::string>{"report/main.tex:3:2: there is no file 'parts/teory', "
                                           "did you mean 'parts/theory'?"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_bibliography_that_is_not_there_is_told_unless_its_references_are) {
  const TemporaryFolder scratch;
  const auto folder = scratch / "report";
  sys::write_file_atomically(folder / "main.tex",
                             "\\bibliography{own, more/others,gone}\n"
                             "\\addbibresource{own.bib}\\bibliography{\\jobname}\n");
  sys::write_file_atomically(folder / "own.bib", "");
  sys::write_file_atomically(folder / "more/others.bib", "");

  BOOST_TEST(
      missing_inputs(folder, scratch / "generated") ==
          (std::vector<std::string>{"report/main.tex:1:1: there is no bibliography 'gone.bib'"}),
      boost::test_tools::per_element());
  sys::write_file_atomically(folder / "main.bbl", "");
  BOOST_TEST(missing_inputs(folder, scratch / "generated").empty());
}

BOOST_AUTO_TEST_CASE(a_bibliography_outside_the_folder_of_the_document_is_refused) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "report/main.tex", "\\bibliography{../own}\n");
  sys::write_file_atomically(scratch / "own.bib", "");

  const auto errors = missing_inputs(scratch / "report", scratch / "generated");

  BOOST_REQUIRE(errors.size() == 1U);
  BOOST_TEST(errors.front().starts_with(
      "report/main.tex:1:1: the bibliography '../own.bib' lies outside the folder"));
}

BOOST_AUTO_TEST_CASE(a_file_that_would_take_the_place_of_a_generated_one_is_refused) {
  const TemporaryFolder scratch;
  const auto folder = scratch / "report";
  sys::write_file_atomically(folder / "main.tex", "\\input{tables/mine}");
  sys::write_file_atomically(folder / "values.tex", "");
  sys::write_file_atomically(folder / "tables/mine.tex", "");
  sys::write_file_atomically(folder / "tables/periods.tex", "");
  sys::write_file_atomically(folder / "figures/style.gp", "");

  BOOST_TEST(misplaced_files(
                 folder, {"values.tex", "tables/periods.tex", "claims.tex", "figures/style.gp"}) ==
                 (std::vector<std::string>{
                     "report/values.tex: has the name of a file that is generated, and would take "
                     "its place; rename it",
                     "report/tables/periods.tex: has the name of a file that is generated, and "
                     "would take its place; rename it"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(what_the_page_alone_reads_is_no_part_of_the_document) {
  const TemporaryFolder scratch;
  const auto folder = scratch / "report";
  sys::write_file_atomically(folder / "main.tex", "\\input{parts/page}\n\\input{./page}\n");
  sys::write_file_atomically(folder / "page.tex", "");
  sys::write_file_atomically(folder / "parts/page.tex", "");

  BOOST_TEST(document_files(folder) == (std::vector<std::string>{"main.tex", "parts/page.tex"}),
             boost::test_tools::per_element());
  BOOST_TEST(misplaced_files(folder, {}) ==
                 (std::vector<std::string>{
                     "report/main.tex:2:1: page.tex is read for the page alone; rename this part"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
