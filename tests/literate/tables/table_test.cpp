// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/table.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "messages.hpp"

using literate::Cell;
using literate::Column;
using literate::exact;
using literate::fixed;
using literate::integer;
using literate::Number;
using literate::percent;
using literate::scientific;
using literate::significant;
using literate::Table;
using literate::uncertain;
using numerics::Estimate;

namespace {

/// The printed cells of one column, and the unit in its head.
std::vector<std::string> printed(const Column& column, const std::vector<Cell>& cells) {
  Table table("t", {column});
  for (const Cell& cell : cells) table.add_row({cell});
  std::vector<std::string> texts;
  for (const auto& row : table.printed()) texts.push_back(row.front());
  return texts;
}

std::string latex(const Column& column, const std::vector<Cell>& cells) {
  Table table("t", {column});
  for (const Cell& cell : cells) table.add_row({cell});
  return table.latex();
}

using Texts = std::vector<std::string>;

}  // namespace

BOOST_AUTO_TEST_SUITE(table_test)

BOOST_AUTO_TEST_CASE(columns_print_only_earned_digits) {
  BOOST_TEST(printed(Column("V", fixed(1), "V"), {Number(79.4, 0, 0.3), Number(79.4, 0.3)}) ==
             Texts({"79.4", "79"}));
  BOOST_TEST(printed(Column("x", uncertain()), {Number(994, 0, 22), Estimate{15.9911, 4e-4}}) ==
             Texts({"994(22)", "15.99110 ± 0.00040"}));
  BOOST_TEST(printed(Column("x", percent(1)), {Estimate{0.1251, 1e-6}, Estimate{0.13, 0.02}}) ==
             Texts({"12.5 %", "1e1 %"}));
  BOOST_TEST(printed(Column("n", integer()), {5, 31220}) == Texts({"5", "31220"}));
}

BOOST_AUTO_TEST_CASE(the_largest_number_of_a_column_has_its_significant_digits) {
  const std::vector<Cell> small{Estimate{1.623605e-6, 1e-15}, Estimate{9.820083e-7, 1e-15}};
  BOOST_TEST(printed(Column("u", significant(4), "in"), small) == Texts({"1.624e-6", "0.982e-6"}));
  BOOST_TEST(holds(latex(Column("u", significant(4), "in"), small), "($10^{-6}\\,\\mathrm{in}$)"));
  const std::vector<Cell> plain{Estimate{45.3123, 1e-9}, Estimate{7.1, 1e-9}};
  BOOST_TEST(printed(Column("u", significant(3)), plain) == Texts({"45.3", "7.1"}));
  BOOST_TEST(printed(Column("u", significant(2)), {Estimate{1250, 1}}) == Texts({"1.2e3"}));
}

BOOST_AUTO_TEST_CASE(a_scaled_column_states_its_power_of_ten) {
  const Column column = Column("FEA", fixed(2), "in").scaled(-6);
  BOOST_TEST(printed(column, {Estimate{1.594637e-6, 1e-12}}) == Texts({"1.59e-6"}));
  BOOST_TEST(holds(latex(column, {Estimate{1.594637e-6, 1e-12}}), "{}$1.59$"));
}

BOOST_AUTO_TEST_CASE(exact_columns_print_all_digits_of_their_parameters) {
  BOOST_TEST(printed(Column("x", fixed(2)).exact(), {0.25, 3 * 0.1, 0.005}) ==
             Texts({"0.25", "0.30", "0.005"}));
  BOOST_TEST(printed(Column("x", exact()), {0.25, 1e-7}) == Texts({"0.25", "1e-7"}));
  BOOST_TEST(printed(Column("x", scientific(2)).exact(), {0.125, 0.1}) ==
             Texts({"1.25e-1", "1.0e-1"}));
}

BOOST_AUTO_TEST_CASE(quoted_numbers_keep_the_digits_of_their_source) {
  BOOST_TEST(printed(Column("x", fixed(1)), {Cell::quoted(992.8, -1), Cell::quoted(0.300, -3)}) ==
             Texts({"992.8", "0.300"}));
  const std::string message = message_of<literate::Error>(
      [] { printed(Column("x", fixed(1)), {Cell::quoted(992.85, -1)}); });
  BOOST_TEST(holds(message, "992.85 has more digits than one quoted to the place 1e-1"));
}

