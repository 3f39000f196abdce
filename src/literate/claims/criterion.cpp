// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/criterion.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"
#include "literate/values/decimal.hpp"

namespace literate {
namespace {

constexpr std::array<std::string_view, 4> names_of_verdicts{"holds", "holds in part", "fails",
                                                            "undecided"};

constexpr std::array<std::string_view, 4> names_of_kinds{"theory", "data", "method", "choice"};

/// The number of a limit as it is printed and tested.
double printed(double number) {
  if (!std::isfinite(number)) return number;
  // Digits after the twelfth are rounding errors: 3 · 0.001 is 0.003.
  constexpr int n_meant = 12, n_all = 6, n_else = 3;
  const double meant = number_of(rounded_to_digits(number, n_meant));
  const bool has_few = shortest(meant).digits.size() <= n_all;
  return has_few ? meant : number_of(rounded_to_digits(number, n_else));
}

/// Runs `make`, and adds the caller's line and the criterion's name to its error.
template <typename Make>
auto at(const Place& place, const std::string& name, Make&& make) {
  try {
    return std::forward<Make>(make)();
  } catch (const std::invalid_argument& error) {
    fail_at(place, fmt::format("criterion '{}': {}", name, error.what()));
  }
}

void require_number(const Value& quantity) {
  if (quantity.is_text()) throw std::invalid_argument("it tests a number, not a text");
  quantity.require_valid();
}

std::string unit_of(const Value& quantity) {
  const std::string unit = plain_unit(quantity.unit());
  return unit.empty() ? "no unit" : unit;
}

void require_same_unit(const Value& a, const Value& b) {
  if (unit_of(a) == unit_of(b)) return;
  throw std::invalid_argument(fmt::format("{} has {} and {} has {}: give both in the same unit",
                                          a.printed(), unit_of(a), b.printed(), unit_of(b)));
}

/// The number with its errors; a number of unknown error counts as exact.
Number known(const Value& quantity) {
  return quantity.known().value_or(Number(quantity.number(), 0));
}

/// The error of a quantity as it counts against the limit.
double error_of(const Value& quantity, const Limit& limit) {
  const Number number = known(quantity);
  if (number.standard == 0) return number.bound;
  const auto& n_counted = limit.n_counted();
  if (!n_counted) {
    throw std::invalid_argument(
        fmt::format("{} has a standard uncertainty of {}: the limit must state how many of them "
                    "count, such as counting 2",
                    quantity.printed(), round_trip(number.standard)));
  }
  return add_up(number.bound, multiply_up(*n_counted, number.standard));
}

/// A limit or an error in the unit of its quantity.
Value limit_like(double limit, const Value& quantity) {
  return {limit, quantity.is_percentage() ? exact().in_percent() : exact(), quantity.unit()};
}

Phrase in_signs(std::string_view plain, std::string_view latex, const Phrase& number) {
  return {fmt::format("{} {}", plain, number.plain), fmt::format("${}$~{}", latex, number.latex)};
}

Verdict outcome_of(double excess, double unsure) {
  if (excess + unsure <= 0) return Verdict::holds;
  return excess - unsure > 0 ? Verdict::fails : Verdict::undecided;
}

/// One decimal below ten, none above, and no number above a thousand.
std::string rough(double ratio, const char* unit) {
  constexpr double most = 1000;
  if (ratio > most) return fmt::format("over {} {}", most, unit);
  return fmt::format("{:.{}f} {}", ratio, ratio < 10 ? 1 : 0, unit);
}

/// |c − s| with its errors.
Number difference(const Value& computed, const Value& stated) {
  const Number c = known(computed), s = known(stated);
  if (c.is_exact() && s.is_exact()) return {std::abs(decimal_difference(c.value, s.value)), 0};
  const double rounding = std::abs(error_of_sum(c.value, -s.value));
  return {std::abs(c.value - s.value), add_up(add_up(c.bound, s.bound), rounding),
          add_up(c.standard, s.standard)};
}

/// |c/s − 1| with its errors: c'/s' − c/s is (δ − ε c/s)/s' for c' = c + δ and s' = s + ε.
Number relative_difference(const Value& computed, const Value& stated) {
  const Number c = known(computed), s = known(stated);
  if (!(std::abs(s.value) > s.bound)) {
    throw std::invalid_argument(
        fmt::format("{} may be zero, so nothing is relative to it", stated.printed()));
  }
  if (c.is_exact() && s.is_exact()) {
    return {std::abs(decimal_difference(c.value, s.value) / s.value), 0};
  }
  const double apart = c.value - s.value;
  const double ratio = std::abs(apart / s.value);
  const double least = std::abs(s.value) - s.bound;
  const double slope = std::abs(c.value / s.value);
  const double of_difference = std::abs(error_of_sum(c.value, -s.value));
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const auto share = [&](double of_c, double of_s) {
    return (1 + 4 * epsilon) * (of_c + slope * of_s) / least;  // four roundings
  };
  return {ratio, share(c.bound + of_difference, s.bound) + epsilon * ratio,
          share(c.standard, s.standard)};
}

}  // namespace

std::string_view name_of(LimitKind kind) {
  return names_of_kinds.at(static_cast<std::size_t>(kind));
}

LimitKind limit_kind_named(std::string_view name) {
  const auto* const found = std::ranges::find(names_of_kinds, name);
  if (found != names_of_kinds.end()) return static_cast<LimitKind>(found - names_of_kinds.begin());
  throw std::invalid_argument(
      fmt::format("'{}' is not a kind of limit: theory, data, method or choice", name));
}

Limit::Limit(double number, LimitKind kind, std::string reason)
    : number_(printed(number)), kind_(kind), reason_(std::move(reason)) {}

Limit Limit::counting(double k) const {
  Limit limit = *this;
  limit.n_counted_ = k;
  return limit;
}

void Limit::require_valid() const {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument(why); };
  if (!std::isfinite(number_)) refuse(fmt::format("the limit {} is not finite", number_));
  if (n_counted_ && !(std::isfinite(*n_counted_) && *n_counted_ > 0)) {
    refuse(fmt::format("counting({}): must be finite and positive", *n_counted_));
  }
  if (reason_.empty()) refuse("a limit needs a reason");
  (void)author_latex(reason_);
}

