// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <optional>
#include <string>

#include "literate/values/value.hpp"
#include "system/csv.hpp"
#include "system/decimal.hpp"
#include "system/files.hpp"

namespace {

using literate::Format;
using literate::Number;
using literate::Value;

/// The number of a row: with its bound and standard uncertainty, or as it is where nobody knows
/// them.
Value value_of(const sys::CsvRow& row) {
  const double number = sys::parsed<double>(row[0].text).value();
  const Format format = Format::parse(row[3].text);
  if (row[1].text.empty() && row[2].text.empty()) {
    return Value(number, format, row[4].text).as_is();
  }
  return {Number(number, sys::parsed<double>(row[1].text).value_or(0),
                 sys::parsed<double>(row[2].text).value_or(0)),
          format, row[4].text};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(digits_test)

// digits.csv: what numbers with their errors print in each format. Most rows are numbers of a
// report on contact mechanics; the others are the promises of literate/values/format.hpp.
BOOST_AUTO_TEST_CASE(formats_print_the_digits_of_the_table) {
  const std::string file = ENGINE_TESTS "/values/digits.csv";
  auto rows = sys::parse_csv(sys::read_file(file), file);
  rows.erase(rows.begin());
  BOOST_TEST(rows.size() > 100);
  for (const sys::CsvRow& row : rows) {
    BOOST_TEST_CONTEXT(row[0].place) {
      const Value value = value_of(row);
      BOOST_CHECK_NO_THROW(value.require_valid());
      BOOST_TEST(value.printed() == row[5].text);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
