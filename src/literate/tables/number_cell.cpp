// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/number_cell.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>

namespace literate {
namespace {

constexpr std::string_view plus_minus = "±";

struct Parts {
  bool negative = false;
  std::string_view whole;
  std::string_view decimals;
  std::string_view uncertainty;  // «(12)», «±0.012», «(12)±3»
  bool negative_exponent = false;
  std::string_view exponent;
};

bool remove_minus(std::string_view& text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative) text.remove_prefix(1);
  return is_negative;
}

Parts parts_of(std::string_view number) {
  Parts parts;
  parts.negative = remove_minus(number);
  if (const auto e = number.find('e'); e != number.npos) {
    parts.exponent = number.substr(e + 1);
    parts.negative_exponent = remove_minus(parts.exponent);
    number = number.substr(0, e);
  }
  if (const auto begin = std::min({number.find('('), number.find(plus_minus), number.find('+')});
      begin != number.npos) {
    parts.uncertainty = number.substr(begin);
    number = number.substr(0, begin);
  }
  const auto point = number.find('.');
  parts.whole = number.substr(0, point);
  if (point != number.npos) parts.decimals = number.substr(point + 1);
  return parts;
}

constexpr std::size_t smallest_grouped = 5;

std::size_t n_separators(std::size_t n_digits) {
  return n_digits < smallest_grouped ? 0 : (n_digits - 1) / 3;
}

/// Puts a thin space after every third digit, counted from the decimal point.
std::string grouped(std::string_view digits, bool point_is_left,
                    std::string_view separator = "\\,") {
  if (digits.size() < smallest_grouped) return std::string(digits);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::size_t from_point = point_is_left ? i : digits.size() - i;
    if (i > 0 && from_point % 3 == 0) text += separator;
    text += digits[i];
  }
  return text;
}

/// The same with the digits behind ± in groups, and the sign as it is to be written.
std::string uncertainty_of(std::string_view text, std::string_view sign,
                           std::string_view separator) {
  const auto begin = text.find(plus_minus);
  std::string written(text.substr(0, begin));
  if (begin == text.npos) return written;
  const std::string_view number = text.substr(begin + plus_minus.size());
  const auto point = number.find('.');
  written += sign;
  written += grouped(number.substr(0, point), false, separator);
  if (point != number.npos) {
    written += ".";
    written += grouped(number.substr(point + 1), true, separator);
  }
  return written;
}

/// Whether a power of ten has to be told from what is behind a sign.
bool has_sign(std::string_view uncertainty) {
  return uncertainty.starts_with('+') || uncertainty.find(plus_minus) != uncertainty.npos;
}

std::string uncertainty_latex(std::string_view text) {
  if (text.starts_with('+')) {
    constexpr std::string_view minus = "−";
    const auto at = text.find(minus);
    return fmt::format("^{{+{}}}_{{-{}}}", text.substr(1, at - 1), text.substr(at + minus.size()));
  }
  return uncertainty_of(text, "\\pm ", "\\,");
}

std::string blank(const std::string& what) {
  return what.empty() ? "" : "\\hphantom{" + what + "}";
}

/// A blank as wide as the digits and separators that `has` digits lack to make `wanted`.
std::string blank_digits(std::size_t has, std::size_t wanted) {
  std::string separators;
  for (std::size_t i = n_separators(has); i < n_separators(wanted); ++i) separators += "\\,";
  return blank(std::string(wanted - has, '0')) + separators;
}

std::string power_of_ten(const Parts& parts, const NumberWidth& column) {
  const std::string missing =
      blank((column.negative_exponent && !parts.negative_exponent ? "-" : "") +
            std::string(column.n_exponent - parts.exponent.size(), '0'));
  return fmt::format("\\times10^{{{}{}{}}}", parts.negative_exponent ? "-" : "", parts.exponent,
                     missing);
}

}  // namespace

NumberWidth width_of(std::string_view number) {
  const Parts parts = parts_of(number);
  return {parts.negative,          parts.whole.size(),    parts.decimals.size(),
          parts.negative_exponent, parts.exponent.size(), std::string(parts.uncertainty)};
}