std::string_view name_of(Verdict verdict) {
  return names_of_verdicts.at(static_cast<std::size_t>(verdict));
}

Verdict verdict_named(std::string_view name) {
  const auto* const found = std::ranges::find(names_of_verdicts, name);
  if (found != names_of_verdicts.end()) {
    return static_cast<Verdict>(found - names_of_verdicts.begin());
  }
  throw std::invalid_argument(
      fmt::format("'{}' is not a verdict: holds, holds in part, fails or undecided", name));
}

std::string Margin::text() const {
  if (!factor && !errors) return "exact";
  if (!factor) return rough(*errors, "errors");
  const std::string times = rough(*factor, "times");
  return errors ? fmt::format("{}; {}", times, rough(*errors, "errors")) : times;
}

Criterion::Criterion(std::string name, Limit limit, const Place& place)
    : name_(std::move(name)), limit_(std::move(limit)) {
  at(place, name_, [&] {
    if (name_.empty()) throw std::invalid_argument("a criterion names what it tests");
    name_ = author_latex(name_);
    limit_.require_valid();
  });
}

void Criterion::decide(const Value& tested, Side side, const Place& place) {
  const double unsure = at(place, name_, [&] { return error_of(tested, limit_); });
  const double sign = side == Side::at_most ? 1 : -1;
  const double limit = limit_.number();
  excess_ = sign * (tested.number() - limit);
  verdict_ = outcome_of(excess_, unsure);
  if (unsure > 0) margin_.errors = std::abs(excess_) / unsure;
  if (tested.number() > 0 && limit > 0) {
    margin_.factor = std::max(tested.number() / limit, limit / tested.number());
  }
  if (verdict_ == Verdict::undecided) {
    const double printed = number_of(rounded_up_to_digits(unsure, 2));
    missing_ = fmt::format("an error of {} reaches across the limit",
                           limit_like(printed, tested).printed());
    found_ = undecided_phrase(tested, unsure, limit);
  } else {
    found_ = found_phrase(tested, unsure, limit, side);
  }
}

Criterion Criterion::one_sided(std::string name, const Value& quantity, const Limit& limit,
                               Side side, const Place& place) {
  Criterion criterion(std::move(name), limit, place);
  at(place, criterion.name_, [&] { require_number(quantity); });
  criterion.decide(quantity, side, place);
  const Phrase number = phrase_of(limit_like(criterion.limit_.number(), quantity));
  criterion.limit_phrase_ =
      side == Side::at_most ? in_signs("≤", "\\le", number) : in_signs("≥", "\\ge", number);
  return criterion;
}

Criterion Criterion::at_most(std::string name, const Value& quantity, const Limit& limit,
                             const Place& place) {
  return one_sided(std::move(name), quantity, limit, Side::at_most, place);
}

Criterion Criterion::at_least(std::string name, const Value& quantity, const Limit& limit,
                              const Place& place) {
  return one_sided(std::move(name), quantity, limit, Side::at_least, place);
}

Criterion Criterion::agrees(std::string name, const Value& computed, const Value& stated,
                            const Limit& tolerance, const Place& place) {
  constexpr int n_digits = 2;
  Criterion criterion(std::move(name), tolerance, place);
  const Number apart = at(place, criterion.name_, [&] {
    require_number(computed);
    require_number(stated);
    require_same_unit(computed, stated);
    return difference(computed, stated);
  });
  const bool are_counts = computed.format().notation() == Notation::integer && apart.is_exact();
  Format format = are_counts ? exact() : significant(n_digits);
  if (computed.is_percentage()) format = format.in_percent();
  criterion.decide(Value(apart, format, computed.unit()), Side::at_most, place);
  criterion.found_ =
      phrase("{}, {} from {}", phrase_of(computed), criterion.found_, phrase_of(stated));
  criterion.limit_phrase_ =
      tolerance.number() == 0
          ? in_signs("=", "=", phrase_of(stated))
          : in_signs("≤", "\\le", phrase_of(limit_like(criterion.limit_.number(), computed)));
  return criterion;
}

