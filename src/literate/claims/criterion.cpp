// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/criterion.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"
#include "literate/values/decimal.hpp"

namespace literate {
namespace {

/// «src/main.cpp:40: strain», for messages.
std::string caller_of(const Criterion::Location& location, const std::string& name) {
  const std::string line = fmt::format("{}:{}: ", location.file_name(), location.line());
  if (name.empty()) throw std::invalid_argument(line + "a criterion names what it tests");
  return line + name;
}

using numerics::Estimate;
using numerics::Measured;

Measured require_measured(const std::string& place, const Value& quantity) {
  if (!quantity.number()) throw std::invalid_argument(place + ": a criterion tests a number");
  try {
    quantity.require_finite();
    quantity.require_error();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", place, error.what()));
  }
  return quantity.measured().value();
}

/// The unit of number(), of which a percentage has none.
std::string unit_of(const Value& quantity) {
  const std::string unit = plain_unit(quantity.unit());
  return unit.empty() ? "no unit" : unit;
}

void require_one_unit(const std::string& place, const Value& computed, const Value& stated) {
  if (unit_of(computed) == unit_of(stated)) return;
  throw std::invalid_argument(fmt::format("{}: {} has {} and {} has {}: give both in one unit",
                                          place, computed.printed(), unit_of(computed),
                                          stated.printed(), unit_of(stated)));
}

/// The difference of two quantities of one unit.
bool is_exact(const Measured& number) {
  return number.standard() == 0 && number.bounded().abs_error == 0;
}

/// Of exact numbers the difference is that of the decimal numbers that are printed.
Measured difference_between(const std::string& place, const Value& computed, const Value& stated) {
  const Measured c = require_measured(place, computed);
  const Measured s = require_measured(place, stated);
  require_one_unit(place, computed, stated);
  if (!is_exact(c) || !is_exact(s)) return c - s;
  return Measured::bounded({decimal_difference(c.value(), s.value()), 0});
}

/// A difference is held against a limit that it can meet and miss.
void require_distance(const std::string& place, const Limit& limit) {
  if (limit.number() >= 0) return;
  throw std::invalid_argument(
      fmt::format("{}: the limit of a difference is 0 or more, not {}", place, limit.number()));
}

/// How many standard uncertainties count; of a quantity that has none it does not matter.
double k_of(const Limit& limit) {
  return limit.n_counted().value_or(1);
}

Measured magnitude(const Measured& number) {
  return number.value() < 0 ? -number : number;
}

/// A number with the error that the limit counts.
Estimate counted(const std::string& place, const Measured& number, const Limit& limit) {
  if (number.standard() > 0 && !limit.n_counted()) {
    throw std::invalid_argument(
        fmt::format("{}: {} has a standard uncertainty of {}: say how many of them the limit "
                    "counts, by Limit(...).counting(2)",
                    place, round_trip(number.value()), round_trip(number.standard())));
  }
  return {number.value(), Uncertainty(number).error(k_of(limit))};
}

/// A limit, or an error, in the notation of the quantity that it belongs to.
Value limit_like(double limit, const Value& quantity) {
  return quantity.is_percentage() ? Value(limit, exact().in_percent())
                                  : Value(limit, exact(), quantity.unit());
}

/// A relative difference in per cent, unless that would be mostly zeros.
Format relative(const Format& format, double difference) {
  constexpr double least_percentage = 1e-5;
  return difference < least_percentage ? format : format.in_percent();
}

/// A relative difference without its error.
Value relative(double difference) {
  return {difference, relative(exact(), difference)};
}

/// A relation in signs and its number.
Phrase in_signs(std::string_view plain, std::string_view latex, const Value& number) {
  const Phrase printed = phrase("{}", number);
  return {fmt::format("{} {}", plain, printed.plain), fmt::format("${}$~{}", latex, printed.latex)};
}

Phrase at_most_in_signs(const Value& number) {
  return in_signs("≤", "\\le", number);
}

/// How far two quantities are apart, in their unit.
Value difference_of(const Value& computed, const Measured& difference) {
  if (computed.format()->notation() == Notation::integer && Uncertainty(difference).error() == 0) {
    return {difference.value(), exact(), computed.unit()};
  }
  constexpr int n_digits = 2;
  const Format format = significant(n_digits);
  return {difference, computed.is_percentage() ? format.in_percent() : format, computed.unit()};
}

/// One decimal below ten, and nothing that nobody would compare above a thousand.
std::string rough(double ratio, const char* unit) {
  constexpr double most = 1000;
  if (ratio > most) return fmt::format("over {} {}", most, unit);
  return fmt::format("{:.{}f} {}", ratio, ratio < 10 ? 1 : 0, unit);
}

}  // namespace

std::string Margin::text() const {
  if (!factor && !errors) return "exact";
  if (!factor) return rough(*errors, "errors");
  const std::string times = rough(*factor, "times");
  return errors ? fmt::format("{}; {}", times, rough(*errors, "errors")) : times;
}

std::string_view name_of(Outcome outcome) {
  constexpr std::array names{"holds", "holds in part", "fails", "undecided"};
  return names.at(static_cast<std::size_t>(outcome));
}

Criterion::Criterion(std::string name, Value quantity, Limit limit)
    : name_(std::move(name)), quantity_(std::move(quantity)), limit_(std::move(limit)) {}

namespace {

/// Against which a number that is `excess` beyond a limit holds if that is not positive.
Outcome outcome_of(double excess, double unsure) {
  if (excess + unsure <= 0) return Outcome::holds;
  return excess - unsure > 0 ? Outcome::fails : Outcome::undecided;
}

Phrase found_of(const Criterion& criterion, const Limit& limit, Side side) {
  const Value& quantity = criterion.quantity();
  const double k = k_of(limit);
  return criterion.outcome() == Outcome::undecided
             ? undecided_phrase(quantity, limit.number(), side, k)
             : found_phrase(quantity, limit.number(), side, k);
}

void take_least(std::optional<double>& least, const std::optional<double>& one) {
  if (one && (!least || *one < *least)) least = one;
}

std::string_view verb_of(Outcome outcome) {
  return outcome == Outcome::undecided ? "is undecided" : name_of(outcome);
}

/// The least factor in the common limit that gives all of them together another outcome: where some
/// hold and others fail, all of these or all of those must turn.
std::optional<double> turning_factor_of(const std::vector<Criterion>& each, Outcome outcome) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const auto factor = [&](const Criterion& c) { return c.margin().turning_factor.value_or(never); };
  double turning = never;
  if (outcome == Outcome::holds_in_part) {
    for (const Outcome side : {Outcome::holds, Outcome::fails}) {
      double all = 1;
      for (const Criterion& c : each) {
        if (c.outcome() == side || c.outcome() == Outcome::undecided)
          all = std::max(all, factor(c));
      }
      turning = std::min(turning, all);
    }
  } else {
    for (const Criterion& c : each) {
      if (c.outcome() == outcome) turning = std::min(turning, factor(c));
    }
  }
  return turning < never ? std::optional(turning) : std::nullopt;
}

}  // namespace

