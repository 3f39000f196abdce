// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/criterion.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

#include "holds.hpp"
#include "message_of.hpp"

BOOST_AUTO_TEST_SUITE(criterion_test)

using literate::Criterion;
using literate::exact;
using literate::fixed;
using literate::integer;
using literate::Limit;
using literate::LimitKind;
using literate::Outcome;
using literate::percent;
using literate::significant;
using literate::supported;
using literate::Value;

namespace {

Limit limit_of(double number, double abs_error = 0) {
  return {LimitKind::choice, numerics::Estimate{number, abs_error}, "(c/a)²(a/z)⁴"};
}

Criterion misfit_at_most(double found, double abs_error, Limit limit) {
  return Criterion::at_most("largest misfit", Value({found, abs_error}, percent(3)),
                            std::move(limit));
}

bool is(const Criterion& criterion, Outcome outcome) {
  return criterion.outcome() == outcome;
}

Value load(double number, double standard, const char* source) {
  return {numerics::Measured(number, standard, source), literate::uncertain(), "psi"};
}

Limit counting(double number, double k) {
  return Limit(LimitKind::data, number, "the paper's load").counting(k);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_whole_interval_on_the_allowed_side_holds_and_on_the_other_fails) {
  BOOST_TEST(is(misfit_at_most(0.00074, 1e-6, limit_of(0.001)), Outcome::holds));
  BOOST_TEST(is(misfit_at_most(0.00174, 1e-6, limit_of(0.001)), Outcome::fails));
  const auto at_least = [](double found) {
    return Criterion::at_least("share", Value({found, 1e-6}, percent(1)), limit_of(0.1));
  };
  BOOST_TEST(is(at_least(0.37), Outcome::holds));
  BOOST_TEST(is(at_least(0.037), Outcome::fails));
}

BOOST_AUTO_TEST_CASE(a_quantity_that_equals_its_limit_satisfies_it) {
  BOOST_TEST(is(misfit_at_most(0.001, 0, limit_of(0.001)), Outcome::holds));
  BOOST_TEST(
      is(Criterion::at_least("share", Value({0.1, 0}, percent(1)), limit_of(0.1)), Outcome::holds));
}

BOOST_AUTO_TEST_CASE(a_quantity_shows_the_error_that_leaves_its_verdict_open) {
  const auto at_least = [](double number, double abs_error) {
    return Criterion::at_least("load", Value({number, abs_error}, significant(3), "N"),
                               limit_of(65));
  };

  BOOST_TEST(at_least(67, 5).computed() == "load: (67.0 ± 5.0) N");
  BOOST_TEST(at_least(67, 5).condition().plain == "at least 65 N");
  BOOST_TEST(at_least(77, 5).computed() == "load: 8e1 N");
  BOOST_TEST(at_least(67, 80).computed() == "load: at least -13 N");
}

BOOST_AUTO_TEST_CASE(an_error_that_reaches_across_the_limit_leaves_the_verdict_open) {
  const Criterion of_quantity = misfit_at_most(0.0009, 0.0002, limit_of(0.001));
  BOOST_TEST(is(of_quantity, Outcome::undecided));
  BOOST_TEST(of_quantity.missing() == "an error of 0.02 % reaches across the limit");
  BOOST_TEST(is(misfit_at_most(0.0011, 0.0002, limit_of(0.001)), Outcome::undecided));
  BOOST_TEST(is(misfit_at_most(0.0009, 0, limit_of(0.001, 0.0002)), Outcome::undecided));
  BOOST_TEST(misfit_at_most(0.0009, 0, limit_of(0.001)).missing().empty());
}

BOOST_AUTO_TEST_CASE(the_limit_that_is_tested_is_the_one_that_is_printed) {
  // 0.0012345 is printed as 0.12 % when two digits are asked for.
  const Limit rounded(LimitKind::choice, 0.0012345, "a formula", 2);
  const Criterion criterion = misfit_at_most(0.0013, 0, rounded);
  BOOST_TEST(criterion.condition().plain == "at most 0.12 %");
  BOOST_TEST(is(criterion, Outcome::fails));
  BOOST_TEST(rounded.number() == 0.0012);
}

BOOST_AUTO_TEST_CASE(where_rounding_a_limit_would_decide_it_is_refused) {
  const auto refusal = [](double found, double error, const Limit& limit) {
    const std::string message = message_of<std::invalid_argument>([&] {
      Criterion::at_most("strain", Value({found, error}, fixed(5)), limit);
    });
    BOOST_TEST(message.starts_with("tests/literate/claims/criterion_test.cpp:"), message);
    return message.substr(message.find(": ") + 2);
  };
  const auto limit = [](double number, int n_digits) {
    return Limit(LimitKind::choice, number, "a formula", n_digits);
  };

  BOOST_TEST(refusal(0.59284, 0, limit(0.592746, 3)) ==
             "strain: rounding decides, since 0.59284 holds against the printed limit 0.593 and "
             "fails against 0.592746 itself: give the limit more than 3 digits");
  BOOST_TEST(holds(refusal(0.5928, 1e-4, limit(0.592746, 3)),
                   "holds against the printed limit 0.593 and is undecided against 0.592746"));
  BOOST_TEST(is(Criterion::at_most("strain", Value({0.59284, 0}, fixed(5)), limit(0.592746, 6)),
                Outcome::fails));
  // Either side of both limits, rounding decides nothing.
  BOOST_TEST(is(Criterion::at_most("strain", Value({0.5935, 0}, fixed(5)), limit(0.592746, 3)),
                Outcome::fails));
  BOOST_TEST(is(Criterion::at_least("strain", Value({0.5935, 0}, fixed(5)), limit(0.592746, 3)),
                Outcome::holds));
}

BOOST_AUTO_TEST_CASE(what_is_refused_is_told_with_its_line_and_name) {
  const std::string message =
      message_of<std::invalid_argument>([] { misfit_at_most(std::nan(""), 0, limit_of(1)); });

  BOOST_TEST(message.starts_with("tests/literate/claims/criterion_test.cpp:"));
  BOOST_TEST(message.ends_with(": largest misfit: nan is not finite"));
}

BOOST_AUTO_TEST_CASE(quantity_relation_limit_and_kind_are_printed) {
  const Criterion criterion = misfit_at_most(0.00074, 1e-6, limit_of(0.001));
  BOOST_TEST(criterion.computed() == "largest misfit: 0.074 %");
  BOOST_TEST(criterion.condition().plain == "at most 0.1 %");
  BOOST_TEST(criterion.limit().plain == "≤ 0.1 %");
  BOOST_TEST(criterion.reason() == "choice: (c/a)²(a/z)⁴");
  const Criterion with_unit =
      Criterion::at_least("load", Value({15.99, 0.001}, significant(4), "lbf/in"),
                          {LimitKind::choice, 10.0, "the load of eq. (4)"});
  BOOST_TEST(with_unit.condition().plain == "at least 10 lbf/in");
  BOOST_TEST(with_unit.limit().plain == "≥ 10 lbf/in");
  BOOST_TEST(with_unit.reason() == "choice: the load of eq. (4)");
}

BOOST_AUTO_TEST_CASE(exact_numbers_are_compared_as_the_decimal_numbers_that_they_are) {
  // As doubles 2.6 − 2.5, 110/100 − 1 and 33/30 − 1 are above 0.1, and 0.3 − 0.2 is below it.
  const Limit tenth{LimitKind::data, 0.1, "the tenth"};
  const auto held = [](const Criterion& criterion) {
    return criterion.outcome() == Outcome::holds;
  };
  for (const auto& [a, b] : {std::pair{2.6, 2.5}, {1.2, 1.1}, {0.3, 0.2}, {0.8, 0.7}}) {
    const Value one(a, exact(), "m"), other(b, exact(), "m");
    BOOST_TEST(held(Criterion::agrees("level", one, other, tenth)), a);
    BOOST_TEST(held(Criterion::differs("level", one, other, tenth)), a);
  }
  for (const auto& [a, b] : {std::pair{110.0, 100.0}, {33.0, 30.0}, {1.1, 1.0}, {0.9, 1.0}}) {
    BOOST_TEST(held(Criterion::agrees_relatively("n", Value(a, exact()), Value(b, exact()), tenth)),
               a);
  }
  const Limit less{LimitKind::data, 0.0999, "less than a tenth"};
  BOOST_TEST(
      !held(Criterion::agrees_relatively("n", Value(110, integer()), Value(100, integer()), less)));
}

BOOST_AUTO_TEST_CASE(agreement_is_the_difference_with_both_errors) {
  const auto agrees = [](double computed, double error_of_stated) {
    return Criterion::agrees("ratio", Value({computed, 1e-7}, fixed(6)),
                             Value({0.3, error_of_stated}, fixed(1)),
                             {LimitKind::data, 1e-6, "seven printed digits"});
  };
  BOOST_TEST(is(agrees(0.3000005, 0), Outcome::holds));
  BOOST_TEST(is(agrees(0.2999995, 0), Outcome::holds));
  BOOST_TEST(is(agrees(0.3000025, 0), Outcome::fails));
  BOOST_TEST(is(agrees(0.3000005, 5e-7), Outcome::undecided));
  BOOST_TEST(agrees(0.3000005, 0).condition().plain == "within 1e-6 of 0.3");
  BOOST_TEST(agrees(0.3000005, 0).limit().plain == "≤ 1e-6");
  // 0.300001 within 1e-6 of 0.3 would leave open whether it holds.
  BOOST_TEST(agrees(0.3000008, 0).computed() == "ratio: 0.3000008, 8e-7 from 0.3");
  BOOST_TEST(agrees(0.300000012, 0).computed() == "ratio: 0.300000, at most 1.2e-7 from 0.3");
}

BOOST_AUTO_TEST_CASE(relative_agreement_says_how_far_apart_the_two_are) {
  const auto agrees = [](double computed, double abs_error) {
    return Criterion::agrees_relatively(
        "resultant", Value({computed, abs_error}, significant(4), "lbf/in"),
        Value(16, exact(), "lbf/in"),
        {LimitKind::data, 0.002, "twice the misfit of the displacements"});
  };
  BOOST_TEST(is(agrees(15.99, 0.001), Outcome::holds));
  BOOST_TEST(is(agrees(15.9, 0.001), Outcome::fails));
  BOOST_TEST(is(agrees(15.99, 0.03), Outcome::undecided));
  BOOST_TEST(agrees(15.99, 0.001).computed() == "resultant: 15.99 lbf/in, 0.06 % from 16 lbf/in");
  // No digit is printed that the error does not support: 0.11 % apart with an error of 0.19 %.
  BOOST_TEST(agrees(15.982, 0.03).computed() ==
             "resultant: 16.0 lbf/in, at most 0.30 % from 16 lbf/in");
  BOOST_TEST(agrees(15.96, 0.03).computed() ==
             "resultant: 16.0 lbf/in, (0.25 ± 0.19) % from 16 lbf/in");
  BOOST_TEST(agrees(15.982, 0.03).missing() == "an error of 0.19 % reaches across the limit");
  BOOST_TEST(agrees(15.99, 0.001).condition().plain == "within 0.2 % of 16 lbf/in");
  BOOST_TEST(agrees(15.99, 0.001).limit().plain == "≤ 0.2 %");
  BOOST_CHECK_THROW(Criterion::agrees_relatively("x", Value({1, 0}, fixed(1)),
                                                 Value({0.01, 0.02}, fixed(2)), limit_of(0.1)),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_sentence_of_an_agreement_is_consistent_with_its_own_numbers) {
  const auto agrees = [](const Value& computed, double tolerance) {
    return Criterion::agrees("x", computed, Value(0.75, exact()),
                             {LimitKind::data, tolerance, "the statement"})
        .computed();
  };
  BOOST_TEST(agrees(Value({0.6, 0.04}, significant(2)), 0.05) ==
             "x: 0.600 ± 0.040, 0.150 ± 0.040 from 0.75");
  BOOST_TEST(agrees(Value(0.6432, fixed(1)).as_is(), 0.05) == "x: 0.64, 0.11 from 0.75");
  BOOST_TEST(agrees(Value({0.7, 0.1}, supported()), 0.2) ==
             "x: 0.70 ± 0.10, at most 0.15 from 0.75");
  // Within 0.08 it may be or not.
  BOOST_TEST(agrees(Value({0.66, 0.1}, supported()), 0.08) ==
             "x: 0.66 ± 0.10, at most 0.19 from 0.75");
}

BOOST_AUTO_TEST_CASE(cases_are_counted_and_one_that_is_undecided_keeps_all_of_them_open) {
  const auto in_each = [](const std::vector<double>& errors, double abs_error) {
    std::vector<Criterion> each;
    for (const double error : errors) each.push_back(misfit_at_most(error, abs_error, limit_of(1)));
    return Criterion::in_each("misfit", "points", each);
  };
  BOOST_TEST(is(in_each({0.1, 0.2, 0.3}, 0), Outcome::holds));
  BOOST_TEST(is(in_each({0.1, 2, 0.3}, 0), Outcome::holds_in_part));
  BOOST_TEST(is(in_each({3, 2, 4}, 0), Outcome::fails));
  BOOST_TEST(is(in_each({0.1, 0.99}, 0.02), Outcome::undecided));
  BOOST_TEST(is(in_each({2, 0.99}, 0.02), Outcome::undecided));
  BOOST_TEST(is(in_each({0.1, 2, 0.99}, 0.02), Outcome::holds_in_part));
  BOOST_TEST(in_each({0.1, 2, 0.3}, 0).computed() == "misfit: 2 of 3 points; worst: 200.000 %");
  // Where none holds, the nearest tells how far the limit is missed at least.
  BOOST_TEST(in_each({3, 2, 4}, 0).computed() == "misfit: 0 of 3 points; nearest: 200.000 %");
  BOOST_TEST(in_each({0.1, 2, 0.3}, 0).condition().plain == "at most 100 %");
  BOOST_TEST(in_each({0.1, 2, 0.3}, 0).limit().plain == "≤ 100 %");
}

BOOST_AUTO_TEST_CASE(a_difference_that_is_lost_in_its_error_is_told_by_what_it_is_at_most) {
  const auto step = [](double computed, double limit) {
    return Criterion::agrees_relatively("step", Value({computed, 1e-12}, significant(3), "in"),
                                        Value(2, exact(), "in"),
                                        {LimitKind::choice, limit, "theory"});
  };
  BOOST_TEST(step(2, 1e-9).computed() ==
             "step: 2.00 in against 2 in, relative difference at most 5.0e-13");
  BOOST_TEST(step(2, 1e-9).condition().plain == "within 1e-9 of 2 in");
  BOOST_TEST(step(2.2, 0.2).computed() == "step: 2.20 in, 10 % from 2 in");
}

BOOST_AUTO_TEST_CASE(a_tolerance_of_zero_asks_for_equality) {
  const auto node = [](int found) {
    return Criterion::agrees("node", Value(found, integer()), Value(9, integer()),
                             {LimitKind::data, 0.0, "it is a count"});
  };
  BOOST_TEST(is(node(9), Outcome::holds));
  BOOST_TEST(is(node(26), Outcome::fails));
  BOOST_TEST(node(9).condition().plain == "equal to 9");
  BOOST_TEST(node(9).limit().plain == "= 9");
  BOOST_TEST(node(26).computed() == "node: 26");
  const Criterion share =
      Criterion::agrees("share", Value(0.50001, fixed(2)).as_is(), Value(0.5, fixed(2)).as_is(),
                        {LimitKind::data, 0.0, "the same digits"});
  BOOST_TEST(is(share, Outcome::fails));
  BOOST_TEST(share.computed() == "share: 0.50001, 1.0e-5 from 0.50");
}

BOOST_AUTO_TEST_CASE(quantities_of_two_units_are_not_compared) {
  const auto refusal = [](const Value& computed, const Value& stated) {
    const Limit limit{LimitKind::choice, 0.1, "a tenth"};
    return message_of<std::invalid_argument>(
               [&] { Criterion::agrees("mass", computed, stated, limit); }) +
           message_of<std::invalid_argument>(
               [&] { Criterion::agrees_relatively("mass", computed, stated, limit); }) +
           message_of<std::invalid_argument>(
               [&] { Criterion::differs("mass", computed, stated, limit); });
  };
  const std::string none = "(no error)(no error)(no error)";
  const Value kg(5, exact(), "kg");

  const std::string said = refusal(kg, Value(5, exact(), "s"));
  BOOST_TEST(holds(said, ": mass: 5 kg has kg and 5 s has s: give both in one unit"));
  for (const Value& other : {Value(5, exact(), "g"), Value(5, exact()), Value(5, exact(), "%")}) {
    BOOST_TEST(lacks(refusal(kg, other), "(no error)"), other.printed());
  }
  BOOST_TEST(refusal(Value(0.5, exact().in_percent()), Value(50, exact(), "percent")) != none);
  BOOST_TEST(refusal(Value(2, exact(), "m2"), Value(2, exact(), "m^2")) == none);
  BOOST_TEST(refusal(Value(0.5, exact().in_percent()), Value(0.5, exact())) == none);
}

BOOST_AUTO_TEST_CASE(numbers_differ_if_what_is_not_known_of_them_leaves_them_apart) {
  const auto differ = [](double computed, double abs_error, double limit) {
    return Criterion::differs("load", Value({computed, abs_error}, significant(3), "N"),
                              Value(64, exact(), "N"), {LimitKind::data, limit, "the statement"});
  };
  BOOST_TEST(is(differ(67, 1, 0), Outcome::holds));
  BOOST_TEST(is(differ(67, 5, 0), Outcome::undecided));
  BOOST_TEST(is(differ(64, 0, 0), Outcome::fails));
  BOOST_TEST(is(differ(67, 0.5, 2), Outcome::holds));
  BOOST_TEST(is(differ(65, 0.5, 2), Outcome::fails));
  BOOST_TEST(is(differ(65.8, 0.5, 2), Outcome::undecided));
  BOOST_TEST(differ(64.5, 1, 0).found().plain == "64 N, at most 1.5 N from 64 N");
  BOOST_TEST(differ(67, 0.5, 2).found().plain == "67 N, 3 N from 64 N");
  BOOST_TEST(differ(65.996, 1e-4, 2).found().plain == "65.996 N, 1.996 N from 64 N");
  BOOST_TEST(differ(67, 0.5, 2).condition().plain == "at least 2 N from 64 N");
  BOOST_TEST(differ(67, 0.5, 2).limit().plain == "≥ 2 N");
  BOOST_TEST(differ(67, 1, 0).condition().plain == "another than 64 N");
  BOOST_TEST(differ(67, 1, 0).limit().latex == "$\\ne$~\\qty{64}{N}");
  BOOST_TEST(differ(67, 0.02, 2).computed() == "load: 67.0 N, 3.0 N from 64 N");
}

BOOST_AUTO_TEST_CASE(what_two_numbers_share_cancels_where_they_are_to_differ) {
  const auto apart = [](const char* source_of_second) {
    return Criterion::differs("load", load(100, 5, "balance"), load(103, 5, source_of_second),
                              counting(1, 2));
  };
  BOOST_TEST(is(apart("balance"), Outcome::holds));
  BOOST_TEST(is(apart("another"), Outcome::undecided));
}

BOOST_AUTO_TEST_CASE(a_margin_is_the_distance_from_the_limit_in_errors_and_as_a_factor) {
  const literate::Margin margin = misfit_at_most(0.002, 0.0005, limit_of(0.01, 0.0015)).margin();
  BOOST_TEST(*margin.errors == 4, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(*margin.factor == 5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(margin.text() == "5.0 times; 4.0 errors");

  BOOST_TEST(misfit_at_most(0.02, 0, limit_of(0.01)).margin().text() == "2.0 times");
  // 2 ± 1 is undecided against 3, and 2 ± 0.5 against 1.5, which they reach at half of 6 and
  // at 1.25 times 1.2. Undecided against 2.5 and 1.25, 2 ± 1 is decided from 3 and from 1 on; 2 ± 4
  // from 6.
  BOOST_TEST(*misfit_at_most(0.02, 0.01, limit_of(0.06)).margin().turning_factor == 2,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(*misfit_at_most(0.02, 0.005, limit_of(0.012)).margin().turning_factor == 1.25,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(*misfit_at_most(0.02, 0.01, limit_of(0.025)).margin().turning_factor == 1.2,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(*misfit_at_most(0.02, 0.01, limit_of(0.0125)).margin().turning_factor == 1.25,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(*misfit_at_most(0.02, 0.04, limit_of(0.05)).margin().turning_factor == 1.2,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(misfit_at_most(-0.02, 0.001, limit_of(0.01)).margin().text() == "30 errors");
  // Of 0.01, 0.02 and 0.09 against 0.03 two hold: the third holds too from 0.09 on, and all fail
  // below 0.01.
  const auto in_each = [&](double limit) {
    std::vector<Criterion> each;
    for (const double misfit : {0.01, 0.02, 0.09}) {
      each.push_back(misfit_at_most(misfit, 0, limit_of(limit)));
    }
    return *Criterion::in_each("misfit", "points", each).margin().turning_factor;
  };
  BOOST_TEST(in_each(0.03) == 3, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(in_each(0.018) == 1.8, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(in_each(0.18) == 2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(misfit_at_most(1e-9, 0, limit_of(0.01)).margin().text() == "over 1000 times");
  BOOST_TEST(Criterion::agrees("node", Value(9, integer()), Value(9, integer()),
                               {LimitKind::data, 0.0, "it is a count"})
                 .margin()
                 .text() == "exact");
}

BOOST_AUTO_TEST_CASE(an_outcome_is_open_exactly_where_its_margin_is_less_than_an_error) {
  for (const double found : {0.0085, 0.0091, 0.0099, 0.0105, 0.0115}) {
    const Criterion criterion = misfit_at_most(found, 0.001, limit_of(0.01));
    BOOST_TEST(is(criterion, Outcome::undecided) == (*criterion.margin().errors < 1), found);
  }
}

BOOST_AUTO_TEST_CASE(of_several_cases_the_one_that_is_printed_has_the_margin) {
  const Limit limit = limit_of(1);
  const Criterion all = Criterion::in_each(
      "misfit", "points", {misfit_at_most(0.25, 0.01, limit), misfit_at_most(0.5, 0.25, limit)});
  BOOST_TEST(all.margin().text() == "2.0 times; 2.0 errors");
  // The second, though the first has fewer errors.
  const Criterion other = Criterion::in_each(
      "misfit", "points", {misfit_at_most(0.25, 0.25, limit), misfit_at_most(0.5, 0.01, limit)});
  BOOST_TEST(other.margin().text() == "2.0 times; 50 errors");
  // In part: the one that fails by most, which is printed.
  const Criterion part = Criterion::in_each(
      "misfit", "points", {misfit_at_most(0.25, 0.01, limit), misfit_at_most(1.5, 0.01, limit)});
  BOOST_TEST(part.margin().text() == "1.5 times; 50 errors");
  const Criterion nearer = Criterion::in_each(
      "misfit", "points", {misfit_at_most(0.9, 0.01, limit), misfit_at_most(2.5, 0.01, limit)});
  BOOST_TEST(nearer.margin().text() == "2.5 times; 150 errors");
  BOOST_TEST(holds(nearer.computed(), "worst: 250"));
}

BOOST_AUTO_TEST_CASE(what_is_printed_as_latex_has_the_same_numbers) {
  const Criterion criterion = misfit_at_most(0.00074, 1e-6, limit_of(0.001));
  BOOST_TEST(criterion.found().latex == "\\qty{0.074}{\\percent}");
  BOOST_TEST(criterion.condition().latex == "at most \\qty{0.1}{\\percent}");
  BOOST_TEST(criterion.limit().latex == "$\\le$~\\qty{0.1}{\\percent}");
}

BOOST_AUTO_TEST_CASE(outcomes_have_names) {
  BOOST_TEST(name_of(Outcome::holds) == "holds");
  BOOST_TEST(name_of(Outcome::holds_in_part) == "holds in part");
  BOOST_TEST(name_of(Outcome::fails) == "fails");
  BOOST_TEST(name_of(Outcome::undecided) == "undecided");
}

BOOST_AUTO_TEST_CASE(what_cannot_decide_is_refused) {
  const Limit limit = limit_of(1);
  BOOST_CHECK_THROW(Criterion::at_most("x", Value::text("eleven"), limit), std::invalid_argument);
  BOOST_CHECK_THROW(Criterion::at_most("x", Value(0.5, fixed(1)), limit), std::invalid_argument);
  BOOST_CHECK_THROW(Criterion::at_most("", Value({0.5, 0}, fixed(1)), limit),
                    std::invalid_argument);
  BOOST_CHECK_THROW(Criterion::in_each("x", "points", {}), std::invalid_argument);
  BOOST_CHECK_THROW(
      Criterion::in_each("x", "points",
                         {misfit_at_most(1, 0, limit_of(1)), misfit_at_most(1, 0, limit_of(2))}),
      std::invalid_argument);
  BOOST_CHECK_THROW(Limit(LimitKind::choice, 1.0, ""), std::invalid_argument);
  BOOST_CHECK_THROW(Limit(LimitKind::choice, std::nan(""), "why"), std::invalid_argument);
  BOOST_CHECK_THROW(Limit(static_cast<LimitKind>(17), 1.0, "why"), std::invalid_argument);
  BOOST_CHECK_THROW(misfit_at_most(std::nan(""), 0, limit), std::invalid_argument);
  const Value one(1, exact());
  const Limit below(LimitKind::choice, -0.1, "no distance");
  for (const auto relation :
       {&Criterion::agrees, &Criterion::agrees_relatively, &Criterion::differs}) {
    const std::string message = message_of<std::invalid_argument>(
        [&] { relation("x", one, one, below, Criterion::Location::current()); });
    BOOST_TEST(message.ends_with("x: the limit of a difference is 0 or more, not -0.1"), message);
  }
  BOOST_CHECK_THROW(limit_of(1, -1e-3), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_limit_is_the_same_whatever_it_is_held_against) {
  const Limit limit(LimitKind::choice, 0.1, "a tenth");
  const auto value = [](double x) { return Value({x, 1e-3}, fixed(2), "N"); };
  for (const double other : {0.4, 0.402, 40.0}) {
    BOOST_TEST(Criterion::differs("n", value(9), value(other), limit).limit().plain == "≥ 0.1 N");
    BOOST_TEST(Criterion::agrees("n", value(9), value(other), limit).limit().plain == "≤ 0.1 N");
    BOOST_TEST(Criterion::agrees_relatively("n", value(9), value(other), limit).limit().plain ==
               "≤ 10 %");
  }
}

BOOST_AUTO_TEST_CASE(as_many_standard_uncertainties_count_as_the_limit_says) {
  const auto at_most = [](double limit, double k) {
    return Criterion::at_most("load", load(993.63, 21.9, "fit"), counting(limit, k));
  };
  BOOST_TEST(is(at_most(1020, 1), Outcome::holds));
  BOOST_TEST(is(at_most(1020, 2), Outcome::undecided));
  BOOST_TEST(is(at_most(1040, 2), Outcome::holds));
  BOOST_TEST(is(at_most(900, 3), Outcome::fails));
  BOOST_TEST(at_most(1020, 2).computed() == "load: 994(22) psi");
  BOOST_TEST(at_most(1020, 2).missing() == "an error of 44 psi reaches across the limit");
  BOOST_TEST(at_most(1020, 2).reason() ==
             "data: the paper's load; 2 standard uncertainties are allowed for");
}

BOOST_AUTO_TEST_CASE(a_bound_counts_beside_them) {
  const numerics::Measured both =
      numerics::Measured(10, 1, "scale") + numerics::Measured::bounded({0, 0.5});
  const auto at_most = [&](double limit) {
    return Criterion::at_most("load", Value(both, significant(2)), counting(limit, 2));
  };
  BOOST_TEST(is(at_most(12.6), Outcome::holds));
  BOOST_TEST(is(at_most(12.4), Outcome::undecided));
}

BOOST_AUTO_TEST_CASE(what_two_numbers_are_uncertain_by_from_one_source_cancels_in_their_agreement) {
  const auto apart = [](const char* source_of_second) {
    return Criterion::agrees("load", load(100, 5, "balance"), load(101, 5, source_of_second),
                             counting(2, 2));
  };
  BOOST_TEST(is(apart("balance"), Outcome::holds));
  BOOST_TEST(is(apart("another"), Outcome::undecided));
  BOOST_TEST(is(Criterion::agrees_relatively("load", load(100, 1, "balance"),
                                             load(101, 1.01, "balance"), counting(0.02, 2)),
                Outcome::holds));
  BOOST_TEST(is(Criterion::agrees_relatively("load", load(100, 1, "balance"),
                                             load(101, 1.01, "another"), counting(0.02, 2)),
                Outcome::undecided));
}

BOOST_AUTO_TEST_CASE(a_standard_uncertainty_is_refused_where_nobody_says_how_many_count) {
  const auto decide = [] {
    (void)Criterion::at_most("load", load(993.63, 21.9, "fit"),
                             Limit(LimitKind::data, 1020, "the paper's load"));
  };
  const std::string message = message_of<std::invalid_argument>(decide);
  BOOST_TEST(holds(message, "criterion_test.cpp:"));
  BOOST_TEST(message.ends_with("load: 993.63 has a standard uncertainty of 21.9: say how many of "
                               "them the limit counts, by Limit(...).counting(2)"),
             message);
  BOOST_CHECK_THROW(counting(1, 0), std::invalid_argument);
  BOOST_CHECK_THROW(counting(1, std::nan("")), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
