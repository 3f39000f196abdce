// SPDX-License-Identifier: GPL-3.0-or-later
// The report's numbers against their own error bounds: the same computed in other ways must be
// within them.
#include <boost/test/unit_test.hpp>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "literate/document/document.hpp"
#include "literate/values/decimal.hpp"
#include "paper/paper.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(value_bounds_test)

using literate::Document;
using literate::Value;

namespace {

const std::string source_dir = HALFSPACE_SOURCE_DIR;
const std::string papers_text = sys::read_file(source_dir + "/report/ruggiero2001.toml");
const std::string steel_text = sys::read_file(source_dir + "/tests/end_to_end/steel_mm.toml");

Document computed(const std::string& case_text) {
  const TemporaryFolder folder;
  Document document;
  paper::compute(document, parameters::read_case(folder.write("case.toml", case_text)));
  return document;
}

parameters::ContactCase contact_of(const std::string& case_text) {
  const TemporaryFolder folder;
  return parameters::read_case(folder.write("case.toml", case_text)).contact;
}

const Document& papers() {
  static const Document document = computed(papers_text);
  return document;
}

const Document& steel() {
  static const Document document = computed(steel_text);
  return document;
}

std::string with(std::string text, const std::string& before, const std::string& after) {
  const auto at = text.find(before);
  BOOST_TEST_REQUIRE(at != std::string::npos);
  return text.replace(at, before.size(), after);
}

// Both numbers with bounds, and how far they may be apart.
void check_within(const Document& one, const Document& other,
                  const std::map<std::string, double>& factors, bool errors_of_both) {
  int n_compared = 0;
  for (const auto& [key, value] : one.values()) {
    if (!value.uncertainty() || !other.values().contains(key)) continue;
    const Value& again = other.values().at(key);
    BOOST_TEST_REQUIRE(again.uncertainty().has_value(), key);
    const double factor = factors.at(value.unit());
    const double apart = std::abs(*value.number() - factor * *again.number());
    const double allowed =
        value.uncertainty()->bound + (errors_of_both ? factor * again.uncertainty()->bound : 0);
    BOOST_TEST(apart <= allowed, key << ": " << *value.number() << " and "
                                     << factor * *again.number() << ", apart " << apart
                                     << ", allowed " << allowed);
    ++n_compared;
  }
  BOOST_TEST(n_compared > 50);
}

// The same of the numbers in tables. Those of columns with a unit are compared in that unit.
void check_cells_within(const Document& one, const Document& other,
                        const std::map<std::string, double>& factors, bool errors_of_both) {
  int n_compared = 0;
  for (const auto& [name, table] : one.tables()) {
    const literate::Table& again = other.tables().at(name);
    BOOST_TEST_REQUIRE(again.rows().size() == table.rows().size(), name);
    for (std::size_t r = 0; r < table.rows().size(); ++r) {
      for (std::size_t i = 0; i < table.columns().size(); ++i) {
        const literate::Cell& cell = table.rows()[r][i];
        const literate::Cell& cell_again = again.rows()[r][i];
        if (cell.error() == 0 || cell_again.number() == nullptr) continue;
        const literate::ColumnFormat& column = table.columns()[i].format();
        // The unit may stand in a column beside it, as in the table of the cylinders.
        const literate::Cell& beside = table.rows()[r][std::min<std::size_t>(1, i)];
        std::string unit = column.unit;
        if (unit.empty() && beside.text() != nullptr && factors.contains(*beside.text()) &&
            column.heading != "relative difference") {
          unit = *beside.text();
        }
        const double factor = factors.at(unit);
        const double apart = std::abs(*cell.number() - factor * *cell_again.number());
        const double of_other = factor * cell_again.error();
        const double allowed = cell.error() + (errors_of_both ? of_other : 0);
        BOOST_TEST(apart <= allowed, name << ", row " << r + 1 << ", " << column.heading << ": "
                                          << *cell.number() << " and "
                                          << factor * *cell_again.number() << ", apart " << apart
                                          << ", allowed " << allowed);
        ++n_compared;
      }
    }
  }
  BOOST_TEST(n_compared > 100);
}

const std::map<std::string, double> same_units = {{"", 1},       {"in", 1},          {"psi", 1},
                                                  {"lbf/in", 1}, {"mm", 1},          {"MPa", 1},
                                                  {"N/mm", 1},   {"lbf.s^2/in^4", 1}};

}  // namespace