Criterion Criterion::agrees_relatively(std::string name, const Value& computed, const Value& stated,
                                       const Limit& tolerance, const Place& place) {
  constexpr int n_digits = 2;
  // In per cent a smaller difference would print mostly zeros.
  constexpr double least_percentage = 1e-5;
  Criterion criterion(std::move(name), tolerance, place);
  const Number apart = at(place, criterion.name_, [&] {
    require_number(computed);
    require_number(stated);
    require_same_unit(computed, stated);
    return relative_difference(computed, stated);
  });
  const auto in_percent = [](double ratio, const Format& format) {
    return ratio != 0 && ratio < least_percentage ? format : format.in_percent();
  };
  const Value difference(apart, in_percent(apart.value + apart.bound, significant(n_digits)));
  criterion.decide(difference, Side::at_most, place);
  criterion.found_ =
      phrase(difference.is_percentage() ? "{}, {} from {}" : "{0} against {2}, relatively {1}",
             phrase_of(computed), criterion.found_, phrase_of(stated));
  const double limit = criterion.limit_.number();
  criterion.limit_phrase_ =
      in_signs("≤", "\\le", phrase_of(Value(limit, in_percent(limit, exact()))));
  return criterion;
}

Criterion Criterion::in_each(std::string name, std::string cases,
                             const std::vector<Criterion>& each, const Place& place) {
  if (each.empty()) fail_at(place, fmt::format("criterion '{}': there is no case to try", name));
  const Criterion& first = each.front();
  for (const Criterion& other : each) {
    const bool is_same = other.limit_phrase_.plain == first.limit_phrase_.plain &&
                         other.limit_.kind() == first.limit_.kind() &&
                         other.limit_.reason() == first.limit_.reason();
    if (is_same) continue;
    fail_at(place, fmt::format("criterion '{}': the cases have different limits, {} ({}) and {} "
                               "({})",
                               name, first.limit_phrase_.plain, first.limit_.reason(),
                               other.limit_phrase_.plain, other.limit_.reason()));
  }
  const auto n_with = [&](Verdict verdict) {
    return std::ranges::count(each, verdict, &Criterion::verdict_);
  };
  const auto n_holding = n_with(Verdict::holds), n_failing = n_with(Verdict::fails);
  const auto n_undecided = n_with(Verdict::undecided);
  const bool none_holds = n_failing == std::ssize(each);
  const Criterion& shown = none_holds ? *std::ranges::min_element(each, {}, &Criterion::excess_)
                                      : *std::ranges::max_element(each, {}, &Criterion::excess_);

  Criterion criterion(std::move(name), first.limit_, place);
  cases = at(place, criterion.name_, [&] { return author_latex(cases); });
  const std::string counted = fmt::format("{} of {} {}", n_holding, each.size(), cases);
  criterion.found_ =
      phrase(none_holds ? "{}; nearest: {}" : "{}; worst: {}", {counted, counted}, shown.found_);
  criterion.limit_phrase_ = first.limit_phrase_;
  criterion.excess_ = shown.excess_;
  criterion.margin_ = shown.margin_;
  if (n_holding > 0 && n_failing > 0) {
    criterion.verdict_ = Verdict::holds_in_part;  // whether or not others are undecided
  } else if (n_undecided > 0) {
    criterion.missing_ = fmt::format("{} of {} {} {} undecided", n_undecided, each.size(), cases,
                                     n_undecided == 1 ? "is" : "are");
  } else {
    criterion.verdict_ = n_holding > 0 ? Verdict::holds : Verdict::fails;
  }
  return criterion;
}

std::string Criterion::text() const {
  const std::string why = missing_.empty() ? "" : fmt::format(", {}", missing_);
  return fmt::format("{}: {} ({}): {}{}", name_, found_.plain, limit_phrase_.plain,
                     name_of(verdict_), why);
}

Verdict verdict_of(const std::vector<Criterion>& criteria) {
  const auto have_all = [&](Verdict verdict) {
    return std::ranges::all_of(criteria,
                               [=](const Criterion& c) { return c.verdict() == verdict; });
  };
  if (std::ranges::any_of(criteria,
                          [](const Criterion& c) { return c.verdict() == Verdict::undecided; })) {
    return Verdict::undecided;
  }
  if (have_all(Verdict::holds)) return Verdict::holds;
  return have_all(Verdict::fails) ? Verdict::fails : Verdict::holds_in_part;
}

std::string text_of(const std::vector<Criterion>& criteria) {
  std::string text;
  for (const Criterion& criterion : criteria) {
    text += (text.empty() ? "" : "; ") + criterion.text();
  }
  return text;
}

}  // namespace literate
