// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/table.hpp"

#include <fmt/core.h>

#include <boost/test/unit_test.hpp>
#include <limits>
#include <source_location>
#include <stdexcept>

#include "holds.hpp"
#include "message_of.hpp"

BOOST_AUTO_TEST_SUITE(table_test)

using literate::Cell;
using literate::Column;
using literate::exact;
using literate::fixed;
using literate::integer;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::supported;
using literate::Table;
using literate::uncertain;
using numerics::Estimate;
using std::invalid_argument;

namespace {

// The number that a table of one column prints for a cell.
std::string printed(const Column& column, const Cell& cell) {
  return Table("t", {column}).add_row({cell}).printed_numbers().at({0, 0});
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_are_as_wide_as_the_widest) {
  Table table("t", {Column("$a$", fixed(2)).exact(), Column("$e$", scientific(3), "in").exact(),
                    Column("$n$", integer())});
  table.add_row({-1.0, 1.5e-6, 12}).add_row({123.46, -2.39e-12, 1200});

  const std::string latex = table.latex();

  BOOST_TEST(holds(latex, "{ccc}"));
  BOOST_TEST(holds(latex,
                   "  $\\hphantom{00}{-}1.00$ & "
                   "$\\hphantom{-}1.50\\times10^{-6\\hphantom{0}}$ & "
                   "$\\hphantom{00}12$ \\\\\n"));
  BOOST_TEST(holds(latex, "$\\hphantom{-}123.46$ & "));
  BOOST_TEST(holds(latex,
                   "${-}2.39\\times10^{-12}$ & "
                   "$1200$ \\\\\n"));
}

BOOST_AUTO_TEST_CASE(a_scaled_column_moves_its_power_of_ten_to_the_unit_line) {
  Table table("t", {Column("$v$", fixed(3), "in").scaled(-6).exact(),
                    Column("$E$", fixed(1), "psi").scaled(6).exact(),
                    Column("$k$", fixed(0)).scaled(3).exact()});
  table.add_row({1.624e-6, 30e6, 2000.0});

  const std::string latex = table.latex();

  BOOST_TEST(holds(latex, "(\\qty{e-6}{in}) & (\\qty{e6}{psi}) & (\\num{e3})"));
  BOOST_TEST(holds(latex, "$1.624$ & $30.0$ & $2$ \\\\\n"));
}

BOOST_AUTO_TEST_CASE(a_common_exponent_is_that_of_the_largest_magnitude) {
  Table table("t", {Column("$p$", significant(3), "psi").exact()});
  table.add_row({100.0}).add_row({-10000.0}).add_row({0.0});

  const std::string latex = table.latex();

  BOOST_TEST(holds(latex, "(\\qty{e4}{psi})"));
  BOOST_TEST(holds(latex,
                   "  $\\hphantom{-}0.01$ \\\\\n"
                   "  ${-}1.00$ \\\\\n"
                   "  $\\hphantom{-}0.00$ \\\\\n"));
}

BOOST_AUTO_TEST_CASE(a_common_exponent_is_not_below_the_errors) {
  Table table("t", {Column("difference", significant(2))});
  table.add_row({Estimate{3e-16, 2e-14}}).add_row({Estimate{-4e-17, 0}});

  const std::string latex = table.latex();

  BOOST_TEST(holds(latex, "(\\num{e-13})"));
  BOOST_TEST(holds(latex, "$\\hphantom{-}0"));
  BOOST_TEST(holds(latex, "${-}4\\times10^{-4}$"));
}

BOOST_AUTO_TEST_CASE(without_units_there_is_no_unit_line) {
  Table table("t", {Column::text("Case"), Column("$x$", fixed(1)).exact()});
  table.add_row({"50 %", 1.0}).add_row({Cell::latex("$\\infty$"), {}}).add_row({"c", "none"});

  BOOST_TEST(table.latex() ==
             "\\begin{tabular}{lc}\n"
             "  \\toprule\n"
             "  Case & $x$ \\\\\n"
             "  \\midrule\n"
             "  50 \\% & $1.0$ \\\\\n"
             "  $\\infty$ &  \\\\\n"
             "  c & none \\\\\n"
             "  \\bottomrule\n"
             "\\end{tabular}\n");
}

BOOST_AUTO_TEST_CASE(a_column_of_texts_may_have_a_width) {
  Table table("t", {Column::text("remark", 4.5), Column::text("case")});
  table.add_row({"a long one", "b"});

  BOOST_TEST(holds(table.latex(), "\\begin{tabular}{>{\\LiterateLines}p{4.5cm}l}"));
  BOOST_CHECK_THROW(Column::text("remark", -1), invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_cell_prints_no_digit_that_its_error_does_not_support) {
  BOOST_TEST(printed(Column("x", fixed(5)), Estimate{0.123456, 1e-9}) == "0.12346");
  BOOST_TEST(printed(Column("x", fixed(5)), Estimate{0.123456, 2e-3}) == "0.12");
  BOOST_TEST(printed(Column("x", fixed(2)), Estimate{1234.5, 40}) == "1.2e3");
  BOOST_TEST(printed(Column("x", scientific(4)), Estimate{2.3456e-7, 3e-9}) == "2.3e-7");
  BOOST_TEST(printed(Column("x", scientific(2)), Estimate{3e-17, 2e-15}) == "0e-14");
  BOOST_TEST(printed(Column("x", significant(4), "in"), Estimate{1.23456e-6, 3e-9}) == "1.23e-6");
  BOOST_TEST(printed(Column("x", fixed(4), "in").scaled(-6), Estimate{1.23456e-6, 3e-9}) ==
             "1.23e-6");
  BOOST_TEST(printed(Column("x", percent(2)), Estimate{0.123456, 2e-3}) == "12");
  BOOST_TEST(printed(Column("x", supported(9)), Estimate{0.123456, 2e-3}) == "0.12");
}

BOOST_AUTO_TEST_CASE(a_cell_that_is_not_zero_is_not_printed_as_zero) {
  BOOST_TEST(printed(Column("x", fixed(3)), Estimate{-3e-4, 1e-7}) == "-3.0e-4");
  BOOST_TEST(printed(Column("x", fixed(2)).exact(), 0.004) == "0.004");
  BOOST_TEST(printed(Column("x", fixed(3)), Estimate{-3e-4, 1e-2}) == "0.00");
  BOOST_TEST(printed(Column("x", fixed(3)).exact(), 0.0) == "0.000");
  BOOST_TEST(printed(Column("x", fixed(2)), numerics::Measured(-0.64, 1.55, "scatter")) ==
             "-0.6(16)");
  BOOST_TEST(printed(Column("x", fixed(2)), Estimate{4.9, 5.1}) == "4.9±5.1");
}

BOOST_AUTO_TEST_CASE(an_exact_number_is_not_rounded) {
  BOOST_TEST(printed(Column("x", fixed(1)).scaled(-6).exact(), 0.34e-6) == "0.34e-6");
  BOOST_TEST(printed(Column("x", fixed(1)).scaled(-6).exact(), 0.3e-6) == "0.3e-6");
  BOOST_TEST(printed(Column("x", fixed(2)).exact(), -0.3333) == "-0.3333");
  BOOST_TEST(printed(Column("x", percent(1)).exact(), 0.12345) == "12.345");
  BOOST_TEST(printed(Column("x", scientific(1)).exact(), 2.5e-7) == "2.5e-7");
  BOOST_TEST(printed(Column("x", significant(1)).exact(), 0.25) == "2.5e-1");
  BOOST_TEST(printed(Column("x", exact()), 2.5e-7) == "2.5e-7");
  // What the arithmetic of a grid leaves is no digit of its points.
  BOOST_TEST(printed(Column("x", fixed(1)).exact(), 3 * 0.1) == "0.3");
  BOOST_TEST(printed(Column("x", fixed(1)).scaled(-6).exact(), 1.2345678901234567e-6) ==
             "1.2345678901234567e-6");
  BOOST_TEST(printed(Column("x", fixed(20)).exact(), 0.3) == "0.30000000000000000000");
  BOOST_TEST(printed(Column("x", fixed(1)).exact(), 3 * 0.15) == "0.45");
}

BOOST_AUTO_TEST_CASE(a_number_without_its_error_is_refused_with_table_row_and_column) {
  Table table("periods", {Column::text("case"), Column("$T/T_0$", fixed(4), "s")});
  table.add_row({"a", Estimate{1.5, 1e-4}});

  const std::string bare = message_of<invalid_argument>([&] { table.add_row({"c", 1.25}); });

  const std::string place = "tests/literate/tables/table_test.cpp:";
  BOOST_TEST(bare.starts_with(place));
  BOOST_TEST(holds(bare, "table 'periods' (begun at " + place));
  BOOST_TEST(
      holds(bare,
            "), row 2, column 2 '$T/T_0$': 1.25 comes without its error: give an Estimate, or "
            "declare the column exact"));
  BOOST_TEST(table.rows().size() == 1U);
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_a_column_is_refused) {
  const auto refused = [](const Column& column, const Cell& cell) {
    BOOST_CHECK_THROW(Table("t", {column}).add_row({cell}), invalid_argument);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  BOOST_CHECK_THROW(Table("t", {}), invalid_argument);
  BOOST_CHECK_THROW(Table("t", {Column("n", integer())}).add_row({1, 2}), invalid_argument);
  refused(Column("n", integer()), 1.5);
  refused(Column("n", integer()), Estimate{2, 0.5});
  refused(Column::text("n"), 1);
  refused(Column("n", fixed(1)).exact(), nan);
  refused(Column("n", fixed(1)), Estimate{1, nan});
  refused(Column("n", fixed(1)), Estimate{1, -1});
  refused(Column("n", fixed(1)), Estimate{infinity, 1});
  refused(Column("n", uncertain()).exact(), 1.5);
  refused(Column("n", percent(1).rounded_up()), Estimate{-0.5, 0.1});
  BOOST_CHECK_THROW(Column("n", significant(2).rounded_up()), invalid_argument);
  BOOST_CHECK_THROW(Column("n", percent(1), "in"), invalid_argument);
  BOOST_CHECK_THROW(Column("share", fixed(1), "#"), invalid_argument);
}

BOOST_AUTO_TEST_CASE(what_a_column_cannot_be_is_told_with_the_line_that_asked_for_it) {
  const std::string place = std::source_location::current().file_name();
  const auto line = __LINE__ + 1;
  const auto scaled = [] { Column("n", significant(2)).scaled(3); };
  const auto with_unit = [] { Column("n", percent(1), "in"); };

  BOOST_TEST(message_of<invalid_argument>(scaled) ==
             fmt::format("{}:{}: column 'n': only fixed() numbers are scaled: fixed(3) has three "
                         "digits behind the point of the scaled number",
                         place, line));
  BOOST_TEST(message_of<invalid_argument>(with_unit) ==
             fmt::format("{}:{}: column 'n': it is in per cent and has no other unit, such as 'in'",
                         place, line + 1));
}

BOOST_AUTO_TEST_CASE(a_quoted_number_keeps_its_digits_in_a_column_of_others) {
  Table table("t", {Column("$u$", fixed(6), "in").scaled(-6)});
  table.add_row({Cell::quoted(1.594637e-6, -12)}).add_row({Cell::quoted(9.728517e-7, -13)});

  const std::string latex = table.latex();
  BOOST_TEST(holds(latex, "$1.594\\,637\\hphantom{0}\\,$"));
  BOOST_TEST(holds(latex, "$0.972\\,851\\,7$"));
  BOOST_CHECK_THROW(Cell::quoted(1.5946371e-6, -12), invalid_argument);
}

BOOST_AUTO_TEST_CASE(percentages_and_uncertainties_stand_in_columns) {
  Table table("t", {Column("share", percent(1)).exact(), Column("period", uncertain(), "s")});
  table.add_row({0.125, Estimate{0.786151378, 1.11e-7}}).add_row({1.0, Estimate{2.5, 0}});

  const std::string latex = table.latex();
  BOOST_TEST(holds(latex, "(\\unit{\\percent}) & (\\unit{s})"));
  BOOST_TEST(holds(latex, "$\\hphantom{0}12.5$"));
  BOOST_TEST(holds(latex, "$0.786\\,151\\,38\\pm 0.000\\,000\\,12$"));
  BOOST_TEST(holds(latex, "$2.5\\hphantom{0000000}\\,\\,\\hphantom{\\pm 0.000\\,000\\,12}$"));
}

BOOST_AUTO_TEST_CASE(bounds_to_either_side_stand_above_and_below_in_a_column) {
  Table table("t", {Column("load", uncertain(), "psi")});
  table.add_row({Cell(994, literate::Uncertainty::to_sides(18, 21))});

  BOOST_TEST(holds(table.latex(), "$994^{+21}_{-18}$"));
  BOOST_TEST(holds(table.html(), ">994 +21 −18</td>"));
}

BOOST_AUTO_TEST_CASE(a_heading_spans_the_columns_that_share_it) {
  Table table(
      "t", {Column::text("error of"), Column("$r$", fixed(1)).under("triangles"),
            Column("$C$", fixed(1)).under("triangles"), Column("$r$", fixed(1)).under("uniform")});
  table.add_row({"peak", 1, 2, 3});

  BOOST_TEST(holds(table.latex(),
                   "  \\toprule\n"
                   "   & \\multicolumn{2}{c}{triangles} & \\multicolumn{1}{c}{uniform} \\\\\n"
                   "  \\cmidrule(lr){2-3} \\cmidrule(lr){4-4}\n"
                   "  error of & $r$ & $C$ & $r$ \\\\\n"));
  BOOST_TEST(table.csv() ==
             "error of,triangles: r,triangles: C,uniform: r\n"
             "peak,1,2,3\n");
}

BOOST_AUTO_TEST_CASE(notes_stand_below_and_explain_the_marks_of_cells) {
  Table table("t", {Column("$x$", fixed(1)).exact()});
  table.add_row({Cell(1.5).marked("a")});
  BOOST_CHECK_THROW(table.require_complete(), invalid_argument);

  table.note("a", "by\nhand").note("All in SI.");
  table.require_complete();

  BOOST_TEST(holds(table.latex(), "\\LiterateNoted{%\n\\begin{tabular}{c}"));
  BOOST_TEST(holds(table.latex(), "$1.5\\LiterateMark{a}$ \\\\"));
  BOOST_TEST(
      holds(table.latex(), "  \\LiterateNote{a}{by\nhand}\n  \\LiterateNote{}{All in SI.}\n}"));
  BOOST_TEST(table.csv() == "x\n1.5\n# row 1, column 1: a\n# a: by hand\n# All in SI.\n");
  BOOST_TEST(message_of<invalid_argument>([&] {
               Table("u", {Column::text("x")}).note("b", "?").require_complete();
             }).ends_with("table 'u': no cell has the mark 'b' of a note"));
}

BOOST_AUTO_TEST_CASE(a_table_that_breaks_over_pages_repeats_its_heading) {
  Table table("t", {Column("$n$", integer()), Column::text("of")});
  table.add_row({1, "one"}).note("Counted.").break_over_pages();

  BOOST_TEST(table.latex() ==
             "\\begin{longtable}{cl}\n"
             "  \\LiterateLongCaption\n"
             "  \\toprule\n  $n$ & of \\\\\n  \\midrule\n"
             "  \\endfirsthead\n"
             "  \\toprule\n  $n$ & of \\\\\n  \\midrule\n"
             "  \\endhead\n"
             "  \\midrule\n  \\multicolumn{2}{r}{\\LiterateContinued} \\\\\n  \\endfoot\n"
             "  \\bottomrule\n  \\endlastfoot\n"
             "  $1$ & one \\\\\n"
             "\\end{longtable}\n"
             "\\begin{LiterateNotes}\n  \\LiterateNote{}{Counted.}\n\\end{LiterateNotes}\n");
}

BOOST_AUTO_TEST_CASE(csv_has_the_errors_beside_their_numbers) {
  Table table("t", {Column("$x$", exact(), "in"), Column("$u$", fixed(2), "in").scaled(-6),
                    Column("share", percent(1))});
  table.add_row({0.5, Estimate{1.5e-6, 2e-9}, Estimate{0.25, 0}}).add_row({1.5, {}, {}});

  BOOST_TEST(table.csv() ==
             "x (in),u (in),abs_error,share\n"
             "0.5,1.5e-06,2e-09,0.25\n"
             "1.5,,,\n");
}

BOOST_AUTO_TEST_CASE(csv_has_bounds_to_either_side_where_one_number_has_them) {
  Table table("t", {Column("$x$", literate::uncertain())});
  table.add_row({Cell(1.5, literate::Uncertainty::to_sides(0.2, 0.3))})
      .add_row({Estimate{2.5, 0.1}});

  BOOST_TEST(table.csv() == "x,below,above\n1.5,0.2,0.3\n2.5,0.1,0.1\n");
}

BOOST_AUTO_TEST_CASE(a_whole_number_that_no_double_holds_is_told_with_its_table_row_and_column) {
  const std::string message = message_of<invalid_argument>(
      [] { Table("seeds", {Column("seed", integer())}).add_row({11400714819323198485ULL}); });
  BOOST_TEST(holds(message, "table 'seeds' (begun at "));
  BOOST_TEST(holds(message, "row 1, column 1 'seed': 11400714819323198485 is beyond 2^53"));
  BOOST_TEST(message.ends_with("Cell(\"11400714819323198485\") prints it"), message);
  BOOST_CHECK_THROW(
      Table("t", {Column("$n$", integer())}).add_row({std::numeric_limits<std::int64_t>::min()}),
      invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_table_of_the_page_has_every_cell_in_its_place) {
  Table table("prices",
              {Column::text("fruit"), Column("price", fixed(2), "{kr}").exact().under("2026"),
               Column("weight", integer(), "g").under("2026")});
  table.add_row({"apple < pear", 1.5, 160}).add_row({"plum", Cell(2.75).marked("a"), 40});
  table.note("a", "of this year");

  const std::string html = table.html();

  const auto begin = html.find("<thead>"), end = html.find("</table>");
  BOOST_TEST(html.substr(begin, end - begin) ==
             "<thead>\n"
             "<tr><td></td><th colspan=\"2\" scope=\"colgroup\"><tex>2026</tex></th></tr>\n"
             "<tr><th scope=\"col\"><tex>fruit</tex></th>"
             "<th scope=\"col\" class=\"lit-flush\"><tex>price</tex></th>"
             "<th scope=\"col\" class=\"lit-flush\"><tex>weight</tex></th></tr>\n"
             "<tr><td><tex></tex></td><td class=\"lit-flush\"><tex>(\\unit{kr})</tex></td>"
             "<td class=\"lit-flush\"><tex>(\\unit{g})</tex></td></tr>\n"
             "</thead>\n<tbody>\n"
             "<tr><td><tex>apple \\textless{} pear</tex></td><td class=\"lit-numeric\">1.50</td>"
             "<td class=\"lit-numeric\">160</td></tr>\n"
             "<tr><td><tex>plum</tex></td><td class=\"lit-numeric\">2.75<sup "
             "class=\"lit-mark\">a</sup></td>"
             "<td class=\"lit-numeric\">40</td></tr>\n"
             "</tbody>\n");
}

BOOST_AUTO_TEST_CASE(a_heading_that_several_columns_have_finds_none) {
  const Table table("t", {Column("a", integer()), Column("a", integer()), Column("b", integer())});
  BOOST_TEST(table.column("b") == 2U);
  BOOST_TEST(message_of<std::invalid_argument>([&] {
               table.column("a");
             }).ends_with(": table 't' has 2 columns 'a'"));
}

BOOST_AUTO_TEST_SUITE_END()