/// Compares the interval of the tested number with that of the limit; both are printed as `like`
/// is.
void Criterion::decide(const Estimate& tested, bool is_upper_limit, const Value& like,
                       const std::string& place) {
  // A negated limit turns «at least» into «at most»: −q ≤ −L.
  const double sign = is_upper_limit ? 1 : -1;
  excess_ = sign * (tested.value - limit_.number());
  const double unsure = tested.abs_error + limit_.abs_error();
  outcome_ = outcome_of(excess_, unsure);
  if (unsure > 0) margin_.errors = std::abs(excess_) / unsure;
  if (tested.value > 0 && limit_.number() > 0) {
    const double ratio = tested.value / limit_.number();
    margin_.factor = std::max(ratio, 1 / ratio);
    // The outcome is another one where the limit moves over an end of the number's interval.
    for (const double end : {tested.value - unsure, tested.value + unsure}) {
      if (end <= 0) continue;
      const double moved = end / limit_.number();
      take_least(margin_.turning_factor, std::max(moved, 1 / moved));
    }
  }
  const Outcome of_unrounded = outcome_of(sign * (tested.value - limit_.unrounded()), unsure);
  if (of_unrounded != outcome_) {
    throw std::invalid_argument(fmt::format(
        "{}: rounding decides, since {} {} against the printed limit {} and {} against {} itself: "
        "give the limit more than {} digits",
        place, round_trip(tested.value), verb_of(outcome_), round_trip(limit_.number()),
        verb_of(of_unrounded), round_trip(limit_.unrounded()), limit_.n_digits()));
  }
  if (outcome_ == Outcome::undecided) {
    const double printed = number_of(rounded_up_to_digits(unsure, 2));
    missing_ =
        fmt::format("an error of {} reaches across the limit", limit_like(printed, like).printed());
  }
}

