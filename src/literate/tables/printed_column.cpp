// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/printed_column.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"

namespace literate {
namespace {

/// The intended decimal number if arithmetic left a rounding error: 0.3 for 3 · 0.1.
double meant(double number) {
  constexpr double noise = 4 * std::numeric_limits<double>::epsilon();
  constexpr int n_digits = 12;
  const double decimal = number_of(rounded_to_digits(number, n_digits));
  return std::abs(decimal - number) <= noise * std::abs(number) ? decimal : number;
}

/// The format with enough digits for a bare number of an exact column.
Format with_all_digits(const Format& format, double number, int ones) {
  const Decimal digits = shortest(number);
  if (format.notation() == Notation::fixed) {
    return fixed(std::max(format.digits(), ones - digits.place));
  }
  if (format.notation() == Notation::scientific) {
    return scientific(std::max(format.digits(), static_cast<int>(digits.digits.size())));
  }
  return format;
}

RoundedNumber rounded_in(const Format& format, bool is_exact, const Cell& cell, int exponent) {
  const double number = *cell.number();
  if (cell.place()) return quoted(format, number, *cell.place(), exponent);
  if (cell.known() || !is_exact || format.rounds_up()) {
    return rounded(format, number, cell.known(), exponent);
  }
  const double decimal = meant(number);
  const int ones = exponent + (format.is_percentage() ? -2 : 0);
  const Format all = with_all_digits(format, decimal, ones);
  return rounded(format.is_percentage() ? all.in_percent() : all, decimal, Number(decimal, 0),
                 exponent);
}

/// The power of ten of the largest magnitude after rounding to `n_digits` digits.
int largest_place(const std::vector<const Cell*>& cells, int n_digits) {
  std::optional<int> largest;
  for (const Cell* cell : cells) {
    if (cell->number() == nullptr || *cell->number() == 0) continue;
    const int place = leading_place(rounded_to_digits(*cell->number(), n_digits));
    largest = std::max(largest.value_or(place), place);
  }
  return largest.value_or(0);
}

std::string blank(const std::string& what) {
  return what.empty() ? "" : "\\hphantom{" + what + "}";
}

/// A blank as wide as the digits and separators by which `n` digits are shorter than `wanted`.
std::string blank_digits(std::size_t n, std::size_t wanted) {
  const auto n_separators = [](std::size_t digits) { return digits < 5 ? 0 : (digits - 1) / 3; };
  std::string separators;
  for (std::size_t i = n_separators(n); i < n_separators(wanted); ++i) separators += "\\,";
  return blank(std::string(wanted - n, '0')) + separators;
}

struct Digits {
  bool negative;
  std::string whole, decimals;
};

Digits digits_of(const RoundedNumber& number) {
  const std::string digits = number.digits.substr(number.digits.starts_with('-') ? 1 : 0);
  const auto point = digits.find('.');
  return {number.digits.starts_with('-'), digits.substr(0, point),
          point == digits.npos ? "" : digits.substr(point + 1)};
}

std::string error_of(const RoundedNumber& number) {
  const std::string standard = number.standard.empty() ? "" : "(" + number.standard + ")";
  return number.bound.empty() ? standard : standard + "\\pm " + number.bound;
}

}  // namespace

void require_printable(const Column& column, const Cell& cell) {
  if (cell.number() == nullptr) {
    if (cell.is_latex()) (void)author_latex(*cell.text());
    require_utf8(cell.given());
    return;
  }
  const std::string digits = round_trip(*cell.number());
  if (!column.numbers()) {
    throw std::invalid_argument(digits + " is a number in a column of texts");
  }
  if (!std::isfinite(*cell.number())) throw std::invalid_argument(digits + " is not finite");
  if (!cell.known() && !cell.place() && !column.is_exact()) {
    throw std::invalid_argument(
        digits +
        " has no error: give its bound or standard uncertainty, or declare the column exact");
  }
  (void)rounded_in(*column.numbers(), column.is_exact(), cell, column.exponent());
}

PrintedColumn::PrintedColumn(const Column& column, const std::vector<const Cell*>& cells)
    : column_(column), exponent_(column.exponent()) {
  std::optional<Format> format = column.numbers();
  if (format && format->notation() == Notation::significant) {
    // The format's digits are those of the largest number. Its power of ten goes into the head.
    constexpr int least_plain = -3;
    const int n_digits = format->digits();
    const int ones = format->is_percentage() ? -2 : 0;
    const int leading = largest_place(cells, n_digits) - ones;
    const bool is_plain = leading >= least_plain && leading < n_digits;
    exponent_ = is_plain ? 0 : leading;
    const Format decimals = fixed(n_digits - 1 - (is_plain ? leading : 0));
    format = format->is_percentage() ? decimals.in_percent() : decimals;
  }
  for (const Cell* cell : cells) {
    Printed printed;
    if (cell->number() != nullptr) {
      printed.number = rounded_in(*format, column.is_exact(), *cell, exponent_);
      const Width width = width_of(*printed.number);
      widest_.negative = widest_.negative || width.negative;
      widest_.n_whole = std::max(widest_.n_whole, width.n_whole);
      widest_.n_decimals = std::max(widest_.n_decimals, width.n_decimals);
      if (width.error.size() > widest_.error.size()) widest_.error = width.error;
      if (width.exponent.size() > widest_.exponent.size()) widest_.exponent = width.exponent;
    } else if (!cell->is_empty()) {
      printed.text = cell->is_latex() ? author_latex(*cell->text()) : *cell->text();
    }
    cells_.push_back(std::move(printed));
  }
}

PrintedColumn::Width PrintedColumn::width_of(const RoundedNumber& number) {
  const Digits digits = digits_of(number);
  return {digits.negative, digits.whole.size(), digits.decimals.size(), error_of(number),
          number.exponent ? fmt::format("{}", *number.exponent) : ""};
}

std::string PrintedColumn::specification() const {
  if (column_.numbers()) return "c";
  if (column_.width_cm() == 0) return "l";
  return fmt::format(">{{\\raggedright\\arraybackslash}}p{{{}cm}}", column_.width_cm());
}

std::string PrintedColumn::unit() const {
  const bool is_percentage = column_.numbers() && column_.numbers()->is_percentage();
  std::string unit = is_percentage ? "\\%" : latex_unit(column_.unit());
  if (exponent_ != 0) {
    unit = fmt::format("10^{{{}}}{}{}", exponent_, unit.empty() ? "" : "\\,", unit);
  }
  return unit.empty() ? "" : fmt::format("(${}$)", unit);
}

std::string PrintedColumn::aligned(const RoundedNumber& number) const {
  const Digits digits = digits_of(number);
  const Width width = width_of(number);
  const bool has_brackets = number.exponent && !number.bound.empty();
  std::string text = blank_digits(width.n_whole, widest_.n_whole);
  if (has_brackets) text += "(";
  // Braces tie the sign to the number. After a blank it would be a binary operator, with spaces.
  if (widest_.negative) text += digits.negative ? "{-}" : blank("-");
  text += grouped(digits.whole, false);
  if (!digits.decimals.empty()) text += "." + grouped(digits.decimals, true);
  text += width.error;
  if (has_brackets) text += ")";
  const auto power = [](const std::string& exponent) {
    return fmt::format("\\times10^{{{}}}", exponent);
  };
  if (number.exponent) text += power(width.exponent);

  // Room for the errors and exponents of other numbers.
  if (digits.decimals.empty() && widest_.n_decimals > 0) text += blank(".");
  text += blank_digits(width.n_decimals, widest_.n_decimals);
  if (width.error.size() < widest_.error.size()) {
    text += width.error.empty()
                ? blank(widest_.error)
                : blank(std::string(widest_.error.size() - width.error.size(), '0'));
  }
  if (width.exponent.empty() && !widest_.exponent.empty()) {
    text += blank("{}" + power(widest_.exponent));
  } else if (width.exponent.size() < widest_.exponent.size()) {
    const std::size_t n_missing = widest_.exponent.size() - width.exponent.size();
    text += blank(fmt::format("^{{{}}}", std::string(n_missing, '0')));
  }
  return fmt::format("${}$", text);
}

std::string PrintedColumn::cell(std::size_t row) const {
  const Printed& cell = cells_[row];
  return cell.number ? aligned(*cell.number) : cell.text;
}

std::string PrintedColumn::plain(std::size_t row) const {
  const Printed& cell = cells_[row];
  if (!cell.number) return cell.text;
  RoundedNumber number = *cell.number;
  const int exponent = number.exponent.value_or(0) + exponent_;
  const bool is_nothing =
      is_zero(number.decimal) && number.bound.empty() && number.standard.empty();
  number.exponent = exponent == 0 || is_nothing ? std::nullopt : std::optional(exponent);
  const bool is_percentage = column_.numbers() && column_.numbers()->is_percentage();
  return plain_print(number, is_percentage ? "%" : "");
}

}  // namespace literate