NumberWidth widest(const NumberWidth& a, const NumberWidth& b) {
  return {a.negative || b.negative,
          std::max(a.n_whole, b.n_whole),
          std::max(a.n_decimals, b.n_decimals),
          a.negative_exponent || b.negative_exponent,
          std::max(a.n_exponent, b.n_exponent),
          a.uncertainty.size() < b.uncertainty.size() ? b.uncertainty : a.uncertainty};
}

std::string table_format(const NumberWidth& width) {
  std::string format = fmt::format("{}{}", width.negative ? "-" : "", width.n_whole);
  if (width.n_decimals > 0) format += fmt::format(".{}", width.n_decimals);
  if (width.n_exponent > 0) {
    format += fmt::format("e{}{}", width.negative_exponent ? "-" : "", width.n_exponent);
  }
  return format;
}

std::string aligned_number(std::string_view number, const NumberWidth& column,
                           std::string_view mark) {
  const Parts parts = parts_of(number);
  const bool has_exponent = !parts.exponent.empty();
  std::string text = blank_digits(parts.whole.size(), column.n_whole);
  // What is behind ± belongs with its number into brackets before a power of ten.
  const bool has_brackets = has_exponent && has_sign(parts.uncertainty);
  if (has_brackets) text += "(";
  // In braces the sign belongs to the number; behind a blank it would be an operator, with spaces.
  if (column.negative) text += parts.negative ? "{-}" : blank("-");
  text += grouped(parts.whole, false);
  if (!parts.decimals.empty()) text += "." + grouped(parts.decimals, true);
  text += uncertainty_latex(parts.uncertainty);
  if (has_brackets) text += ")";
  // The power of ten follows its digits at once, so that no hole is left where others have
  // decimals.
  if (has_exponent) text += power_of_ten(parts, column);
  text += mark;

  if (parts.decimals.empty() && column.n_decimals > 0) text += blank(".");
  text += blank_digits(parts.decimals.size(), column.n_decimals);
  if (parts.uncertainty.empty()) {
    text += blank(uncertainty_latex(column.uncertainty));
  } else if (parts.uncertainty.size() < column.uncertainty.size()) {
    text += blank(std::string(column.uncertainty.size() - parts.uncertainty.size(), '0'));
  }

  if (has_exponent || column.n_exponent == 0) return text;
  Parts wide;
  const std::string digits(column.n_exponent, '0');
  wide.exponent = digits;
  return text + blank("{}" + power_of_ten(wide, column));
}

std::string number_html(std::string_view number, const NumberWidth& column, std::string_view mark) {
  constexpr std::string_view thin = "\u202F", digit = "\u2007", point = "\u2008";
  const Parts parts = parts_of(number);
  const bool has_brackets = !parts.exponent.empty() && has_sign(parts.uncertainty);
  std::string text = (has_brackets ? "(" : "") + std::string(parts.negative ? "−" : "") +
                     grouped(parts.whole, false, thin);
  if (!parts.decimals.empty()) text += "." + grouped(parts.decimals, true, thin);
  text += parts.uncertainty.starts_with('+')
              ? " " + boost::replace_first_copy(std::string(parts.uncertainty), "−", " −")
              : uncertainty_of(parts.uncertainty, " ± ", thin);
  if (has_brackets) text += ")";
  if (!parts.exponent.empty()) {
    text += fmt::format(" × 10<sup>{}{}</sup>", parts.negative_exponent ? "−" : "", parts.exponent);
  }
  text += mark;
  if (!parts.exponent.empty()) return text;
  if (parts.decimals.empty() && column.n_decimals > 0) text += point;
  const std::size_t n = column.n_decimals - parts.decimals.size() +
                        (parts.uncertainty.empty() ? column.uncertainty.size() : 0);
  for (std::size_t i = 0; i < n; ++i) text += digit;
  const std::size_t n_thin = n_separators(column.n_decimals) - n_separators(parts.decimals.size());
  for (std::size_t i = 0; i < n_thin; ++i) text += thin;
  return text;
}

}  // namespace literate
