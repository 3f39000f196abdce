// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include "csv_rows.hpp"
#include "literate/values/value.hpp"
#include "system/decimal.hpp"

namespace {

using literate::Format;
using literate::Number;
using literate::Value;

/// The number of a row with its errors, or as_is if they are unknown.
Value value_of(const CsvRow& row) {
  const double number = sys::parsed<double>(row[0]).value();
  const Format format = Format::parse(row[3]);
  if (row[1].empty() && row[2].empty()) {
    return Value(number, format, row[4]).as_is();
  }
  return {Number(number, sys::parsed<double>(row[1]).value_or(0),
                 sys::parsed<double>(row[2]).value_or(0)),
          format, row[4]};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(digits_test)

// digits.csv lists numbers, their errors and formats, and the printed digits. Most rows come from a
// report on contact mechanics; the others are the examples in literate/values/format.hpp.
BOOST_AUTO_TEST_CASE(formats_print_the_digits_of_the_table) {
  const auto rows = csv_rows(ENGINE_TESTS "/values/digits.csv");
  BOOST_TEST(rows.size() > 100);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    BOOST_TEST_CONTEXT("row " << i + 1) {
      const Value value = value_of(row);
      BOOST_CHECK_NO_THROW(value.require_valid());
      BOOST_TEST(value.printed() == row[5]);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
