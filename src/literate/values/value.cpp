// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/values/value.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"
#include "literate/values/decimal.hpp"

namespace literate {

namespace {

/// A number for readers and for LaTeX.
struct Print {
  std::string plain, latex;
};

/// With a unit as plain text and as siunitx takes it. siunitx prints no number that has two
/// uncertainties, nor words beside them.
Print print_of(const NumberPrint& number, const std::string& unit, const std::string& tex_unit) {
  const std::string space = unit.empty() ? "" : " ";
  const std::string text = number.text();
  if (number.beside.empty()) {
    return {text + space + unit, unit.empty() ? fmt::format("\\num{{{}}}", text)
                                              : fmt::format("\\qty{{{}}}{{{}}}", text, tex_unit)};
  }
  Print print{number.number, fmt::format("\\num{{{}}}", number.number)};
  for (const auto& [beside, what, sign] : number.beside) {
    const bool is_to_both = sign == "±";
    print.plain += (is_to_both ? " ± " : " " + sign) + beside;
    print.latex += fmt::format(fmt::runtime(is_to_both    ? "\\pm\\num{{{}}}"
                                            : sign == "+" ? "^{{+\\num{{{}}}}}"
                                                          : "_{{-\\num{{{}}}}}"),
                               beside);
    if (what.empty()) continue;
    print.plain += fmt::format(" ({})", what);
    print.latex += fmt::format("\\text{{ ({})}}", escape_latex(what));
  }
  if (!number.exponent.empty() || !unit.empty()) {
    print = {fmt::format("({})", print.plain), fmt::format("({})", print.latex)};
  }
  if (!number.exponent.empty()) {
    print.plain += "e" + number.exponent;
    print.latex += fmt::format("\\times\\num{{e{}}}", number.exponent);
  }
  if (!unit.empty()) print.latex += fmt::format("\\,\\unit{{{}}}", tex_unit);
  return {print.plain + space + unit, fmt::format("\\ensuremath{{{}}}", print.latex)};
}

}  // namespace

Value::Value(double number, std::optional<Uncertainty> uncertainty, const Format& format,
             std::string_view unit)
    : number_(number), uncertainty_(std::move(uncertainty)), format_(format), unit_(unit) {
  const std::string unit_text = plain_unit(unit);
  if (unit_text.empty()) unit_.clear();
  if (format.is_percentage() && !unit_.empty()) {
    throw std::invalid_argument(fmt::format("a percentage has no other unit, such as '{}'", unit));
  }
  if (!std::isfinite(number)) return;
  const RoundedNumber digits = rounded(format, number, uncertainty_);
  last_place_ = digits.digits.place;
  // Multiplying by 100 would round twice; moving the point does not.
  NumberPrint printed = digits.printed(format.is_percentage() ? -2 : 0);
  if (printed.exponent == "0") printed.exponent.clear();  // siunitx prints no such exponent
  const Print print = format.is_percentage() ? print_of(printed, "%", "\\percent")
                                             : print_of(printed, unit_text, latex_unit(unit_));
  latex_ = print.latex;
  printed_ = print.plain;
}

Value::Value(double number, const Format& format, std::string_view unit)
    : Value(number, std::nullopt, format, unit) {}

Value::Value(numerics::Estimate estimate, const Format& format, std::string_view unit)
    : Value(estimate.value, Uncertainty(estimate.abs_error), format, unit) {}

Value::Value(const numerics::Measured& measured, const Format& format, std::string_view unit)
    : Value(measured.value(), Uncertainty(measured), format, unit) {
  measured_ = measured;
}

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
  require_held(not_held_, "Value::text");
  if (number_ && format_ && format_->notation() == Notation::integer &&
      std::abs(*number_) >= 0x1p53) {
    throw std::invalid_argument(fmt::format(
        "{} may be the rounding of another integer, as any number from 2^53 on", *number_));
  }
}

bool Value::is_told() const {
  if (uncertainty_ || is_as_is_) return true;
  const Notation notation = format_->notation();
  return notation == Notation::exact || notation == Notation::integer;
}

std::optional<numerics::Measured> Value::measured() const {
  if (measured_ || !number_ || !is_told()) return measured_;
  const Uncertainty uncertainty = uncertainty_.value_or(0);
  numerics::Measured measured = numerics::Measured::bounded({*number_, uncertainty.bound});
  for (const auto& [kind, standard] : uncertainty.kinds) {
    measured = measured + numerics::Measured(0, standard, kind);
  }
  return measured;
}

void Value::require_error() const {
  if (!number_ || is_told()) return;
  throw std::invalid_argument(
      fmt::format("{} comes without its error: give an Estimate or .within(error), or say .as_is() "
                  "of a number that is printed as it came",
                  round_trip(*number_)));
}

void Value::require_untold() const {
  if (!number_) {
    throw std::invalid_argument(fmt::format("'{}' is text and can have no error", printed_));
  }
  if (is_told()) {
    throw std::invalid_argument(
        fmt::format("the error of {} is told already", round_trip(*number_)));
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
  return {*number_, Uncertainty(abs_error), *format_, unit_};
}

Value Value::as_is() const {
  require_untold();
  Value value = *this;
  value.is_as_is_ = true;
  return value;
}

}  // namespace literate