Criterion::Criterion(Side side, std::string name, Value quantity, Limit limit, Location location)
    : Criterion(std::move(name), std::move(quantity), std::move(limit)) {
  const std::string place = caller_of(location, name_);
  const Estimate tested = counted(place, require_measured(place, quantity_), limit_);
  const bool is_upper = side == Side::at_most;
  const Value bound = limit_like(limit_.number(), quantity_);
  condition_ = phrase(is_upper ? "at most {}" : "at least {}", bound);
  limit_phrase_ = is_upper ? at_most_in_signs(bound) : in_signs("≥", "\\ge", bound);
  decide(tested, is_upper, quantity_, place);
  found_ = found_of(*this, limit_, side);
}

Criterion Criterion::at_most(std::string name, Value quantity, Limit limit, Location location) {
  return {Side::at_most, std::move(name), std::move(quantity), std::move(limit), location};
}

Criterion Criterion::at_least(std::string name, Value quantity, Limit limit, Location location) {
  return {Side::at_least, std::move(name), std::move(quantity), std::move(limit), location};
}

Criterion Criterion::agrees(std::string name, Value computed, Value stated, Limit tolerance,
                            Location location) {
  const std::string place = caller_of(location, name);
  require_distance(place, tolerance);
  const Measured apart = magnitude(difference_between(place, computed, stated));
  const Estimate tested = counted(place, apart, tolerance);
  const Value difference = difference_of(computed, apart);
  Criterion criterion(std::move(name), std::move(computed), std::move(tolerance));
  const double tolerated = criterion.limit_.number();
  const Value& quantity = criterion.quantity_;
  criterion.condition_ = tolerated == 0
                             ? phrase("equal to {}", stated)
                             : phrase("within {} of {}", limit_like(tolerated, quantity), stated);
  criterion.limit_phrase_ = tolerated == 0 ? in_signs("=", "=", stated)
                                           : at_most_in_signs(limit_like(tolerated, quantity));
  // Whether counts are equal can be seen; of other numbers the printed digits may be the same.
  const bool is_seen = tolerated == 0 && difference.format()->notation() == Notation::exact;
  criterion.found_ = is_seen ? phrase("{}", quantity)
                             : apart_phrase(quantity, stated, difference, tolerated, Side::at_most,
                                            Distance::absolute, k_of(criterion.limit_));
  criterion.decide(tested, true, quantity, place);
  return criterion;
}

Criterion Criterion::agrees_relatively(std::string name, Value computed, Value stated,
                                       Limit tolerance, Location location) {
  const std::string place = caller_of(location, name);
  require_distance(place, tolerance);
  const Measured c = require_measured(place, computed);
  const Measured s = require_measured(place, stated);
  require_one_unit(place, computed, stated);
  if (!(std::abs(s.value()) > s.bounded().abs_error + s.standard())) {
    throw std::invalid_argument(place + ": a relative difference from zero");
  }
  const Measured apart =
      magnitude(is_exact(c) && is_exact(s)
                    ? Measured::bounded({decimal_relative_difference(c.value(), s.value()), 0})
                    : c / s - 1);
  const Estimate tested = counted(place, apart, tolerance);
  Criterion criterion(std::move(name), std::move(computed), std::move(tolerance));
  const double off = tested.value;
  constexpr int n_digits = 2;
  const Value difference(apart, relative(significant(n_digits), off + tested.abs_error));
  criterion.found_ =
      apart_phrase(criterion.quantity_, stated, difference, criterion.limit_.number(),
                   Side::at_most, Distance::relative, k_of(criterion.limit_));
  criterion.condition_ = phrase("within {} of {}", relative(criterion.limit_.number()), stated);
  criterion.limit_phrase_ = at_most_in_signs(relative(criterion.limit_.number()));
  criterion.decide(tested, true, Value(0, exact().in_percent()), place);
  if (criterion.outcome_ == Outcome::undecided) {
    const Phrase by = undecided_phrase(difference, std::max(criterion.limit_.number(), off),
                                       Side::at_most, k_of(criterion.limit_));
    criterion.found_ =
        difference.is_percentage()
            ? phrase("{}, {} from {}", criterion.quantity_, by, stated)
            : phrase("{} against {}, relative difference {}", criterion.quantity_, stated, by);
  }
  return criterion;
}

