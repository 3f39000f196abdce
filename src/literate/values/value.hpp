// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include "literate/values/format.hpp"
#include "numerics/measured.hpp"

namespace literate {

/// A value as the document prints it, with the unrounded number: Value(4.7e-3, significant(2),
/// "in").
///
/// Units are spelt as literate/text/unit.hpp says, such as "in", "lbf/in" or "m s-1"; a percentage
/// has none. Numbers are rounded as literate/values/format.hpp says; one that rounds to zero has no
/// sign. Every constructor throws std::invalid_argument for what rounded() refuses, for a unit that
/// cannot be printed. A number that is not finite and a whole number beyond ±2^53 are refused where
/// they are used, so that the message can name their key.
class Value {
 public:
  /// Prints a number whose error nobody has told yet. exact() and integer() say that it has none;
  /// of any other one Document::value and Criterion want to know it, by within() or as_is().
  Value(double number, const Format& format, std::string_view unit = "");
  template <std::integral Integer>
  Value(Integer number, const Format& format, std::string_view unit = "")
      : Value(static_cast<double>(number), format, unit) {
    not_held_ = not_held(number);
  }

  /// Prints a number with its error bound: no digit that the bound does not support.
  Value(numerics::Estimate estimate, const Format& format, std::string_view unit = "");

  /// Prints a number with its standard uncertainty: no digit that this and its bound, added, do not
  /// support. Throws InvalidQuantity as its arithmetic does.
  Value(const numerics::Measured& measured, const Format& format, std::string_view unit = "");

  /// The same of a number whose sources have lost their names.
  Value(double number, std::optional<Uncertainty> uncertainty, const Format& format,
        std::string_view unit);

  /// Prints plain text, escaped for LaTeX.
  static Value text(std::string_view text);

  /// Returns the same number with a bound on its error, in the unit of number(), which for a
  /// percentage is the ratio. It prints as an estimate does. Throws std::invalid_argument for text,
  /// for a number whose error is told already, for a bound that is 0, negative or not finite, and
  /// for what rounded() refuses.
  Value within(double abs_error) const;

  /// Returns the same value, printed as it came and with no claim on its error: a residual, a
  /// margin, a bound that a formula gave. A criterion takes the number as it stands. Throws
  /// std::invalid_argument for text and for a number whose error is told already.
  Value as_is() const;

  /// Throws std::invalid_argument for a number that is not finite, or whole and beyond ±2^53.
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

  /// What is not known of the number, which came with it or from within(), if any.
  const std::optional<Uncertainty>& uncertainty() const { return uncertainty_; }

  /// The number with the uncertainty that a criterion counts: none of a number that exact() or
  /// integer() prints or that stands as it is; nothing if nobody told it.
  std::optional<numerics::Measured> measured() const;

  /// Whether as_is() made it.
  bool is_as_is() const { return is_as_is_; }

  /// Throws std::invalid_argument for a number whose error nobody told.
  void require_error() const;

  const std::string& unit() const { return unit_; }

  /// How the number is printed; none for text.
  const std::optional<Format>& format() const { return format_; }

  /// The power of ten of the last printed digit, in the unit of number(); 0 for text.
  int last_place() const { return last_place_; }

  /// Whether the number is a ratio that is printed in per cent.
  bool is_percentage() const { return format_ && format_->is_percentage(); }

 private:
  Value() = default;
  bool is_told() const;
  void require_untold() const;

  std::string latex_;
  std::string printed_;
  std::string not_held_;  // a whole number that number_ may not be
  std::optional<double> number_;
  std::optional<Uncertainty> uncertainty_;
  std::optional<numerics::Measured> measured_;  // with the names of the sources, where it has any
  bool is_as_is_ = false;
  std::optional<Format> format_;
  int last_place_ = 0;
  std::string unit_;
};

}  // namespace literate
