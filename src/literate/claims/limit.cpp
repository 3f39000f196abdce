// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/limit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"

namespace literate {
namespace {

constexpr int most_limit_digits = 17;
constexpr std::array<std::string_view, 4> names_of_kinds{"theory", "data", "method", "choice"};

/// The number as it is printed and tested.
double printed(double number, int n_digits) {
  if (!std::isfinite(number)) return number;
  if (n_digits > 0 && n_digits <= most_limit_digits) {
    return number_of(rounded_to_digits(number, n_digits));
  }
  // Digits after the twelfth are rounding errors: 3 · 0.001 is 0.003.
  constexpr int n_meant = 12, n_all = 6, n_else = 3;
  const double meant = number_of(rounded_to_digits(number, n_meant));
  const bool has_few = shortest(meant).digits.size() <= n_all;
  return has_few ? meant : number_of(rounded_to_digits(number, n_else));
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

Limit::Limit(numerics::Estimate number, LimitKind kind, std::string reason, int n_digits)
    : number_(printed(number.value, n_digits)),
      unrounded_(number.value),
      bound_(number.abs_error),
      kind_(kind),
      reason_(std::move(reason)),
      n_digits_(n_digits) {}

Limit Limit::counting(double k) const {
  Limit limit = *this;
  limit.n_counted_ = k;
  return limit;
}

void Limit::require_valid() const {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument(why); };
  if (!std::isfinite(unrounded_)) refuse(fmt::format("the limit {} is not finite", unrounded_));
  if (!(std::isfinite(bound_) && bound_ >= 0)) {
    refuse(fmt::format("the error {} of the limit is not finite or below zero", bound_));
  }
  if (n_digits_ < 0 || n_digits_ > most_limit_digits) {
    refuse(fmt::format("{} digits of a limit: there are 1 to {}", n_digits_, most_limit_digits));
  }
  if (n_counted_ && !(std::isfinite(*n_counted_) && *n_counted_ > 0)) {
    refuse(fmt::format("counting({}): must be finite and positive", *n_counted_));
  }
  if (reason_.empty()) refuse("a limit needs a reason");
  (void)author_latex(reason_);
}

}  // namespace literate