BOOST_AUTO_TEST_CASE(every_number_has_a_bound_but_for_those_that_can_have_none) {
  // Differences that are rounding, or those of one mesh from another, which are themselves what is
  // told; bounds that a method reports; numbers that the paper prints; a correlation of
  // uncertainties.
  const std::set<std::string> as_is = {"block.displacement-error",
                                       "contact-m.rounding",
                                       "contest.most-chi-squared",
                                       "cylinders.residual.contact",
                                       "cylinders.residual.load",
                                       "cylinders.residual.separation",
                                       "fit.correlation",
                                       "fit.least-convergence",
                                       "fit.most-convergence",
                                       "methods.approach",
                                       "methods.pressure",
                                       "octave.difference",
                                       "spheres.residual"};
  for (const Document* document : {&papers(), &steel()}) {
    for (const auto& [key, value] : document->values()) {
      if (value.is_as_is()) BOOST_TEST(as_is.contains(key), key);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_number_that_stands_elsewhere_too_is_not_rounded_up) {
  const auto is_same = [](double one, double other) {
    return std::abs(std::abs(one) - std::abs(other)) <= 1e-6 * std::abs(one);
  };
  int n_rounded_up = 0;
  for (const auto& [key, value] : papers().values()) {
    if (!value.format() || !value.format()->rounds_up()) continue;
    ++n_rounded_up;
    const double number = *value.number();
    const double nearest = number_of(literate::rounded_to_place(number, value.last_place()));
    double shown = 0;
    std::from_chars(value.printed().data(), value.printed().data() + value.printed().size(), shown);
    if (value.is_percentage()) shown /= 100;
    if (number == 0 || is_same(shown, nearest)) continue;
    for (const auto& [other_key, other] : papers().values()) {
      if (other_key == key || !other.number() || *other.number() == 0) continue;
      BOOST_TEST(!is_same(*other.number(), number), key << " is " << other_key);
    }
    for (const auto& [name, table] : papers().tables()) {
      for (const auto& row : table.rows()) {
        for (const literate::Cell& cell : row) {
          if (cell.number() == nullptr || *cell.number() == 0) continue;
          const bool is_in_table =
              is_same(*cell.number(), number) || is_same(*cell.number(), 100 * number);
          BOOST_TEST(!is_in_table, key << " stands in table " << name);
        }
      }
    }
  }
  BOOST_TEST(n_rounded_up > 5);
}

BOOST_AUTO_TEST_CASE(every_cell_is_exact_quoted_or_has_a_bound) {
  const std::set<std::string> given = {"displacements: $x$",
                                       "friction-pairs: $\\nu_1$",
                                       "budget: $x$",
                                       "figure5: $x$",
                                       "friction-pairs: $\\nu_2$"};
  for (const Document* document : {&papers(), &steel()}) {
    int n_with_bound = 0;
    for (const auto& [name, table] : document->tables()) {
      for (const auto& row : table.rows()) {
        for (std::size_t i = 0; i < row.size(); ++i) {
          const std::string column = name + ": " + table.columns()[i].format().heading;
          if (row[i].number() == nullptr || row[i].place()) continue;
          n_with_bound += row[i].error() > 0 ? 1 : 0;
          BOOST_TEST((row[i].uncertainty() || given.contains(column)), column);
        }
      }
    }
    BOOST_TEST(n_with_bound > 100);
  }
}

BOOST_AUTO_TEST_CASE(no_digit_is_printed_below_its_bound) {
  // The last printed place, from the mantissa's decimals and the exponent. Where the uncertainty is
  // printed too, the place is that of its own second digit.
  for (const auto& [key, value] : papers().values()) {
    const std::string& text = value.printed();
    const bool is_told = text.find('(') != std::string::npos || text.find("±") != std::string::npos;
    if (!value.uncertainty() || is_told) continue;
    const std::string digits = text.substr(0, text.find(' '));
    const std::size_t e = std::min(digits.find('e'), digits.size());
    const std::size_t point = std::min(digits.find('.'), e);
    double place = point < e ? -static_cast<double>(e - point - 1) : 0;
    if (e < digits.size()) place += std::stod(digits.substr(e + 1));
    if (text.ends_with("%")) place -= 2;
    BOOST_TEST(std::pow(10, place) >= value.uncertainty()->bound * (1 - 1e-12),
               key << ": " << text);
  }
}

BOOST_AUTO_TEST_CASE(other_units_which_round_otherwise_change_no_number_by_more_than_its_bound) {
  const Document in_metres = computed(with(steel_text, "\"mm-N\"", "\"m-N\""));

  const std::map<std::string, double> factors = {
      {"", 1}, {"mm", 1e3}, {"MPa", 1e-6}, {"N/mm", 1e-3}};
  check_within(steel(), in_metres, factors, true);
  check_cells_within(steel(), in_metres, factors, true);
}

BOOST_AUTO_TEST_CASE(another_datum_of_the_cylinders_changes_nothing_but_their_approach) {
  // Contact.m's coefficients hold the datum, which only cancels.
  const Document other =
      computed(with(papers_text, "datum = {value = 1, unit", "datum = {value = 3, unit"));
  const Document nearer =
      computed(with(papers_text, "datum = {value = 1, unit", "datum = {value = 0.1, unit"));
  for (const Document* document : {&other, &nearer}) {
    for (const auto& [key, value] : papers().values()) {
      if (!value.uncertainty() || key.ends_with("approach")) continue;
      BOOST_TEST(std::abs(*value.number() - *document->values().at(key).number()) <=
                     value.uncertainty()->bound,
                 key);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_finer_block_changes_no_number_by_more_than_its_bound) {
  const Document finer = computed(with(papers_text, "order = 7", "order = 9"));
  check_within(papers(), finer, same_units, false);
  check_cells_within(papers(), finer, same_units, false);
}

BOOST_AUTO_TEST_SUITE_END()
