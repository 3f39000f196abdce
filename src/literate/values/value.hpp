// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include "literate/values/format.hpp"

namespace literate {

/// A number with its format and unit, or a text:
///
///     Value(Estimate{2.0064, 3e-4}, significant(4), "s")   a computed number with its bound
///     Value({79.4, 0, 0.3}, uncertain(), "V")              {value, bound, standard uncertainty}
///     Value(0.25, exact(), "m")                            a parameter
///     Value(n_nodes, integer())                            a count
///     Value(residual, scientific(1)).as_is()               a number of unknown error
///
/// literate/text/unit.hpp describes units; a percentage has none. Constructors do not throw:
/// Document::value and the criteria report an invalid value, with its key.
class Value {
 public:
  Value(const Number& number, const Format& format, std::string_view unit = "");
  /// A bare number. The formats exact() and integer() declare it exact; any other needs as_is().
  Value(double number, const Format& format, std::string_view unit = "");
  template <std::integral Integer>
  Value(Integer number, const Format& format, std::string_view unit = "")
      : Value(static_cast<double>(number), format, unit) {}

  /// A plain text, which is escaped for LaTeX.
  static Value text(std::string_view text);

  /// Returns this bare number without an error, for numbers such as a residual, a margin, or a
  /// bound from a formula. It is printed with all digits of its format, and criteria take it as
  /// exact.
  Value as_is() const;

  /// Throws std::invalid_argument for a value that its format refuses, a unit that UDUNITS-2 does
  /// not know, and a missing error.
  void require_valid() const;

  bool is_text() const { return !format_; }
  bool is_as_is() const { return is_as_is_; }
  bool is_percentage() const { return format_ && format_->is_percentage(); }

  /// The unrounded number, in unit(); for a percentage the ratio, for a text 0.
  double number() const { return number_; }
  /// The number with its errors, if they are known.
  const std::optional<Number>& known() const { return known_; }
  /// Not for texts.
  const Format& format() const { return *format_; }
  const std::string& unit() const { return unit_; }

  /// The value as plain text, «1.5e-6 in», and as LaTeX for text and math mode. Both throw as
  /// require_valid() does.
  std::string printed() const;
  std::string latex() const;

  /// Returns the same number in a different format. Not for texts.
  Value formatted(const Format& format) const;

  /// How many significant digits are earned; 0 for a text.
  int n_earned_digits() const;

 private:
  Value() = default;
  Value(double number, const std::optional<Number>& known, const Format& format,
        std::string_view unit);

  double number_ = 0;
  std::optional<Number> known_ = {};
  bool is_as_is_ = false;
  std::optional<Format> format_ = {};
  std::string unit_;
  std::string text_;
  std::string problem_;  // require_valid() reports it
};

}  // namespace literate
