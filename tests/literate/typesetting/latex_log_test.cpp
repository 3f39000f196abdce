// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/typesetting/latex_log.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(latex_log_test)

using namespace literate;
using Lines = std::vector<std::string>;

BOOST_AUTO_TEST_CASE(an_error_comes_with_file_line_and_place) {
  const auto errors = latex_errors(
      "(./main.tex\n./part/a.tex:12: Undefined control sequence.\nl.12 \\foo\n          bar\n"
      "./part/a.tex:12:  ==> Fatal error occurred, no output PDF file produced!\n",
      "report");

  BOOST_TEST(errors == (Lines{"report/part/a.tex:12: Undefined control sequence.\n  l.12 \\foo"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_command_that_stands_in_a_macro_is_told_with_the_line_that_calls_it) {
  BOOST_TEST(
      latex_errors("./main.tex:9: Undefined control sequence.\n<argument> $\\foo \n         $\n"
                   "l.9 \\front\n\n./main.tex:9: Missing $ inserted.\n<inserted text> \n    $\n"
                   "l.9 \\front\n\n./main.tex:3: Undefined control sequence.\n"
                   "<recently read> \\bar \nl.3 a \\bar\n         b\n",
                   "report") ==
          (Lines{"report/main.tex:9: Undefined control sequence.\n  <argument> $\\foo\n"
                 "  l.9 \\front",
                 "report/main.tex:9: Missing $ inserted.\n  l.9 \\front",
                 "report/main.tex:3: Undefined control sequence.\n  l.3 a \\bar"}),
      boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_text_of_a_box_is_no_error) {
  BOOST_TEST(
      latex_errors("(./main.tex\nUnderfull \\hbox (badness 1389) in paragraph at lines 1--2\n"
                   "\\T1/txr/m/n/10 23T09:52:39Z, that is\n[]\n\n./main.tex:7: Bad.\n",
                   "report") == (Lines{"report/main.tex:7: Bad."}),
      boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(defects_come_with_the_file_that_was_open) {
  const std::string log =
      "(./main.tex (/usr/share/x.sty) (./a.tex\n"
      "LaTeX Warning: Reference `fig:x' on page 1 undefined on input line 7.\n"
      "\n"
      "Overfull \\hbox (0.05pt too wide) in paragraph at lines 1--2\n[] text :-) (\n\n"
      ")\n"
      "Overfull \\hbox (12.5pt too wide) in paragraph at lines 8--9\n[] text ) (./z.tex\n\n"
      "LaTeX Warning: Label `a' multiply defined.\n"
      "Missing character: There is no x in font cmr10!\n"
      "LaTeX Warning: There were undefined references.\n"
      "Package biblatex Warning: Something (1) else.\n";

  BOOST_TEST(
      latex_defects(log, "report") ==
          (Lines{"report/a.tex:7: LaTeX Warning: Reference `fig:x' on page 1 undefined on input "
                 "line 7.",
                 "report/main.tex:8: Overfull \\hbox (12.5pt too wide) in paragraph at lines 8--9",
                 "report/main.tex: LaTeX Warning: Label `a' multiply defined.",
                 "report/main.tex: Missing character: There is no x in font cmr10!"}),
      boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_group_that_is_not_closed_is_a_defect) {
  const std::string log =
      "(./main.tex (/usr/share/x.sty) [1] (./main.aux) )\n"
      "(\\end occurred inside a group at level 1)\n\n"
      "### simple group (level 1) entered at line 3 ({)\n### bottom level\n";

  BOOST_TEST(latex_defects(log, "report") ==
                 (Lines{"report/main.tex: the group that begins in line 3 of this file, or of one "
                        "that it reads, is not closed ({)"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(boxes_are_reported_from_a_tenth_of_a_point_on) {
  const auto overfull = [](const std::string& points) {
    return latex_defects(
        "(./a.tex\nOverfull \\vbox (" + points + "pt too high) detected at line 3\n", "report");
  };

  BOOST_TEST(overfull("0.1").empty());
  BOOST_TEST(overfull("0.10001") ==
                 (Lines{"report/a.tex:3: Overfull \\vbox (0.10001pt too high) detected at line 3"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(what_a_class_puts_around_the_page_may_stand_out_by_a_blank) {
  const auto n_overfull = [](const std::string& points) {
    return latex_defects("(./a.tex\nOverfull \\hbox (" + points +
                             "pt too wide) has occurred while \\output is active\n",
                         "report")
        .size();
  };

  BOOST_TEST(n_overfull("2.22221") == 0U);
  BOOST_TEST(n_overfull("3.00001") == 1U);
}

BOOST_AUTO_TEST_CASE(a_paragraph_that_began_in_another_file_has_the_line_where_it_ends) {
  const auto line_of = [](const std::string& lines) {
    return latex_defects(
               "(./a.tex\nOverfull \\hbox (9.0pt too wide) in paragraph at lines " + lines + "\n",
               "report")
        .front()
        .substr(0, 16);
  };

  BOOST_TEST(line_of("171--48") == "report/a.tex:48:");
  BOOST_TEST(line_of("9--171") == "report/a.tex:9: ");
}

// As pdfTeX 1.40.24 writes it where \excerpt stands right behind the paragraph, which it ends.
BOOST_AUTO_TEST_CASE(
    a_paragraph_that_an_excerpt_ends_has_the_line_of_the_document_where_it_begins) {
  const std::string overfull = "Overfull \\hbox (9.0pt too wide) in paragraph at lines 22";
  BOOST_TEST(latex_defects("(./a.tex (../build/generated/excerpts/x.tex\n" + overfull + "--1\n",
                           "report") == (Lines{"report/a.tex:22: " + overfull}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_float_that_is_too_large_for_its_page_is_a_defect) {
  BOOST_TEST(
      latex_defects("(./a.tex\nLaTeX Warning: Float too large for page by 9.0pt on input line "
                    "12.\n",
                    "report")
          .size() == 1U);
}

BOOST_AUTO_TEST_CASE(a_sign_that_formulas_lose_is_a_defect) {
  const Lines expected = {
      "r/a.tex:4: LaTeX Warning: Command \\textmu invalid in math mode on input line 4."};
  BOOST_TEST((latex_defects("(./a.tex\nLaTeX Warning: Command \\textmu invalid in math mode on "
                            "input line 4.\n",
                            "r") == expected));
}

BOOST_AUTO_TEST_CASE(an_undefined_citation_is_a_defect) {
  BOOST_TEST(latex_defects("(./a.tex\nLaTeX Warning: Citation `none' on page 2 undefined on input "
                           "line 12.\n",
                           "report") ==
                 (Lines{"report/a.tex:12: LaTeX Warning: Citation `none' on page 2 undefined on "
                        "input line 12."}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(errors_of_the_engine_itself_are_recognised) {
  BOOST_TEST(
      latex_errors("(./main.tex\n!pdfTeX error: pdflatex (file x.pdf): cannot find image\n",
                   "report") == (Lines{"!pdfTeX error: pdflatex (file x.pdf): cannot find image"}),
      boost::test_tools::per_element());
  BOOST_TEST(latex_errors("!!! no error\n", "report").empty());
}

BOOST_AUTO_TEST_CASE(who_asks_for_another_run_is_heard) {
  const std::string package = "Package: rerunfilecheck 2022-07-10 v1.10 Rerun checks for files\n";
  const std::string asks =
      "LaTeX Warning: Label(s) may have changed. Rerun to get cross-references right.";

  BOOST_TEST(rerun_request(package).empty());
  BOOST_TEST(rerun_request(package + asks + "\n") == asks);
  BOOST_TEST(
      !rerun_request("Package longtable Warning: Table widths have changed. Rerun LaTeX.").empty());
}

BOOST_AUTO_TEST_CASE(a_file_that_is_not_there_is_told_where_it_is_asked_for) {
  const auto errors = latex_errors(
      "(./main.tex\n! LaTeX Error: File `no.sty' not found.\n\nType X to quit.\n"
      "./main.tex:9: Emergency stop.\n<read *>\n\nl.9 \\usepackage{lmodern}\n",
      "report");

  BOOST_TEST(errors == (Lines{"report/main.tex:9: LaTeX Error: File `no.sty' not found.\n"
                              "  l.9 \\usepackage{lmodern}"}),
             boost::test_tools::per_element());
}

// As pdfTeX 1.40.24 writes it.
BOOST_AUTO_TEST_CASE(a_document_that_does_not_end_is_told_as_such) {
  const auto errors = latex_errors(
      "LaTeX Font Info:    ... okay on input line 1.\n)\n! Emergency stop.\n<*> main.tex\n\n"
      "Here is how much of TeX's memory you used:\n"
      "!  ==> Fatal error occurred, no output PDF file produced!\n",
      "report");

  BOOST_TEST(errors == Lines{"the document ends without \\end{document}"},
             boost::test_tools::per_element());
}

// As BibTeX 0.99d of TeX Live 2022 writes it.
BOOST_AUTO_TEST_CASE(errors_of_bibtex_come_with_file_and_line) {
  const std::string log =
      "This is BibTeX, Version 0.99d (TeX Live 2022/Debian)\nThe style file: plain.bst\n"
      "I couldn't open database file none.bib\n---line 24 of file main.aux\n : \\bibdata{none\n"
      "Database file #1: part/a.bib\n"
      "I was expecting a `,' or a `}'---line 5 of file part/a.bib\n : \n"
      "Warning--empty journal in curie\n(There were 2 error messages)\n";

  BOOST_TEST(bibtex_errors(log, "report") ==
                 (Lines{"BibTeX: I couldn't open database file none.bib",
                        "report/part/a.bib:5: BibTeX: I was expecting a `,' or a `}'"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
