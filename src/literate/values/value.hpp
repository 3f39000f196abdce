// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include "literate/values/format.hpp"
#include "literate/values/number.hpp"

namespace literate {

/// A number with its format and unit, or a text, as the document prints it:
///
///     Value(Estimate{2.0064, 3e-4}, significant(4), "s")   a computed number with its bound
///     Value({79.4, 0, 0.3}, uncertain(), "V")              {value, bound, standard uncertainty}
///     Value(0.25, exact(), "m")                            a parameter
///     Value(n_nodes, integer())                            a count
///     Value(2.9, significant(2), "s").within(0.1)          a bare number and its bound
///     Value(residual, scientific(1)).as_is()               a number that is printed as it came
///
/// Units are spelt as literate/text/unit.hpp says; a percentage has none. What a value's format
/// refuses, as rounded() does, is reported where the value is used, with its key: by
/// Document::value and by the criteria.
class Value {
 public:
  Value(const Number& number, const Format& format, std::string_view unit = "");
  /// A bare number: exact() and integer() declare that it is exact, and for any other format
  /// within() or as_is() has to say what is known of it.
  Value(double number, const Format& format, std::string_view unit = "");
  template <std::integral Integer>
  Value(Integer number, const Format& format, std::string_view unit = "")
      : Value(static_cast<double>(number), format, unit) {}

  /// A plain text, which is escaped for LaTeX.
  static Value text(std::string_view text);

  /// The same bare number with a bound on its error, in the unit of the number, which for a
  /// percentage is the ratio.
  Value within(double bound) const;

  /// The same bare number, printed as it came and with no claim on its error: a residual, a margin,
  /// a bound that a formula gave. A criterion takes it as it is.
  Value as_is() const;

  /// Throws std::invalid_argument with what is wrong with this value: what its format refuses, a
  /// unit that UDUNITS-2 does not know, an error that nobody gave.
  void require_valid() const;

  bool is_text() const { return !format_; }
  bool is_as_is() const { return is_as_is_; }
  bool is_percentage() const { return format_ && format_->is_percentage(); }

  /// The unrounded number, in unit(); of a percentage the ratio, and of a text 0.
  double number() const { return number_; }
  /// The same with its uncertainty, if that is known.
  const std::optional<Number>& known() const { return known_; }
  /// Of values that are not texts.
  const Format& format() const { return *format_; }
  const std::string& unit() const { return unit_; }

  /// As plain text, «1.5e-6 in», and as LaTeX for text and math mode. Both throw as require_valid.
  std::string printed() const;
  std::string latex() const;

  /// The same number in a different format. Of values that are not texts.
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
  std::string problem_;  // found before the value had a key; require_valid() reports it
};

}  // namespace literate