BOOST_AUTO_TEST_CASE(decimal_points_are_aligned) {
  const std::string text =
      latex(Column("x", fixed(2)), {Estimate{-7.125, 1e-9}, Estimate{1234.5, 0.1}, Cell()});
  BOOST_TEST(holds(text, "{}$\\hphantom{000}{-}7.12$ \\\\"));
  BOOST_TEST(holds(text, "{}$\\hphantom{-}1234.5\\hphantom{0}$ \\\\"));
  const std::string errors =
      latex(Column("x", uncertain()), {Number(994, 0, 22), Number(1599.2, 0, 0.78), 7});
  BOOST_TEST(holds(errors, "{}$\\hphantom{0}994(22)\\hphantom{.}\\hphantom{00}$"));
  BOOST_TEST(holds(errors, "{}$1599.20(78)$"));
  BOOST_TEST(holds(errors, "{}$\\hphantom{000}7\\hphantom{.}\\hphantom{00}\\hphantom{(22)}$"));
}

BOOST_AUTO_TEST_CASE(no_text_is_read_as_the_argument_of_a_command) {
  Table table("t", {Column::text("share in %"), Column("length", fixed(2), "mm")});
  table.add_row({"[9mm] wide", Estimate{3.25, 1e-9}});
  table.add_row({"* --x", Cell::latex("\\textendash{}")});
  table.note("50 % of it");
  const std::string text = table.latex();
  BOOST_TEST(holds(text, "  {}share in \\% & length \\\\\n  {} & ($\\mathrm{mm}$) \\\\\n"));
  BOOST_TEST(holds(text, "  \\midrule\n  {}[9mm] wide & $3.25$ \\\\\n"));
  BOOST_TEST(holds(text, "  {}* -{}-x & \\textendash{} \\\\\n"));
  BOOST_TEST(holds(text, "\\LiterateNote{50 \\% of it}%\n"));
}

BOOST_AUTO_TEST_CASE(csv_has_the_unrounded_numbers_and_their_errors) {
  Table table("t", {Column("$u$", fixed(2), "mm").under("a, b"), Column::text("method")});
  table.add_row({Number(0.1, 0.02, 0.3), "by \"hand\""});
  table.add_row({Cell(), Cell::latex("$x$")});
  table.note("one\nline");
  BOOST_TEST(table.csv() ==
             "\"a, b: $u$ (mm)\",bound,standard,method\n0.1,0.02,0.3,\"by \"\"hand\"\"\"\n"
             ",,,$x$\n# one line\n");
}

BOOST_AUTO_TEST_CASE(unprintable_cells_are_refused_with_the_line_of_code) {
  Table table("t", {Column("u", fixed(2)), Column::text("method")});
  const auto refused = [&](const std::vector<Cell>& cells) {
    return message_of<literate::Error>([&] { table.add_row(cells); });
  };
  BOOST_TEST(holds(refused({1}), "table_test.cpp:"));
  BOOST_TEST(holds(refused({1}), ": table 't', row 1: 1 cells for 2 columns"));
  BOOST_TEST(holds(refused({0.5, "x"}), "column 1 'u': 0.5 has no error"));
  BOOST_TEST(holds(refused({Estimate{HUGE_VAL, 1}, "x"}), "column 1 'u': inf is not finite"));
  BOOST_TEST(holds(refused({Number(1, -1), "x"}), "the bound -1 is not finite or below zero"));
  BOOST_TEST(holds(refused({1, 2}), "column 2 'method': 2 is a number in a column of texts"));
  BOOST_TEST(holds(refused({1, Cell::latex("{")}), "the braces of '{' do not match"));
  BOOST_TEST(holds(refused({1, "\xff"}), "is not UTF-8"));
  const auto column = [](auto&& make) { return message_of<literate::Error>(make); };
  BOOST_TEST(
      holds(column([] { Column("u", fixed(1), "{ }"); }), "column 'u': '{ }' is not a unit"));
  BOOST_TEST(holds(column([] { Column("u", percent(1), "m"); }), "a percentage has no other unit"));
  BOOST_TEST(holds(column([] { Column("u", exact()).scaled(2); }), "only fixed() numbers"));
  BOOST_TEST(holds(column([] { Table("t", {}); }), "table 't' has no column"));
}

BOOST_AUTO_TEST_SUITE_END()
