// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/limit.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "literate/values/decimal.hpp"

namespace literate {
namespace {

bool has_digits(double number, int n_digits) {
  constexpr double rounding = 1e-12;  // a percentage is divided by 100
  const double rounded = number_of(rounded_to_digits(number, n_digits));
  return number == std::trunc(number) || std::abs(number - rounded) <= rounding * std::abs(number);
}

/// Throws std::invalid_argument for a number that cannot be of this kind.
void require_of_kind(LimitKind kind, double number, int n_digits) {
  constexpr int round_digits = 2;
  const std::string told = round_trip(number);
  if (kind == LimitKind::theory) {
    throw std::invalid_argument(fmt::format(
        "a limit of theory is a formula that is evaluated, by Limit::theory, not the number {}",
        told));
  }
  if (kind == LimitKind::data && !has_digits(number, n_digits)) {
    throw std::invalid_argument(fmt::format(
        "a limit of data is a printed number, all of whose digits count: {} has more than {}", told,
        n_digits));
  }
  if (kind == LimitKind::method && has_digits(number, round_digits) &&
      number != std::trunc(number)) {
    throw std::invalid_argument(fmt::format(
        "a limit of method is what the run itself estimates: the round number {} is a choice",
        told));
  }
}

}  // namespace

std::string_view name_of(LimitKind kind) {
  switch (kind) {
    case LimitKind::theory:
      return "theory";
    case LimitKind::data:
      return "data";
    case LimitKind::method:
      return "method";
    case LimitKind::choice:
      return "choice";
  }
  throw std::invalid_argument("a limit needs one of the kinds of limits");
}

Limit Limit::theory(const std::string& formula, const std::map<std::string, double>& terms,
                    const std::string& reason, int n_digits) {
  Limit limit(LimitKind::choice, evaluated(formula, terms), formula + ", " + reason, n_digits);
  limit.kind_ = LimitKind::theory;
  return limit;
}

Limit::Limit(LimitKind kind, numerics::Estimate number, std::string reason, int n_digits)
    : kind_(kind),
      unrounded_(number.value),
      n_digits_(n_digits),
      abs_error_(number.abs_error),
      reason_(std::move(reason)) {
  if (reason_.empty()) throw std::invalid_argument("a limit needs a reason");
  name_of(kind_);  // throws for one that is none
  if (!(std::isfinite(abs_error_) && abs_error_ >= 0)) {
    throw std::invalid_argument("the error of a limit is negative or not finite");
  }
  if (n_digits > 17) throw std::invalid_argument("a limit has at most 17 digits");
  number_ = number_of(rounded_to_digits(number.value, n_digits));
  require_of_kind(kind_, unrounded_, n_digits);
}

Limit Limit::counting(double k) const {
  if (!(k > 0 && std::isfinite(k))) {
    throw std::invalid_argument(
        fmt::format("{} standard uncertainties counted: must be a finite number > 0", k));
  }
  Limit limit = *this;
  limit.n_counted_ = k;
  limit.reason_ += fmt::format("; {} standard uncertainties are allowed for", k);
  return limit;
}

}  // namespace literate
