// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/values/value.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"
#include "literate/values/decimal.hpp"

namespace literate {

Value::Value(double number, std::optional<double> abs_error, const Format& format,
             std::string_view unit)
    : number_(number), abs_error_(abs_error), format_(format), unit_(unit) {
  const std::string unit_text = plain_unit(unit);
  if (unit_text.empty()) unit_.clear();
  if (format.is_percentage() && !unit_.empty()) {
    throw std::invalid_argument(fmt::format("a percentage has no other unit, such as '{}'", unit));
  }
  if (!std::isfinite(number)) return;
  const RoundedNumber digits = rounded(format, number, abs_error);
  last_place_ = digits.digits.place;
  // Multiplying by 100 would round twice; moving the point does not.
  std::string text = digits.text(format.is_percentage() ? -2 : 0);
  if (text.ends_with("e0")) text.resize(text.size() - 2);  // siunitx prints no such exponent
  if (format.is_percentage()) {
    latex_ = fmt::format("\\qty{{{}}}{{\\percent}}", text);
    printed_ = text + " %";
  } else if (unit_.empty()) {
    latex_ = fmt::format("\\num{{{}}}", text);
    printed_ = text;
  } else {
    latex_ = fmt::format("\\qty{{{}}}{{{}}}", text, latex_unit(unit));
    printed_ = fmt::format("{} {}", text, unit_text);
  }
}

Value::Value(double number, const Format& format, std::string_view unit)
    : Value(number, std::nullopt, format, unit) {}

Value::Value(numerics::Estimate estimate, const Format& format, std::string_view unit)
    : Value(estimate.value, estimate.abs_error, format, unit) {}

Value Value::text(std::string_view text) {
  Value value;
  value.latex_ = escape_latex(text);
  value.printed_ = text;
  return value;
}

void Value::require_finite() const {
  if (number_ && !std::isfinite(*number_)) {
    throw std::invalid_argument(fmt::format("{} is not finite", *number_));
  }
}

std::optional<double> Value::counted_error() const {
  if (abs_error_ || !number_) return abs_error_;
  const Notation notation = format_->notation();
  const bool is_exact = notation == Notation::exact || notation == Notation::integer;
  return is_exact || is_as_is_ ? std::optional(0.0) : std::nullopt;
}

void Value::require_error() const {
  if (!number_ || counted_error()) return;
  throw std::invalid_argument(
      fmt::format("{} comes without its error: give an Estimate or .within(error), or say .as_is() "
                  "of a number that is printed as it came",
                  round_trip(*number_)));
}

void Value::require_untold() const {
  if (!number_) {
    throw std::invalid_argument(fmt::format("'{}' is text and can have no error", printed_));
  }
  if (counted_error()) {
    throw std::invalid_argument(fmt::format("the error of '{}' is told already", printed_));
  }
}

Value Value::within(double abs_error) const {
  require_untold();
  if (abs_error == 0) {
    throw std::invalid_argument(fmt::format(
        "'{}' within 0: print an exact number by exact() or integer(), and say .as_is() "
        "of one that is printed as it came",
        printed_));
  }
  return {*number_, abs_error, *format_, unit_};
}

Value Value::as_is() const {
  require_untold();
  Value value = *this;
  value.is_as_is_ = true;
  return value;
}

}  // namespace literate
