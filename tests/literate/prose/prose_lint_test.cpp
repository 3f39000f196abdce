// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/prose.hpp"

#include <boost/test/unit_test.hpp>

#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(prose_lint_test)

using namespace literate;

namespace {

// The numbers that the lint finds in a text, a blank behind each.
std::string found_in(const std::string& latex) {
  std::string numbers;
  for (const std::string& finding : typed_numbers(latex, "a.tex")) {
    const auto begin = finding.find(": ") + 2;
    numbers += finding.substr(begin, finding.find(' ', begin) - begin) + " ";
  }
  return numbers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_typed_result_has_file_line_column_and_what_to_do) {
  BOOST_TEST(typed_numbers("one\né the peak is 1.234 high\n", "s/a.tex") ==
                 (std::vector<std::string>{
                     "s/a.tex:2:15: 1.234 is typed: take it from the computation, or, if it is no "
                     "result, end the line with '% constant: reason'"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(more_than_two_significant_digits_are_a_result) {
  BOOST_TEST(found_in("123, 1.50, 0.00123, 1.23e-6, 12,345 and 1\\,234 and 1{,}234") ==
             "123 1.50 0.00123 1.23e-6 12,345 1\\,234 1{,}234 ");
  BOOST_TEST(found_in("12 500 runs, 12~500 runs, 12 5000, 10 000, 2 100") == "12 12~500 ");
  BOOST_TEST(found_in("$11{.}4$, in 12:34:56 and 12:34") == "11{.}4 12:34:56 ");
  BOOST_TEST(found_in("12 and 0.05, 1000, 2.5e-6, $10^{-4}$, $\\tfrac32$, $\\num{0.9}a$") == "");
  BOOST_TEST(found_in("$x = 1.234$ and \\num{1.234}") == "1.234 1.234 ");
}

BOOST_AUTO_TEST_CASE(a_number_with_a_unit_is_a_result_however_short) {
  BOOST_TEST(found_in("2 mm, 3~psi, 4\\,N, 5\\%, 6 per cent, 7 pounds/inch, 8-inch, 9 in.") ==
             "2 3 4 5 6 7 8 9 ");
  BOOST_TEST(found_in("\\qty{2}{mm}, $2\\,\\mathrm{MPa}$, $3$ mm, $-4~\\text{in}$") == "2 2 3 4 ");
  BOOST_TEST(found_in("$7\\ \\text{s}$, $8\\,\\text{s}$, 9~s, $6\\;\\mathrm{s}$") == "7 8 9 6 ");
  BOOST_TEST(found_in("$12\\times 10^{3}$ Pa, $1.2\\cdot10^5\\,\\text{Pa}$, 3 MPa") == "12 1.2 3 ");
  BOOST_TEST(found_in("3.5~min, 4 min, 5~h, 6 days, 7 eV, 8~eV, 4.0(2)~s, 9\\,mol, 2~hectare") ==
             "3.5 4 5 6 7 8 4.0 9 2 ");
  BOOST_TEST(found_in("60 dB, 61~dB, 20 µPa, 21 $\\mu$Pa, 7 µm, 3 Np, 5 nF and 4 kW") ==
             "60 61 20 21 7 3 5 4 ");
  BOOST_TEST(
      found_in(
          "37 °C, 38\\,°F, $39\\,^\\circ\\mathrm{C}$, $40^{\\circ}$, 41\\degree{} and $5\\%$") ==
      "37 38 39 40 41 5 ");
  BOOST_TEST(found_in("6 $\\mathrm{km}$, $7$ $\\text{km}$, 8 \\textrm{km}, 9\\,$\\Omega$, "
                      "$10\\,\\Omega$, 11/d") == "6 7 8 9 10 11 ");
  BOOST_TEST(
      found_in("1 \\AA, 2~\\textcelsius, \\ang{3}, 4\\textdegree, 5 \\textohm, 12$'$, $13'$, "
               "$14^\\prime$, 15 kWh, 16~\\textmu m") == "1 2 3 4 5 12 13 14 15 16 ");
  BOOST_TEST(found_in("$2\\Omega$, $f\\circ g$, 3/2, 1/e, 4 \\text{kings}") == "");
  BOOST_TEST(found_in("at 10 am, 3 as good, 2 us, 4 a day") == "");
  BOOST_TEST(found_in("row 2~of the table, 3~to 4~and 5\\,more") == "");
  BOOST_TEST(found_in("row 2 in the table, 3 Kings, 2 nodes, 4 nothing, $2\\,m$, 5 minus 3") == "");
}

BOOST_AUTO_TEST_CASE(equations_keep_their_constants_but_not_their_units) {
  BOOST_TEST(found_in("\\[ x = 1.234 y \\] $$2.345$$ \\begin{align*}3.456\\end{align*}") == "");
  BOOST_TEST(found_in("\\begin{equation}x = 1.5\\,\\mathrm{mm}\\end{equation} 1.234") ==
             "1.5 1.234 ");
}

BOOST_AUTO_TEST_CASE(what_is_no_prose_is_not_read) {
  BOOST_TEST(found_in("% 1.234\n\\val{a.1234}\\label{tab:1234}\\cref{eq:123,eq:456}\\verb|1.234|\n"
                      "\\begin{verbatim}\n1.234 mm\n\\end{verbatim}\n") == "");
  BOOST_TEST(found_in("\\setlength{\\tabcolsep}{2.5pt}\\vspace*{12mm}\\\\[1.25cm]"
                      "\\includegraphics[width=123mm]{a}\\begin{tabular}{p{123mm}}") == "");
  BOOST_TEST(found_in("\\geometry{top=1.234cm}\\begin{document}1.235\\end{document}") == "1.235 ");
  BOOST_TEST(found_in("\\begin{thebibliography}{99}1.234\\end{thebibliography}") == "");
  BOOST_TEST(found_in("MEAE-4960, SHA-256, a1234, x_123, \\code{Fig123}") == "");
}

BOOST_AUTO_TEST_CASE(the_caption_of_a_table_that_breaks_over_pages_is_prose) {
  BOOST_TEST(
      found_in("\\tab[It takes 1.234 \\val{k-1.777}.]{t-1.888} and \\val[digits=3456]{k} 1.999") ==
      "1.234 1.999 ");
}

BOOST_AUTO_TEST_CASE(years_and_places_in_sources_are_no_results) {
  BOOST_TEST(found_in("Ruggiero (2001), 23 April 2001") == "");
  BOOST_TEST(found_in("(\\cite{a}, 13.12; \\cite{b}, chapter 1.23)") == "");
  BOOST_TEST(found_in("(2.25b) and (2.25a) of \\cite{a}, and (4.49) of~\\cite{a}") == "");
  BOOST_TEST(found_in("in 1921 \\cite{a}, 1921~\\cite{a}, \\cite{a} of 1921, \\cite{a} in 1921") ==
             "");
  BOOST_TEST(found_in("Page 123 of \\cite{a}, p.~123 of~\\cite{a}, equation 2.25 of \\cite{a}") ==
             "");
  BOOST_TEST(found_in("\\cite{a}, pp.~123--145 and eq.~(4.45), no.~123") == "");
  BOOST_TEST(found_in("as in~\\cite{a}, at 17 kW, and $x = 3.14159$, or 1999 of 12~\\%") ==
             "17 3.14159 1999 12 ");
  BOOST_TEST(found_in("\\cite{a}, 17 kW; $10^5$ Pa, $2^{16}$ nodes") == "17 10^5 ");
  BOOST_TEST(found_in("1234~\\cite{a}. 1921 points \\cite{a}") == "1234 1921 ");
  BOOST_TEST(found_in("2001 points (2.25) by \\cite{a}: 1.234") == "2001 2.25 1.234 ");
}

// A pattern that repeats a repetition would not end within the age of the author.
BOOST_AUTO_TEST_CASE(long_text_behind_a_citation_is_read_to_its_end) {
  for (const char filling : {' ', '1', '.', '~'}) {
    const std::string text = "\\cite{a}, " + std::string(200, filling) + " kinds, x of 12.345";
    BOOST_TEST(found_in(text).ends_with("12.345 "), filling);
  }
}

BOOST_AUTO_TEST_CASE(a_marked_line_is_exempt_if_its_mark_has_a_reason) {
  BOOST_TEST(found_in("a ``1000 pound/inch load'' % constant: the paper's words\n") == "");
  BOOST_TEST(typed_numbers("1.234 % constant:\n1.234 50\\% constant\n", "a").size() == 3U);
  BOOST_TEST(typed_numbers("no number % constant: old\n", "a").front() ==
             "a:1:1: a constant is marked where none is typed");
}

BOOST_AUTO_TEST_CASE(a_line_of_any_length_may_have_a_mark) {
  const std::string reason = "% constant: " + std::string(1'000'000, 'x');
  BOOST_TEST(typed_numbers("at 1.234 " + reason, "a.tex").empty());
  BOOST_TEST(typed_numbers("100\\% constant: 1.234 " + reason, "a.tex").empty());
  BOOST_TEST(!typed_numbers("at 1.234 100\\% constant", "a.tex").empty());
}

BOOST_AUTO_TEST_CASE(all_tex_files_below_a_folder_are_read) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "report/b.tex", "1.234");
  sys::write_file_atomically(scratch / "report/a/c.tex", "\n 2 mm");
  sys::write_file_atomically(scratch / "report/a/c.txt", "2 mm");

  const auto findings = typed_numbers_below(scratch / "report");

  BOOST_REQUIRE(findings.size() == 2U);
  BOOST_TEST(findings[0].starts_with("report/a/c.tex:2:2: 2 is typed"));
  BOOST_TEST(findings[1].starts_with("report/b.tex:1:1: 1.234 is typed"));
  BOOST_CHECK_THROW(typed_numbers_below(scratch / "none"), sys::OutputError);
}

BOOST_AUTO_TEST_CASE(a_result_typed_into_a_text_of_the_program_is_told_with_its_line) {
  const std::vector<NamedText> texts = {
      {"reason of claim 'widening'", "friction.cpp:12", "it widens by 6 \\%"},
      {"route of claim 'widening'", "friction.cpp:12", "a quarter of $(c/a)^2$, by eq. (2)"},
      {"heading of table 'wide'", "friction.cpp:40", "at 1.25 $a$"}};

  BOOST_TEST(typed_numbers_in(texts) ==
                 (std::vector<std::string>{"friction.cpp:12: 6 is typed in the reason of claim "
                                           "'widening': say it without the number, or compute it",
                                           "friction.cpp:40: 1.25 is typed in the heading of table "
                                           "'wide': say it without the number, or compute it"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(titles_and_definitions_of_a_preamble_are_prose) {
  const auto found = [](const std::string& preamble) {
    return found_in("\\documentclass{a}\n" + preamble + "\n\\begin{document}\\end{document}");
  };

  BOOST_TEST(found("\\title[Of 1.234]{At 5 mm, \\val{k-1.777}}\\setlength{\\x}{1.235cm}") ==
             "1.234 5 ");
  BOOST_TEST(found("\\newcommand{\\x}{1.236}\\newcommand*\\y[1][1.237]{#1 and 7 mm}") ==
             "1.236 1.237 7 ");
  BOOST_TEST(found("\\def\\x{1.238}\\newcommand\\y{\\vspace{123mm}}\\renewcommand\\z{1.239}") ==
             "1.238 ");
  BOOST_TEST(found("\\NewDocumentCommand{\\x}{O{3} m}{1.236}\\NewDocumentCommand\\y{}{7 mm}") ==
             "1.236 7 ");
}

BOOST_AUTO_TEST_CASE(optional_arguments_that_are_printed_are_prose) {
  BOOST_TEST(found_in("\\excerpt[In 1.234 s]{e-1.888}\\caption[Of 1.235]{b}\\section[1.236]{c}") ==
             "1.234 1.235 1.236 ");
  BOOST_TEST(found_in("\\begin{theorem}[Of 1.237]\\item[1.238]\\begin{axis}[width=1.239cm]") ==
             "1.237 1.238 ");
}

BOOST_AUTO_TEST_CASE(texts_and_data_of_a_figures_script_are_looked_at) {
  const std::string script =
      "# 1.111 mm\nset label 'é 1.234' at 0.567,1\nset ylabel \"a \\\" 5 mm\"\nset yrange "
      "[0:1.234]\n"
      "plot d using \"x\":\"y\" lc rgb '#123456' title '20 or so', '-'\nset label '7 mm' # "
      "constant: as printed\n"
      "$d << EOD\n1 2\nEOD\n";

  BOOST_TEST(typed_numbers_in_script(script, "figures/f.gp") ==
                 (std::vector<std::string>{"figures/f.gp:2:14: 1.234 is typed: take it from the "
                                           "computation, or, if it is no result, end the "
                                           "line with '# constant: reason'",
                                           "figures/f.gp:3:18: 5 is typed: take it from the "
                                           "computation, or, if it is no result, end the line "
                                           "with '# constant: reason'",
                                           "figures/f.gp:5:57: a block of data is typed: take it "
                                           "from the computation, or, if it is no result, "
                                           "end the line with '# constant: reason'",
                                           "figures/f.gp:7:1: a block of data is typed: take it "
                                           "from the computation, or, if it is no result, "
                                           "end the line with '# constant: reason'"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(numbers_that_a_script_draws_and_points_that_it_leaves_out_are_told) {
  const std::string script =
      "set xrange [0:1.234]\nplot 93.859 - 32.82*x title 'a', \\\n  d using 1:($2 > 3 ? $2 : 1/0), "
      "\\\n  d using 1:($2 > 3 ? $2 : NaN), \\\n  d every 4 # outside: too dense\nset key at "
      "1.234,5\nset label '$y = 0$'\nplot 0.5*x + 12, 'every 3'\n";

  BOOST_TEST(typed_numbers_in_script(script, "f.gp") ==
                 (std::vector<std::string>{"f.gp:2:6: 93.859 is typed: take it from the "
                                           "computation, or, if it is no result, end the line "
                                           "with '# constant: reason'",
                                           "f.gp:2:15: 32.82 is typed: take it from the "
                                           "computation, or, if it is no result, end the line "
                                           "with '# constant: reason'",
                                           "f.gp:3: '1/0' leaves points out: if it is meant, end "
                                           "the line with '# outside: reason'",
                                           "f.gp:4: 'NaN' leaves points out: if it is meant, end "
                                           "the line with '# outside: reason'"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
