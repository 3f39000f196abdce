// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/criterion.hpp"

#include <boost/test/unit_test.hpp>
#include <optional>
#include <string>
#include <vector>

#include "csv_rows.hpp"
#include "messages.hpp"
#include "system/decimal.hpp"

using literate::Criterion;
using literate::exact;
using literate::fixed;
using literate::Format;
using literate::integer;
using literate::Limit;
using literate::LimitKind;
using literate::Number;
using literate::percent;
using literate::significant;
using literate::uncertain;
using literate::Value;
using literate::Verdict;
using numerics::Estimate;

namespace {

std::optional<double> number_in(const std::string& text) {
  return sys::parsed<double>(text);
}

/// A quantity from the fields of a row; without an error it is as_is.
Value quantity_of(const std::string& number, const std::string& bound, const std::string& standard,
                  const Format& format, const std::string& unit) {
  const double value = number_in(number).value();
  if (bound.empty() && standard.empty()) return Value(value, format, unit).as_is();
  return {Number(value, number_in(bound).value_or(0), number_in(standard).value_or(0)), format,
          unit};
}

Criterion criterion_of(const CsvRow& row) {
  const auto field = [&](std::size_t i) { return row.at(i); };
  const Format format = Format::parse(field(4));
  const Value quantity = quantity_of(field(1), field(2), field(3), format, field(5));
  Limit limit(number_in(field(9)).value(), LimitKind::choice, "the table");
  if (!field(10).empty()) limit = limit.counting(number_in(field(10)).value());
  if (field(0) == "at_most") return Criterion::at_most("x", quantity, limit);
  if (field(0) == "at_least") return Criterion::at_least("x", quantity, limit);
  const bool is_exact = number_in(field(7)) == 0 && field(8).empty();
  const Value stated =
      quantity_of(field(6), field(7), field(8), is_exact ? exact() : significant(5), field(5));
  return field(0) == "agrees" ? Criterion::agrees("x", quantity, stated, limit)
                              : Criterion::agrees_relatively("x", quantity, stated, limit);
}

/// One criterion for each verdict, with the limit 1.
Criterion with(double number, double bound = 1e-9) {
  return Criterion::at_most("x", Value(Estimate{number, bound}, fixed(1)),
                            {1, LimitKind::data, "one"});
}
const Criterion holding = with(0.5), failing = with(1.5), undecided = with(1, 0.2);

template <typename Make>
std::string refusal_of(Make&& make) {
  return message_of<literate::Error>(make);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(criterion_test)

BOOST_AUTO_TEST_CASE(criteria_decide_and_print_as_in_the_table) {
  const auto rows = csv_rows(ENGINE_TESTS "/claims/verdicts.csv");
  BOOST_TEST(rows.size() > 30);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    BOOST_TEST_CONTEXT("row " << i + 1) {
      const Criterion criterion = criterion_of(row);
      BOOST_TEST(name_of(criterion.verdict()) == row[11]);
      BOOST_TEST(criterion.found().plain == row[12]);
      BOOST_TEST(criterion.limit_phrase().plain == row[13]);
      BOOST_TEST(criterion.missing().empty() == (criterion.verdict() != Verdict::undecided));
    }
  }
}

BOOST_AUTO_TEST_CASE(several_cases_hold_hold_in_part_or_fail) {
  const auto in_each = [](const std::vector<Criterion>& each) {
    return Criterion::in_each("largest", "points", each).text();
  };
  BOOST_TEST(in_each({holding, holding}) == "largest: 2 of 2 points; worst: 0.5 (≤ 1): holds");
  BOOST_TEST(in_each({holding, failing}) ==
             "largest: 1 of 2 points; worst: 1.5 (≤ 1): holds in part");
  BOOST_TEST(in_each({with(2.5), failing}) == "largest: 0 of 2 points; nearest: 1.5 (≤ 1): fails");
  BOOST_TEST(in_each({holding, failing, undecided}) ==
             "largest: 1 of 3 points; worst: 1.5 (≤ 1): holds in part");
  BOOST_TEST(in_each({holding, undecided}) ==
             "largest: 1 of 2 points; worst: 1.00 ± 0.20 (≤ 1): undecided, 1 of 2 points is "
             "undecided");
}

BOOST_AUTO_TEST_CASE(the_verdict_of_a_claim_follows_from_its_criteria) {
  BOOST_TEST((literate::verdict_of({holding, holding}) == Verdict::holds));
  BOOST_TEST((literate::verdict_of({holding, failing}) == Verdict::holds_in_part));
  BOOST_TEST((literate::verdict_of({failing, failing}) == Verdict::fails));
  BOOST_TEST((literate::verdict_of({holding, failing, undecided}) == Verdict::undecided));
  for (const char* name : {"holds", "holds in part", "fails", "undecided"}) {
    BOOST_TEST(name_of(literate::verdict_named(name)) == name);
  }
  BOOST_CHECK_THROW(literate::verdict_named("confirmed"), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_margin_is_the_distance_to_a_different_verdict) {
  BOOST_TEST(with(0.25, 0.05).margin().text() == "4.0 times; 15 errors");
  BOOST_TEST(with(3, 1e-9).margin().text() == "3.0 times; over 1000 errors");
  const Limit zero(0, LimitKind::data, "none");
  BOOST_TEST(Criterion::at_most("x", Value(0, integer()), zero).margin().text() == "exact");
}

BOOST_AUTO_TEST_CASE(the_tested_limit_is_the_printed_one) {
  const auto limit = [](double number) { return Limit(number, LimitKind::theory, "x").number(); };
  BOOST_TEST(limit(3 * 0.001) == 0.003);
  BOOST_TEST(limit(123456) == 123456);
  BOOST_TEST(limit(1.0 / 3) == 0.333);
}

BOOST_AUTO_TEST_CASE(invalid_criteria_are_refused_with_the_line_of_code) {
  const Limit limit(1, LimitKind::data, "one");
  const Value number(Estimate{1.5, 0.1}, fixed(1), "m");
  const Value scattered({1.5, 0, 0.1}, uncertain(), "m");
  const auto at_most = [](const Value& value, const Limit& given) {
    return refusal_of([&] { Criterion::at_most("x", value, given); });
  };
  BOOST_TEST(holds(at_most(Value(1.5, fixed(1)), limit), "criterion_test.cpp:"));
  BOOST_TEST(holds(at_most(Value(1.5, fixed(1)), limit), ": criterion 'x': 1.5 has no error"));
  BOOST_TEST(holds(at_most(Value::text("x"), limit), "it tests a number, not a text"));
  BOOST_TEST(holds(at_most(Value(std::nan(""), exact()), limit), "nan is not finite"));
  BOOST_TEST(holds(at_most(scattered, limit),
                   "1.50(10) m has a standard uncertainty of 0.1: the limit must state how many"));
  BOOST_TEST(holds(at_most(number, {1, LimitKind::data, ""}), "a limit needs a reason"));
  BOOST_TEST(holds(at_most(number, {std::nan(""), LimitKind::data, "x"}), "is not finite"));
  BOOST_TEST(holds(at_most(number, limit.counting(0)), "counting(0)"));
  BOOST_TEST(holds(refusal_of([&] { Criterion::at_most("", number, limit); }),
                   "a criterion names what it tests"));
  const auto agrees = [&](const Value& stated, const Limit& given) {
    return refusal_of([&] { Criterion::agrees("x", number, stated, given); });
  };
  BOOST_TEST(holds(agrees(Value(1, exact(), "in"), limit),
                   "1.5 m has m and 1 in has in: give both in the same unit"));
  BOOST_TEST(holds(
      refusal_of([&] {
        Criterion::agrees_relatively("x", number, Value(Estimate{0.1, 0.2}, fixed(1), "m"), limit);
      }),
      "may be zero, so nothing is relative to it"));
  BOOST_TEST(holds(refusal_of([] { Criterion::in_each("x", "points", {}); }), "no case to try"));
  const Criterion other =
      Criterion::at_most("x", Value(2, integer()), {3, LimitKind::data, "three"});
  BOOST_TEST(holds(refusal_of([&] {
                     Criterion::in_each("x", "points", {holding, other});
                   }),
                   "the cases have different limits, ≤ 1 (one) and ≤ 3 (three)"));
}

BOOST_AUTO_TEST_SUITE_END()
