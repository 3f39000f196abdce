// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/marked_report.hpp"
#include "holds.hpp"

#include <fmt/core.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(report_findings_test)

using namespace course;

namespace {

using Lines = std::vector<std::string>;

const std::string computed =
    "\\newcommand*\\halfwidth{0.52221\\,mm}\n\\newcommand*\\approach{0.0538\\,mm}\n";

Lines all_findings(const ReportTexts& texts) {
  Lines findings = findings_of_commands(texts);
  const Lines of_numbers = findings_of_numbers(texts);
  findings.insert(findings.end(), of_numbers.begin(), of_numbers.end());
  return findings;
}

std::string report(const std::string& body) {
  return "\\documentclass{article}\n\\begin{document}\n" + body + "\n\\end{document}\n";
}

void check(const ReportTexts& texts, const Lines& expected) {
  const Lines findings = all_findings(texts);
  BOOST_TEST(findings == expected, boost::test_tools::per_element());
}

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_is_found_in_a_report_that_takes_its_numbers_from_the_program) {
  check({.report = report("It is \\halfwidth{} wide, of order 2."),
         .computed = computed,
         .log = "(./report.tex)\nOutput written on report.pdf (1 page).\n"},
        {});
}

BOOST_AUTO_TEST_CASE(a_number_typed_in_the_prose_is_told_with_its_place) {
  check({.report = report("It is 0.5222 wide."), .computed = computed, .log = ""},
        {"report/report.tex:3:7: 0.5222 is typed: take it from the computation, or, if it is no "
         "result, end the line with '% constant: reason'"});
}

BOOST_AUTO_TEST_CASE(an_error_of_latex_keeps_its_line_where_the_log_tells_no_column) {
  check({.report = report("x"),
         .computed = "",
         .log = "./report.tex:2: LaTeX Error: File `none.sty' not found.\n"
                "./generated/numbers.tex:1: Missing $ inserted.\nl.99 nowhere\n"},
        {"report/report.tex:2: LaTeX Error: File `none.sty' not found.",
         "report/generated/numbers.tex:1: Missing $ inserted."});
}

BOOST_AUTO_TEST_CASE(a_number_that_the_report_defines_anew_is_told_however_that_is_written) {
  for (const char* definition :
       {"\\renewcommand*\\approach{5}", "\\renewcommand{\\approach}{5}", "\\def\\approach{5}",
        "\\gdef \\approach{5}", "\\let\\approach=\\relax", "\\DeclareCommandCopy\\approach\\mine",
        "\\RenewCommandCopy{\\approach}{\\mine}", "\\RenewExpandableDocumentCommand\\approach{}{5}",
        "\\newcommand% why\n\\approach{5}"}) {
    const Lines findings =
        findings_of_commands({.report = report(definition), .computed = computed, .log = ""});
    BOOST_REQUIRE(!findings.empty());
    BOOST_TEST(findings[0].ends_with(": \\approach is defined anew, but numbers.tex has it"),
               findings[0]);
  }
  check({.report = report("\\newcommand\\mine{a} \\approach"), .computed = computed, .log = ""},
        {});
}

BOOST_AUTO_TEST_CASE(a_definition_whose_target_is_not_written_there_is_told) {
  const std::string says = ": defines a command whose name is not written there";
  check({.report = report("\\newcommand\\adapt[2]{\\renewcommand#1{#2}}\n\\adapt\\halfwidth{x}"),
         .computed = computed,
         .log = ""},
        {"report/report.tex:3:35" + says});
  for (const char* definition :
       {"\\renewcommand{#1}{x}", "\\renewcommand* #1{x}", "\\def\\mine#1{\\gdef##1{x}}",
        "\\def~{x}", "\\newcommand\\mine{\\renewcommand}", "\\def\\csname halfwidth\\endcsname{x}",
        "\\renewcommand\\expandafter{x}", "\\RenewDocumentCommand#1{}{x}", "\\addto#1{x}"}) {
    const Lines findings =
        findings_of_commands({.report = report(definition), .computed = computed, .log = ""});
    BOOST_REQUIRE_MESSAGE(!findings.empty(), definition);
    BOOST_TEST(findings[0].ends_with(says), findings[0]);
  }
  check({.report = report("\\newcommand{\\half}[1]{\\def\\mine##1{#1}} \\def\\pair(#1,#2){#1} "
                          "\\addto\\captionsenglish{x} \\renewcommand*% why\n {\\abstractname}{x}"),
         .computed = computed,
         .log = ""},
        {});
}

BOOST_AUTO_TEST_CASE(what_stands_in_a_number_or_shows_a_figure_may_not_be_defined_anew) {
  check({.report = report("\\renewcommand\\,{x}"), .computed = computed, .log = ""},
        {"report/report.tex:3:14: \\, is defined anew, but numbers.tex has it"});
  for (const std::string command : {"includegraphics", "input"}) {
    check({.report = report("\\renewcommand\\" + command + "{generated/numbers.tex}"),
           .computed = "",
           .log = ""},
          {"report/report.tex:3:14: \\" + command +
           " is defined anew, but shows what the program computes"});
  }
}

BOOST_AUTO_TEST_CASE(a_command_that_could_hide_something_is_told_once_where_it_stands_first) {
  const std::string says = " is not needed in an ordinary report; see what it does";
  for (const std::string command :
       {"\\csname", "\\catcode", "\\iffalse", "\\openout", "\\pdfcatalog", "\\expandafter",
        "\\renewenvironment", "\\number", "\\input", "\\primitive", "\\csdef", "\\symbol",
        "\\mathcode"}) {
    check({.report = report("It is " + command + " so, " + command + " and so."),
           .computed = computed,
           .log = ""},
          {"report/report.tex:3:7: " + command + says});
  }
  check({.report = report("\\NewCommandCopy\\mine\\yours"), .computed = computed, .log = ""},
        {"report/report.tex:3:1: \\NewCommandCopy" + says});
  check({.report = report("It is ^^30."), .computed = computed, .log = ""},
        {"report/report.tex:3:7: ^^" + says});
  check({.report = report("\\input{generated/numbers.tex} \\section{x} \\verb|catcode|"),
         .computed = computed,
         .log = ""},
        {});
}

BOOST_AUTO_TEST_CASE(more_errors_than_are_told_are_said_to_be_there) {
  std::string log;
  for (int i = 0; i < 101; ++i) log += fmt::format("./report.tex:{}: Missing $ inserted.\n", i + 1);

  const Lines findings = findings_of_commands({.report = report("x"), .computed = "", .log = log});

  BOOST_REQUIRE(findings.size() == 101U);
  BOOST_TEST(findings.back() == "report/report.tex: there are more errors in typeset.log");
}

BOOST_AUTO_TEST_CASE(bytes_that_are_no_utf8_are_told_and_hinder_nothing) {
  check({.report = report("M\xfcller is 0.5222 wide."), .computed = computed, .log = ""},
        {"report/report.tex:3:2: this is no UTF-8",
         "report/report.tex:3:11: 0.5222 is typed: take it from the computation, or, if it is "
         "no result, end the line with '% constant: reason'"});
}

BOOST_AUTO_TEST_CASE(a_finding_is_one_line_that_turns_no_text) {
  const Lines findings = all_findings({.report = report("x"),
                                       .computed = computed,
                                       .log = "./report.tex:3: say \x1b[31m it\u202E.\n"});
  BOOST_TEST(!findings.empty());
  for (const std::string& finding : findings) {
    for (const char* bad : {"\n", "\x1b", "\u202E"}) {
      BOOST_TEST(!holds(finding, bad), finding);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
