// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/values/value.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"

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

Value Value::within(double abs_error) const {
  require_error_bound(abs_error);
  if (!number_ || abs_error_) {
    throw std::invalid_argument(fmt::format(
        "'{}' {}", printed_,
        number_ ? "has an error bound already" : "is text and can have no error bound"));
  }
  if (!std::isfinite(*number_)) {
    // It is refused where it is used.
  } else if (format_->rounds_up()) {
    const Value bound(*number_, abs_error, *format_, unit_);
    if (bound.printed_ != printed_) {
      throw std::invalid_argument(
          fmt::format("{} is printed as '{}', but with an error of {} it is at most {}", *number_,
                      printed_, abs_error, bound.printed_));
    }
  } else {
    require_earned(*number_, last_place_, abs_error, printed_);
  }
  Value value = *this;
  value.abs_error_ = abs_error;
  return value;
}

}  // namespace literate
