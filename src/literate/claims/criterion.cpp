// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/criterion.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"

namespace literate {
namespace {

/// The double nearest to a decimal number.
double number_of(const Decimal& decimal) {
  const std::string text = scientific(decimal);
  double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

double require_abs_error(const std::string& name, const Value& quantity) {
  if (!quantity.number()) throw std::invalid_argument(name + ": a criterion tests a number");
  if (!quantity.abs_error()) {
    throw std::invalid_argument(name + ": a criterion needs the error of what it tests");
  }
  return *quantity.abs_error();
}

/// A limit, or an error, in the notation of the quantity that it belongs to.
Value limit_like(double limit, const Value& quantity) {
  return quantity.is_percentage() ? Value(limit, exact().in_percent())
                                  : Value(limit, exact(), quantity.unit());
}

/// A relative difference in per cent, or as a number where that would be mostly zeros.
Value relative(double difference) {
  constexpr double least_percentage = 1e-5;
  return difference < least_percentage ? Value(difference, exact())
                                       : Value(difference, exact().in_percent());
}

/// Words that are the same in LaTeX, and values among them: «within {} of {}».
template <typename... Values>
Phrase phrase(std::string_view words, const Values&... values) {
  return {fmt::format(fmt::runtime(words), values.printed()...),
          fmt::format(fmt::runtime(words), values.latex()...)};
}

}  // namespace

std::string_view name_of(LimitKind kind) {
  switch (kind) {
    case LimitKind::derived:
      return "derived";
    case LimitKind::printed:
      return "from printed digits";
    case LimitKind::rounding:
      return "rounding";
    case LimitKind::stated:
      return "stated";
    case LimitKind::convention:
      return "convention";
    case LimitKind::regression:
      return "regression band";
  }
  throw std::invalid_argument("a limit needs one of the kinds of limits");
}

Limit::Limit(LimitKind kind, numerics::Estimate number, std::string reason, int n_digits)
    : kind_(kind), abs_error_(number.abs_error), reason_(std::move(reason)) {
  if (reason_.empty()) throw std::invalid_argument("a limit needs a reason");
  name_of(kind_);  // throws for one that is none
  if (!(std::isfinite(abs_error_) && abs_error_ >= 0)) {
    throw std::invalid_argument("the error of a limit is negative or not finite");
  }
  if (n_digits > 17) throw std::invalid_argument("a limit has at most 17 digits");
  number_ = number_of(rounded_to_digits(number.value, n_digits));
}

std::string_view name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::holds:
      return "holds";
    case Outcome::holds_in_part:
      return "holds in part";
    case Outcome::fails:
      return "fails";
    case Outcome::undecided:
      break;
  }
  return "undecided";
}

Criterion::Criterion(std::string name, Value quantity, Limit limit)
    : name_(std::move(name)), quantity_(std::move(quantity)), limit_(std::move(limit)) {
  if (name_.empty()) throw std::invalid_argument("a criterion names what it tests");
  found_ = phrase("{}", quantity_);
}

/// Compares the interval of the tested number with that of the limit; both are printed as `like`
/// is.
void Criterion::decide(double tested, double error, bool is_upper_limit, const Value& like) {
  // A negated limit turns «at least» into «at most»: −q ≤ −L.
  const double sign = is_upper_limit ? 1 : -1;
  excess_ = sign * (tested - limit_.number());
  const double unsure = error + limit_.abs_error();
  if (excess_ + unsure <= 0) {
    outcome_ = Outcome::holds;
  } else if (excess_ - unsure > 0) {
    outcome_ = Outcome::fails;
  } else {
    outcome_ = Outcome::undecided;
    const double printed = number_of(rounded_up_to_digits(unsure, 1));
    missing_ =
        fmt::format("an error of {} reaches across the limit", limit_like(printed, like).printed());
  }
}

Criterion Criterion::at_most(std::string name, Value quantity, Limit limit) {
  const double error = require_abs_error(name, quantity);
  Criterion criterion(std::move(name), std::move(quantity), std::move(limit));
  criterion.condition_ =
      phrase("at most {}", limit_like(criterion.limit_.number(), criterion.quantity_));
  criterion.decide(*criterion.quantity_.number(), error, true, criterion.quantity_);
  return criterion;
}

