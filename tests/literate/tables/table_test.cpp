// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/table.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(table_test)

using literate::Cell;
using literate::Column;
using literate::Table;

namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_table_format_holds_the_widest_number) {
  Table table(
      {Column::fixed("$a$", "", 2), Column::scientific("$e$", "in", 3), Column::integer("$n$")});
  table.add_row({-1.0, 1.5e-6, 12}).add_row({123.456, -2.386e-12, 1200});

  const std::string latex = table.latex();

  BOOST_TEST(has(latex, "{ccc}"));
  BOOST_TEST(has(latex,
                 "  \\LiterateCell{-3.2}{-1.00}{\\hphantom{00}-1.00} & "
                 "\\LiterateCell{-1.2e-2}{1.50e-6}{\\hphantom{-}1.50\\times10^{-6\\hphantom{0}}} & "
                 "\\LiterateCell{4}{12}{\\hphantom{00}12} \\\\\n"));
  BOOST_TEST(has(latex, "{-3.2}{123.46}{\\hphantom{-}123.46} & "));
  BOOST_TEST(has(latex,
                 "{-1.2e-2}{-2.39e-12}{-2.39\\times10^{-12}} & "
                 "\\LiterateCell{4}{1200}{1200} \\\\\n"));
}

BOOST_AUTO_TEST_CASE(a_scaled_column_moves_its_power_of_ten_to_the_unit_line) {
  Table table({Column::scaled("$v$", "in", -6, 3), Column::scaled("$E$", "psi", 6, 1),
               Column::scaled("$k$", "", 3, 0)});
  table.add_row({1.623605e-6, 29.96e6, 1500.5});

  const std::string latex = table.latex();

  BOOST_TEST(has(latex, "(\\qty{e-6}{in}) & (\\qty{e6}{psi}) & (\\num{e3})"));
  BOOST_TEST(
      has(latex, "{1.624} & \\LiterateCell{2.1}{30.0}{30.0} & \\LiterateCell{1}{2}{2} \\\\\n"));
}

BOOST_AUTO_TEST_CASE(a_common_exponent_is_that_of_the_largest_magnitude) {
  Table table({Column::common_exponent("$p$", "psi", 3)});
  table.add_row({12.0}).add_row({-9999.0}).add_row({0.0});

  const std::string latex = table.latex();

  BOOST_TEST(has(latex, "(\\qty{e4}{psi})"));
  const std::string zero = "  \\LiterateCell{-1.2}{0.00}{\\hphantom{-}0.00} \\\\\n";
  BOOST_TEST(has(latex, zero + "  \\LiterateCell{-1.2}{-1.00}{-1.00} \\\\\n" + zero));
}

BOOST_AUTO_TEST_CASE(without_units_there_is_no_unit_line) {
  Table table({Column::text("Case"), Column::fixed("$x$", "", 1)});
  table.add_row({"50 %", 1.0}).add_row({Cell::latex("$\\infty$"), {}}).add_row({"c", "none"});

  BOOST_TEST(table.latex() ==
             "\\begin{tabular}{lc}\n"
             "  \\toprule\n"
             "  Case & $x$ \\\\\n"
             "  \\midrule\n"
             "  50 \\% & \\LiterateCell{1.1}{1.0}{1.0} \\\\\n"
             "  $\\infty$ &  \\\\\n"
             "  c & none \\\\\n"
             "  \\bottomrule\n"
             "\\end{tabular}\n");
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_a_column_is_refused) {
  using std::invalid_argument;
  BOOST_CHECK_THROW(Table({}), invalid_argument);
  BOOST_CHECK_THROW(Table({Column::integer("n")}).add_row({1, 2}), invalid_argument);
  BOOST_CHECK_THROW(Table({Column::integer("n")}).add_row({1.5}).latex(), invalid_argument);
  BOOST_CHECK_THROW(Table({Column::text("n")}).add_row({1}).latex(), invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(Table({Column::fixed("n", "", 1)}).add_row({nan}).latex(), invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_quoted_number_keeps_its_digits_in_a_column_of_others) {
  Table table({Column::scaled("$u$", "in", -6, 6)});
  table.add_row({Cell::to_place(1.594637e-6, -12)}).add_row({Cell::to_place(9.728517e-7, -13)});

  const std::string latex = table.latex();
  BOOST_TEST(latex.find("{1.594\\,637\\hphantom{0}\\,}") != latex.npos);
  BOOST_TEST(latex.find("{0.972\\,851\\,7}") != latex.npos);
  BOOST_TEST(latex.find("\\LiterateCell{1.7}{1.594637}") != latex.npos);
}

BOOST_AUTO_TEST_CASE(a_unit_that_latex_would_misread_is_refused) {
  BOOST_CHECK_THROW(Column::fixed("share", "%", 1), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
