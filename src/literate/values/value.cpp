// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/values/value.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"
#include "literate/values/rounding.hpp"

namespace literate {
namespace {

bool declares_exact(const Format& format) {
  return format.notation() == Notation::exact || format.notation() == Notation::integer;
}

}  // namespace

Value::Value(double number, const std::optional<Number>& known, const Format& format,
             std::string_view unit)
    : number_(number), known_(known), format_(format), unit_(unit) {
  try {
    (void)rounded(format, number, known);
    if (plain_unit(unit).empty()) unit_.clear();
    if (format.is_percentage() && !unit_.empty()) {
      throw std::invalid_argument(fmt::format("a percentage has no other unit, such as {}", unit));
    }
  } catch (const std::invalid_argument& error) {
    problem_ = error.what();
  }
}

Value::Value(const Number& number, const Format& format, std::string_view unit)
    : Value(number.value, number, format, unit) {}

Value::Value(double number, const Format& format, std::string_view unit)
    : Value(number, declares_exact(format) ? std::optional(Number(number, 0)) : std::nullopt,
            format, unit) {}

Value Value::text(std::string_view text) {
  Value value;
  value.text_ = text;
  try {
    require_utf8(text);
  } catch (const std::invalid_argument& error) {
    value.problem_ = error.what();
  }
  return value;
}

Value Value::as_is() const {
  Value value = *this;
  value.is_as_is_ = true;
  if (is_text() || known_) value.problem_ = "as_is(): it is a text, or its error is known already";
  return value;
}

void Value::require_valid() const {
  if (!problem_.empty()) throw std::invalid_argument(problem_);
  if (is_text() || known_ || is_as_is_) return;
  throw std::invalid_argument(
      fmt::format("{} has no error: give its bound or standard uncertainty, or as_is if it is "
                  "unknown",
                  round_trip(number_)));
}

std::string Value::printed() const {
  if (is_text()) return text_;
  if (!problem_.empty()) throw std::invalid_argument(problem_);
  return plain_print(rounded(*format_, number_, known_), is_percentage() ? "%" : plain_unit(unit_));
}

std::string Value::latex() const {
  if (is_text()) return latex_escaped(text_);
  if (!problem_.empty()) throw std::invalid_argument(problem_);
  return latex_print(rounded(*format_, number_, known_),
                     is_percentage() ? "\\%" : latex_unit(unit_));
}

Value Value::formatted(const Format& format) const {
  Value value(number_, known_, format, unit_);
  value.is_as_is_ = is_as_is_;
  return value;
}

int Value::n_earned_digits() const {
  return is_text() ? 0 : literate::n_earned_digits(*format_, number_, known_);
}

}  // namespace literate