Criterion Criterion::at_least(std::string name, Value quantity, Limit limit) {
  const double error = require_abs_error(name, quantity);
  Criterion criterion(std::move(name), std::move(quantity), std::move(limit));
  criterion.condition_ =
      phrase("at least {}", limit_like(criterion.limit_.number(), criterion.quantity_));
  criterion.decide(*criterion.quantity_.number(), error, false, criterion.quantity_);
  return criterion;
}

Criterion Criterion::agrees(std::string name, Value computed, Value stated, Limit tolerance) {
  const double error = require_abs_error(name, computed) + require_abs_error(name, stated);
  const double difference = std::abs(*computed.number() - *stated.number());
  Criterion criterion(std::move(name), std::move(computed), std::move(tolerance));
  const Value limit = limit_like(criterion.limit_.number(), criterion.quantity_);
  criterion.condition_ = criterion.limit_.number() == 0 ? phrase("equal to {}", stated)
                                                        : phrase("within {} of {}", limit, stated);
  criterion.decide(difference, error, true, criterion.quantity_);
  return criterion;
}

Criterion Criterion::agrees_relatively(std::string name, Value computed, Value stated,
                                       Limit tolerance) {
  const double error = require_abs_error(name, computed);
  const double error_of_stated = require_abs_error(name, stated);
  const double c = *computed.number();
  const double s = *stated.number();
  if (!(std::abs(s) > error_of_stated)) {
    throw std::invalid_argument(name + ": a relative difference from zero");
  }
  // |(c ± δc)/(s ± δs) − c/s| ≤ (δc + |c/s| δs)/(|s| − δs)
  const double unsure =
      (error + std::abs(c / s) * error_of_stated) / (std::abs(s) - error_of_stated);
  Criterion criterion(std::move(name), std::move(computed), std::move(tolerance));
  const double off = std::abs(c / s - 1);
  // A difference that is lost in its error is told by what it is at most.
  criterion.found_ =
      off > unsure ? phrase("{}, {} from {}", criterion.quantity_,
                            Value({off, unsure}, significant(2).in_percent()), stated)
                   : phrase("{}, at most {} from {}", criterion.quantity_,
                            relative(number_of(rounded_up_to_digits(off + unsure, 1))), stated);
  criterion.condition_ = phrase("within {} of {}", relative(criterion.limit_.number()), stated);
  criterion.decide(off, unsure, true, Value(0, exact().in_percent()));
  if (criterion.outcome_ == Outcome::undecided) {
    // The error, which says why, stands behind it.
    criterion.found_ = phrase("{}, {} from {}", criterion.quantity_,
                              relative(number_of(rounded_to_digits(off, 2))), stated);
  }
  return criterion;
}

Criterion Criterion::in_each(std::string name, std::string cases,
                             const std::vector<Criterion>& each) {
  if (each.empty()) throw std::invalid_argument(name + ": there is no case to try");
  const Criterion& first = each.front();
  if (!std::ranges::all_of(each, [&](const Criterion& c) {
        return c.condition_.plain == first.condition_.plain && c.reason() == first.reason();
      })) {
    throw std::invalid_argument(name + ": the cases are not held to one limit");
  }
  const auto n_with = [&](Outcome outcome) {
    return std::ranges::count(each, outcome, &Criterion::outcome_);
  };
  const auto n_holding = n_with(Outcome::holds);
  const auto n = std::ssize(each);
  const auto n_undecided = n_with(Outcome::undecided);
  const Criterion& worst = *std::ranges::max_element(each, {}, &Criterion::excess_);

  Criterion criterion(std::move(name), Value(n_holding, integer()).within(0), first.limit_);
  const std::string counted = fmt::format("{} of {} {}", n_holding, n, cases);
  criterion.found_ = {fmt::format("{}, at worst {}", counted, worst.found_.plain),
                      fmt::format("{}, at worst {}", escape_latex(counted), worst.found_.latex)};
  criterion.condition_ = first.condition_;
  criterion.excess_ = worst.excess_;
  if (n_undecided > 0) {
    criterion.missing_ = fmt::format("{} of {} {} are undecided", n_undecided, n, cases);
  } else if (n_holding == n) {
    criterion.outcome_ = Outcome::holds;
  } else {
    criterion.outcome_ = n_holding == 0 ? Outcome::fails : Outcome::holds_in_part;
  }
  return criterion;
}

std::string Criterion::computed() const {
  return fmt::format("{}: {}", name_, found_.plain);
}

std::string Criterion::reason() const {
  return fmt::format("{}: {}", name_of(limit_.kind()), limit_.reason());
}

}  // namespace literate