Criterion Criterion::differs(std::string name, Value computed, Value stated, Limit limit,
                             Location location) {
  const std::string place = caller_of(location, name);
  require_distance(place, limit);
  const Measured apart = magnitude(difference_between(place, computed, stated));
  const Estimate tested = counted(place, apart, limit);
  const Value difference = difference_of(computed, apart);
  Criterion criterion(std::move(name), std::move(computed), std::move(limit));
  const Value& quantity = criterion.quantity_;
  const Value least = limit_like(criterion.limit_.number(), quantity);
  const bool is_any = criterion.limit_.number() == 0;
  criterion.condition_ =
      is_any ? phrase("another than {}", stated) : phrase("at least {} from {}", least, stated);
  criterion.limit_phrase_ = is_any ? in_signs("≠", "\\ne", stated) : in_signs("≥", "\\ge", least);
  criterion.decide(tested, false, quantity, place);
  // Two equal numbers without an error do not differ, although their difference is at least 0.
  if (is_any && tested.value == 0 && tested.abs_error == 0) criterion.outcome_ = Outcome::fails;
  const double wanted = criterion.limit_.number(), k = k_of(criterion.limit_);
  // A distance that is less than its error is at most something, whatever the limit.
  const double above = std::max(wanted, *difference.number());
  criterion.found_ = criterion.outcome_ == Outcome::undecided
                         ? phrase("{}, {} from {}", quantity,
                                  undecided_phrase(difference, above, Side::at_least, k), stated)
                         : apart_phrase(quantity, stated, difference, wanted, Side::at_least,
                                        Distance::absolute, k);
  return criterion;
}

Criterion Criterion::in_each(std::string name, std::string cases,
                             const std::vector<Criterion>& each) {
  if (each.empty()) throw std::invalid_argument(name + ": there is no case to try");
  const Criterion& first = each.front();
  const auto condition = [](const Criterion& c) {
    return fmt::format("{} ({})", c.condition_.plain, c.reason());
  };
  for (const Criterion& other : each) {
    if (condition(other) == condition(first)) continue;
    throw std::invalid_argument(fmt::format("{}: the cases have more than one condition: {} and {}",
                                            name, condition(first), condition(other)));
  }
  const auto n_with = [&](Outcome outcome) {
    return std::ranges::count(each, outcome, &Criterion::outcome_);
  };
  const auto n_holding = n_with(Outcome::holds);
  const auto n = std::ssize(each);
  const auto n_undecided = n_with(Outcome::undecided);
  const Criterion& worst = *std::ranges::max_element(each, {}, &Criterion::excess_);
  const Criterion& nearest = *std::ranges::min_element(each, {}, &Criterion::excess_);

  Criterion criterion(std::move(name), Value(n_holding, integer()), first.limit_);
  const std::string counted = fmt::format("{} of {} {}", n_holding, n, cases);
  const bool none_holds = n_with(Outcome::fails) == n;
  criterion.found_ =
      phrase(none_holds ? "{}; nearest: {}" : "{}; worst: {}",
             Phrase{counted, escape_latex(counted)}, none_holds ? nearest.found_ : worst.found_);
  criterion.condition_ = first.condition_;
  criterion.limit_phrase_ = first.limit_phrase_;
  criterion.excess_ = worst.excess_;
  criterion.margin_ = (none_holds ? nearest : worst).margin_;
  // What is undecided makes no difference where one holds and another fails.
  const bool is_in_part = n_holding > 0 && n_with(Outcome::fails) > 0;
  if (n_undecided > 0 && !is_in_part) {
    criterion.missing_ = fmt::format("{} of {} {} {} undecided", n_undecided, n, cases,
                                     n_undecided == 1 ? "is" : "are");
  } else if (n_holding == n) {
    criterion.outcome_ = Outcome::holds;
  } else {
    criterion.outcome_ = n_holding == 0 ? Outcome::fails : Outcome::holds_in_part;
  }
  criterion.margin_.turning_factor = turning_factor_of(each, criterion.outcome_);
  return criterion;
}

std::string Criterion::computed() const {
  return fmt::format("{}: {}", name_, found_.plain);
}

std::string Criterion::reason() const {
  return fmt::format("{}: {}", name_of(limit_.kind()), limit_.reason());
}

}  // namespace literate
