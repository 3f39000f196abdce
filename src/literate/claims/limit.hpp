// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "literate/values/number.hpp"

namespace literate {

/// Why a limit is what it is.
enum class LimitKind {
  theory,  ///< it follows from a formula
  data,    ///< a source, or the statement itself, prints it
  method,  ///< the same run estimates it
  choice,  ///< a reader could choose a different one
};

/// theory, data, method or choice.
std::string_view name_of(LimitKind kind);

/// The number that decides a criterion, with the reason for it (LaTeX): {0.1, LimitKind::choice,
/// "what a plot shows"}.
///
/// The number that is tested is the one that is printed: all of its digits if there are no more
/// than six, else three, or `n_digits` if they are given. `number.abs_error` is how wrong the limit
/// itself may be. The criteria refuse a limit that is not finite or has no reason, and one that
/// decides differently before it is rounded.
class Limit {
 public:
  Limit(numerics::Estimate number, LimitKind kind, std::string reason, int n_digits = 0);
  Limit(double number, LimitKind kind, std::string reason, int n_digits = 0)
      : Limit(numerics::Estimate{number, 0}, kind, std::move(reason), n_digits) {}

  /// The same limit for a quantity with a standard uncertainty, of which `k` > 0 count: k = 2 are
  /// about 95 % of a normal distribution.
  Limit counting(double k) const;

  /// The printed and tested number, and the one that was given.
  double number() const { return number_; }
  double unrounded() const { return unrounded_; }
  double bound() const { return bound_; }
  LimitKind kind() const { return kind_; }
  const std::string& reason() const { return reason_; }
  /// How many standard uncertainties count; none if nobody said.
  const std::optional<double>& n_counted() const { return n_counted_; }

  /// Throws std::invalid_argument with what is wrong with this limit.
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
