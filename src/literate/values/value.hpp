// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include "literate/values/format.hpp"
#include "numerics/estimate.hpp"

namespace literate {

/// A value as the document prints it, with the unrounded number: Value(4.7e-3, significant(2),
/// "in").
///
/// Units are spelt as literate/text/unit.hpp says, such as "in", "lbf/in" or "m s-1"; a percentage
/// has none. Numbers are rounded as literate/values/format.hpp says; one that rounds to zero has no
/// sign. Every constructor throws std::invalid_argument for what rounded() refuses, for a unit that
/// cannot be printed, and for a whole number beyond ±2^53. A number that is not finite is refused
/// where it is used, so that the message can name its key.
class Value {
 public:
  /// Prints a number that has no error bound, or gets one by within().
  Value(double number, const Format& format, std::string_view unit = "");
  template <std::integral Integer>
  Value(Integer number, const Format& format, std::string_view unit = "")
      : Value(double_of(number), format, unit) {}

  /// Prints a number with its error bound: no digit that the bound does not support.
  Value(numerics::Estimate estimate, const Format& format, std::string_view unit = "");

  /// Prints plain text, escaped for LaTeX.
  static Value text(std::string_view text);

  /// Returns the same value with a bound on its error, in the unit of number(), which for a
  /// percentage is the ratio. Throws std::invalid_argument, naming number, printed text and bound,
  /// if the last printed place is less than the bound, or, of a number that is rounded up, if
  /// number and bound together are more than what is printed. Also throws it for text, for a value
  /// that has a bound already, and for a bound that is negative or not finite.
  Value within(double abs_error) const;

  /// Throws std::invalid_argument for a number that is not finite.
  void require_finite() const;

  /// The value as LaTeX, such as `\qty{1.5e-6}{in}`, for text and math mode. Throws as
  /// require_finite does.
  const std::string& latex() const {
    require_finite();
    return latex_;
  }

  /// The value as plain text, such as "1.5e-6 in". Throws as require_finite does.
  const std::string& printed() const {
    require_finite();
    return printed_;
  }

  /// The unrounded number; none for text.
  const std::optional<double>& number() const { return number_; }

  /// The error bound that came with an estimate or from within(), if any.
  const std::optional<double>& abs_error() const { return abs_error_; }

  const std::string& unit() const { return unit_; }

  /// How the number is printed; none for text.
  const std::optional<Format>& format() const { return format_; }

  /// The power of ten of the last printed digit, in the unit of number(); 0 for text.
  int last_place() const { return last_place_; }

  /// Whether the number is a ratio that is printed in per cent.
  bool is_percentage() const { return format_ && format_->is_percentage(); }

 private:
  Value() = default;
  Value(double number, std::optional<double> abs_error, const Format& format,
        std::string_view unit);

  std::string latex_;
  std::string printed_;
  std::optional<double> number_;
  std::optional<double> abs_error_;
  std::optional<Format> format_;
  int last_place_ = 0;
  std::string unit_;
};

}  // namespace literate
