// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/references.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(references_test)

using namespace literate;
using Lines = std::vector<std::string>;

namespace {

const Names names{.values = {"peak.pressure", "load"},
                  .numbers = {},
                  .flags = {{"converged", true}, {"diverged", false}},
                  .tables = {"results"},
                  .figures = {"pressure"},
                  .excerpts = {"hertz"},
                  .claims = {{"load-is-peak", {1, "load.cpp:3:1", "confirmed", "confirmed"}}},
                  .figure_places = {{"pressure", "a.cpp:5"}},
                  .value_places = {{"peak.pressure", "a.cpp:1"}, {"load", "a.cpp:2"}},
                  .flag_places = {{"converged", "a.cpp:3"}, {"diverged", "a.cpp:4"}},
                  .table_places = {{"results", "a.cpp:6"}},
                  .texts = {},
                  .faults = {},
                  .files = {}};

ReferenceReport report_on(const std::string& text) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "report/part/a.tex",
                             text + "\n\\statement{load-is-peak}{The load is a peak.}\n");
  return check_references(scratch / "report", names);
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_unknown_key_has_file_line_column_and_the_nearest_name) {
  const auto report = report_on("\\val{load}\n  é \\val{peak.presure} and \\tab{x}\n");

  BOOST_TEST(
      report.errors == (Lines{"report/part/a.tex:2:5: unknown value 'peak.presure', did you mean "
                              "'peak.pressure'?",
                              "report/part/a.tex:2:28: unknown table 'x'"}),
      boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_flag_that_is_asked_for_as_a_value_is_told_to_be_one) {
  BOOST_TEST(report_on("\\val{diverged}").errors ==
                 Lines{"report/part/a.tex:1:1: 'diverged' is a flag, which "
                       "\\ifflag{diverged}{yes}{no} asks for"},
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(each_kind_is_looked_up_among_its_own) {
  BOOST_TEST(
      report_on(
          "\\val "
          "{load}\\ifflag{converged}{\\val{peak.pressure}}{}\\ifflag{diverged}{}{}\\tab{results}"
          "\\fig{pressure}\\excerpt{hertz}\\claim{load-is-peak}")
          .unused.empty());
  BOOST_TEST(report_on("\\val{results}\\ifflag{load}{}{}\\tab{pressure}\\fig{hertz}\\excerpt{load}")
                 .errors.size() == 5U);
}

BOOST_AUTO_TEST_CASE(the_words_of_a_finding_name_a_claim) {
  const auto report =
      report_on("\\findingsays{load-is-pek}{The load is.}\\finding{load-is-peak}{So it is.}");

  BOOST_TEST(
      report.errors ==
          (Lines{
              "report/part/a.tex:1:1: unknown claim 'load-is-pek', did you mean 'load-is-peak'?"}),
      boost::test_tools::per_element());
  BOOST_TEST(std::ranges::count(report.unused, "load.cpp:3:1: claim 'load-is-peak'") == 0);
}

BOOST_AUTO_TEST_CASE(bare_digits_are_a_use_of_their_value) {
  const auto report = report_on("\\rule{\\rawval{load}cm}{1ex}\\rawval{lode}");

  BOOST_TEST(report.errors ==
                 (Lines{"report/part/a.tex:1:28: unknown value 'lode', did you mean 'load'?"}),
             boost::test_tools::per_element());
  BOOST_TEST(std::ranges::count(report.unused, "a.cpp:2: value 'load'") == 0);
  BOOST_TEST(std::ranges::count(report.unused, "a.cpp:1: value 'peak.pressure'") == 1);
}

BOOST_AUTO_TEST_CASE(a_branch_that_is_not_taken_may_use_what_is_not_registered) {
  const std::string taken = "\\ifflag{converged}{\\val{a}}{\\val{load}}\\val{load}";
  const std::string left_out =
      "\\ifflag{converged}%\n{\\val{load}}% comment\n {x {y} "
      "\\ifflag{diverged}{\\val{a}}{\\val{b}}}"
      "\\ifflag{diverged}{\\val{c}}{\\val{load}}";

  BOOST_TEST(report_on(taken).errors.size() == 1U);
  BOOST_TEST(report_on(left_out).errors.empty());
  BOOST_TEST(report_on(left_out + "\\val{d}").errors.size() == 1U);
  BOOST_TEST(report_on("\\ifflag{diverged}{\\val{c}} \\val{e} {\\val{f}}").errors.size() == 2U);
}

BOOST_AUTO_TEST_CASE(what_is_registered_and_not_used_is_listed_with_its_place) {
  BOOST_TEST(report_on("\\val{load}").unused ==
                 (Lines{"a.cpp:1: value 'peak.pressure'", "a.cpp:3: flag 'converged'",
                        "a.cpp:4: flag 'diverged'", "a.cpp:6: table 'results'",
                        "a.cpp:5: figure 'pressure'", "load.cpp:3:1: claim 'load-is-peak'"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_ledger_uses_every_claim) {
  const auto is_unused = [](const std::string& text) {
    return std::ranges::count(report_on(text).unused, "load.cpp:3:1: claim 'load-is-peak'") == 1;
  };

  BOOST_TEST(!is_unused("x \\claimledger\n"));
  BOOST_TEST(is_unused("% \\claimledger\n"));
}

BOOST_AUTO_TEST_CASE(comments_definitions_and_verbatim_are_no_uses) {
  const auto report = report_on(
      "% \\val{a}\n"
      "50\\% \\val{load} \\\\% \\val{b}\n"
      "\\newcommand{\\val}[1]{}\\def\\fig#1{\\val{#1}} \\value{page}\n"
      "\\verb|\\val{c}| \\verb*+\\tab{d}+\n"
      "\\begin{verbatim}\n\\val{e}\n\\end{verbatim} \\val{peak.pressure}\n");

  BOOST_TEST(report.errors.empty());
  BOOST_TEST(report.unused.size() == 5U);
}

BOOST_AUTO_TEST_CASE(a_missing_folder_is_an_output_error) {
  BOOST_CHECK_THROW(check_references("no such folder", names), sys::OutputError);
}

BOOST_AUTO_TEST_CASE(a_document_in_a_folder_below_is_another_one) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(
      scratch / "report/report.tex",
      "\\documentclass{article}\\val{load}\\statement{load-is-peak}{So it is.}\n");
  sys::write_file_atomically(scratch / "report/part/a.tex", "% \\documentclass{no}\n\\val{here}\n");
  sys::write_file_atomically(scratch / "report/other/main.tex",
                             "% what it is\n \\documentclass{article}\n\\val{there}\n");
  sys::write_file_atomically(scratch / "report/other/below/b.tex", "\\val{there}\n");

  const auto report = check_references(scratch / "report", names);

  BOOST_TEST(report.errors == Lines{"report/part/a.tex:2:1: unknown value 'here'"},
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
