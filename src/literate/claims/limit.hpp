// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "numerics/estimate.hpp"

namespace literate {

/// Why a limit is what it is. Each kind has a test, so that the reason can be wrong.
enum class LimitKind {
  theory,  ///< it follows from a formula: Limit::theory evaluates the one that is printed
  data,    ///< a source, or the statement, prints it, and all of its digits count
  method,  ///< the same run estimates it: an integer, or more than two significant digits
  choice,  ///< a reader could choose another one: `check` names it if half or double would decide
};

/// theory, data, method or choice.
std::string_view name_of(LimitKind kind);

/// The number that decides a criterion, with the reason for it.
///
/// The limit that is tested is the one that is printed, the number rounded to `n_digits`
/// significant digits; a criterion that this rounding would decide is refused. `number.abs_error`
/// is how wrong the unrounded limit may be; the criterion is undecided where that matters. Throws
/// std::invalid_argument for a number or error that is not finite, for a negative error, for
/// n_digits outside 1 to 17, for an empty reason, and for a number that is none of its kind.
class Limit {
 public:
  Limit(LimitKind kind, numerics::Estimate number, std::string reason, int n_digits = 3);
  Limit(LimitKind kind, double number, std::string reason, int n_digits = 3)
      : Limit(kind, numerics::Estimate{number, 0}, std::move(reason), n_digits) {}

  /// A limit of theory: the formula is evaluated and stands first in the reason, so that neither
  /// can be another one: theory("μ(c/a)²", {{"μ", mu}, {"c", c}, {"a", a}}, "the elements' order").
  /// evaluated() says what a formula may hold, and what it throws.
  static Limit theory(const std::string& formula, const std::map<std::string, double>& terms,
                      const std::string& reason, int n_digits = 3);

  /// The same limit for a quantity with a standard uncertainty, of which `k` > 0 count: k = 2 are
  /// about 95 % of a normal distribution. The reason says so. Throws std::invalid_argument for
  /// another k.
  Limit counting(double k) const;

  double number() const { return number_; }
  /// How many standard uncertainties count; none if nobody said.
  const std::optional<double>& n_counted() const { return n_counted_; }
  double unrounded() const { return unrounded_; }
  int n_digits() const { return n_digits_; }
  double abs_error() const { return abs_error_; }
  LimitKind kind() const { return kind_; }
  const std::string& reason() const { return reason_; }

 private:
  LimitKind kind_;
  double number_;
  double unrounded_;
  int n_digits_;
  double abs_error_;
  std::optional<double> n_counted_;
  std::string reason_;
};

/// The number that a formula has as one writes it: «2(a/d)² + ε[1 + ln(2/ε)]».
///
/// It holds numbers, names of terms, + − · /, a − before what stands first, products without a
/// sign, parentheses of both kinds, ² ³ ⁴, and ln of what follows. Products and quotients are taken
/// from the left. Throws std::invalid_argument with the formula for anything else, for a term that
/// is never used, and for a result that is not finite.
double evaluated(std::string_view formula, const std::map<std::string, double>& terms);

}  // namespace literate
