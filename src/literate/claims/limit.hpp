// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "literate/values/number.hpp"

namespace literate {

/// Where the number of a limit comes from.
enum class LimitKind {
  theory,  ///< a formula
  data,    ///< a source, or the statement itself
  method,  ///< an estimate by the same run
  choice,  ///< the author's judgement; a reader may choose a different number
};

/// Returns theory, data, method or choice.
std::string_view name_of(LimitKind kind);

/// Returns the kind with this name. Throws std::invalid_argument for any other text.
LimitKind limit_kind_named(std::string_view name);

/// The number that decides a criterion, with the reason for it (LaTeX): {0.1, LimitKind::choice,
/// "what a plot shows"}.
///
/// The criterion tests the rounded number that it prints: with `n_digits` digits if given, else
/// with all of its digits up to six, else with three. `number.abs_error` bounds the error of the
/// limit itself. Criteria refuse a limit that is not finite, has no reason, or would decide
/// differently before rounding.
class Limit {
 public:
  Limit(numerics::Estimate number, LimitKind kind, std::string reason, int n_digits = 0);
  Limit(double number, LimitKind kind, std::string reason, int n_digits = 0)
      : Limit(numerics::Estimate{number, 0}, kind, std::move(reason), n_digits) {}

  /// Returns this limit for a quantity with a standard uncertainty: `k` > 0 of them count as its
  /// error. k = 2 covers about 95 % of a normal distribution.
  Limit counting(double k) const;

  /// The number that is printed and tested, and the one that was given.
  double number() const { return number_; }
  double unrounded() const { return unrounded_; }
  double bound() const { return bound_; }
  LimitKind kind() const { return kind_; }
  const std::string& reason() const { return reason_; }
  /// How many standard uncertainties count; none if counting() was not called.
  const std::optional<double>& n_counted() const { return n_counted_; }

  /// Throws std::invalid_argument if this limit is invalid.
  void require_valid() const;

 private:
  double number_ = 0;
  double unrounded_;
  double bound_;
  LimitKind kind_;
  std::string reason_;
  int n_digits_;
  std::optional<double> n_counted_ = {};
};

}  // namespace literate
