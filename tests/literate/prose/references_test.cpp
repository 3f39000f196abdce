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

const Names names{.values = {{"peak.pressure", "a.cpp:1"}, {"load", "a.cpp:2"}},
                  .tables = {{"results", "a.cpp:6"}},
                  .figures = {{"pressure", "a.cpp:5"}},
                  .numbers = {},
                  .flags = {{"converged", true}, {"diverged", false}},
                  .flag_places = {{"converged", "a.cpp:3"}, {"diverged", "a.cpp:4"}},
                  .excerpts = {"hertz"},
                  .claims = {{"load-is-peak", {"load.cpp:3:1", "confirmed", "confirmed"}}},
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

BOOST_AUTO_TEST_CASE(a_command_in_the_label_of_a_figure_is_told_with_the_line_of_its_script) {
  const TemporaryFolder scratch;
  const auto report = scratch / "report";
  sys::write_file_atomically(report / "main.tex", "\n\\fig{f}\n");
  sys::write_file_atomically(scratch / "figures/f.gp", "plot 1\nset xlabel '$\\nonsense$'\n");
  sys::write_file_atomically(scratch / "figures/style.gp", "set title '\\shared'\n");
  const auto told = [&](const std::string& read) {
    const std::string message = "generated/figures/f/f.tex:9: Undefined control sequence.\n  ";
    const std::string all = with_place_of_use(message + read, report, scratch / "figures");
    return all.substr(0,
                      all.find(": in figure 'f': Undefined control sequence. (figures/f/f.tex:9"));
  };

  BOOST_TEST(told("<recently read> \\nonsense\n  l.9 \\gplfronttext") ==
             "figures/f.gp:2, drawn for report/main.tex:2");
  BOOST_TEST(told("<argument> $\\alpha \\shared") ==
             "figures/style.gp:1, drawn for report/main.tex:2");
  BOOST_TEST(told("<recently read> \\elsewhere\n  l.9 x") == "report/main.tex:2");
  BOOST_TEST(told("l.9 \\nonsense") == "report/main.tex:2");
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
