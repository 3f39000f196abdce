// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/column_writer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"

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

/// An uncertainty with the digits behind ± in groups, and the sign as it is to be written.
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

std::string grouped(std::string_view digits, bool point_is_left, std::string_view separator) {
  if (digits.size() < smallest_grouped) return std::string(digits);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::size_t from_point = point_is_left ? i : digits.size() - i;
    if (i > 0 && from_point % 3 == 0) text += separator;
    text += digits[i];
  }
  return text;
}

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
  const auto shown = [thin](std::string_view uncertainty) {
    return uncertainty.starts_with('+')
               ? " " + boost::replace_first_copy(std::string(uncertainty), "−", " −")
               : uncertainty_of(uncertainty, " ± ", thin);
  };
  // Where uncertainties of a column are of different widths, the browser gives each that of the
  // widest.
  if (!parts.uncertainty.empty() && parts.uncertainty.size() < column.uncertainty.size() &&
      parts.exponent.empty()) {
    text += fmt::format("<span class=\"lit-uncertain\" data-widest=\"{}\"><span>{}</span></span>",
                        shown(column.uncertainty), shown(parts.uncertainty));
  } else {
    text += shown(parts.uncertainty);
  }
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

namespace {

/// The power of ten of the largest magnitude after rounding to `n_digits` digits, or of the largest
/// error if that is larger.
int common_exponent_of(const std::vector<const Cell*>& cells, int n_digits) {
  std::optional<int> largest;
  const auto consider = [&](int place) { largest = std::max(largest.value_or(place), place); };
  for (const Cell* cell : cells) {
    const double* number = cell->number();
    if (number == nullptr) continue;
    if (*number != 0) consider(leading_place(rounded_to_digits(*number, n_digits)));
    if (const auto place = least_earned_place(cell->error())) consider(*place);
  }
  return largest.value_or(0);
}

/// All digits of a number, down to `place` at least. Where it is one of twelve digits but for what
/// the arithmetic of a grid left of it, these are meant: 0.3 for 3 · 0.1.
Decimal all_digits(double number, int place) {
  if (number == 0) return rounded_to_place(number, place);
  constexpr double noise = 4 * std::numeric_limits<double>::epsilon();
  constexpr int n_meant = 12;
  const double meant = number_of(rounded_to_digits(number, n_meant));
  Decimal digits = shortest(std::abs(meant - number) <= noise * std::abs(number) ? meant : number);
  for (; digits.place > place; --digits.place) digits.digits += '0';
  return digits;
}

/// The number of a cell with the digits that the column asks for. Its exponent is known.
RoundedNumber with_digits_of(const ColumnFormat& column, const Cell& cell) {
  const double number = *cell.number();
  const Format& format = *column.numbers;
  if (cell.place()) {
    RoundedNumber quoted = rounded_at(number, cell.uncertainty(), *cell.place());
    const bool has_exponent = format.notation() == Notation::scientific;
    if (has_exponent) quoted.style = RoundedNumber::Style::with_exponent;
    return quoted;
  }
  if (format.notation() == Notation::fixed && !format.rounds_up()) {
    // Moving the decimal point is exact, so the number is rounded only once; dividing it would
    // round it again.
    const int ones = column.exponent + (format.is_percentage() ? -2 : 0);
    return rounded_at(number, cell.uncertainty(), ones - format.digits(), ones);
  }
  return rounded(format, number, cell.uncertainty());
}

/// The number of a cell as the column prints it: an exact one is not rounded.
RoundedNumber rounded_in(const ColumnFormat& column, const Cell& cell) {
  RoundedNumber rounded = with_digits_of(column, cell);
  const bool is_exact = column.is_exact && !cell.uncertainty() && !cell.place();
  if (is_exact && !column.numbers->rounds_up()) {
    rounded.digits = all_digits(*cell.number(), rounded.digits.place);
  }
  return rounded;
}

std::string text_of(const ColumnFormat& column, const RoundedNumber& number) {
  const int of_percentage = column.numbers->is_percentage() ? -2 : 0;
  return number.printed(column.exponent + of_percentage).text();
}

}  // namespace

void require_printable(const ColumnFormat& column, const Cell& cell) {
  const double* number = cell.number();
  if (number == nullptr) return;
  const std::string digits = round_trip(*number);
  if (!column.numbers) throw std::invalid_argument(digits + " is a number in a column of texts");
  if (!std::isfinite(*number)) throw std::invalid_argument(digits + " is not finite");
  require_held(cell.beyond_doubles(), "Cell");
  if (cell.uncertainty()) {
    require_error_bound(cell.uncertainty()->bound);
  } else if (!cell.place() && !column.is_exact) {
    throw std::invalid_argument(
        digits + " comes without its error: give an Estimate, or declare the column exact");
  }
  (void)rounded_in(column, cell);  // throws for what the format refuses
}

ColumnWriter::ColumnWriter(ColumnFormat format, const std::vector<const Cell*>& cells)
    : format_(std::move(format)) {
  const auto& numbers = format_.numbers;
  if (numbers && numbers->notation() == Notation::significant) {
    const int n_digits = numbers->digits();
    format_.exponent = common_exponent_of(cells, n_digits);
    // One of them stands before the point; of a percentage the exponent is that of the ratio.
    const bool is_percentage = numbers->is_percentage();
    format_.numbers = fixed(n_digits - 1);
    if (is_percentage) {
      format_.exponent += 2;
      format_.numbers = fixed(n_digits - 1).in_percent();
    }
  }
  for (const Cell* cell : cells) cells_.push_back(written(*cell));
}

std::string ColumnWriter::specification() const {
  if (format_.width_cm > 0) return fmt::format(">{{\\LiterateLines}}p{{{}cm}}", format_.width_cm);
  return format_.numbers ? "c" : "l";
}

std::string ColumnWriter::cell(std::size_t row) const {
  const Written& cell = cells_[row];
  // A mark takes no width, so that the decimal points stay below one another.
  const std::string mark =
      cell.mark.empty() ? "" : fmt::format("\\LiterateMark{{{}}}", escape_latex(cell.mark));
  if (!cell.is_number) return cell.text + mark;
  return fmt::format("${}$", aligned_number(cell.text, width_, mark));
}

std::string ColumnWriter::cell_html(std::size_t row) const {
  const Written& cell = cells_[row];
  const std::string mark =
      cell.mark.empty() ? "" : "<sup class=\"lit-mark\">" + cell.mark + "</sup>";
  if (cell.is_number) {
    return fmt::format("<td class=\"lit-numeric\">{}</td>", number_html(cell.text, width_, mark));
  }
  return fmt::format("<td{}><tex>{}</tex>{}</td>", html_class(), cell.text, mark);
}

std::string ColumnWriter::html_class() const {
  if (!format_.numbers) return "";
  const bool has_numbers = std::ranges::any_of(cells_, &Written::is_number);
  return has_numbers ? " class=\"lit-flush\"" : " class=\"lit-middle\"";
}

std::string ColumnWriter::heading() const {
  return format_.heading;
}

std::string ColumnWriter::printed(std::size_t row) const {
  const Written& cell = cells_[row];
  const bool is_zero = cell.text.find_first_of("123456789") == std::string::npos;
  if (!cell.is_number || is_zero || format_.exponent == 0) return cell.text;
  return fmt::format("{}e{}", cell.text, format_.exponent);
}

std::string ColumnWriter::unit() const {
  const bool is_percentage = format_.numbers && format_.numbers->is_percentage();
  const std::string unit = is_percentage ? "\\percent" : latex_unit(format_.unit);
  if (format_.exponent == 0) return unit.empty() ? "" : fmt::format("(\\unit{{{}}})", unit);
  if (unit.empty()) return fmt::format("(\\num{{e{}}})", format_.exponent);
  return fmt::format("(\\qty{{e{}}}{{{}}})", format_.exponent, unit);
}

ColumnWriter::Written ColumnWriter::written(const Cell& cell) {
  if (cell.is_empty()) return {"", cell.mark()};
  if (cell.text()) return {*cell.text(), cell.mark()};
  const std::string number = text_of(format_, rounded_in(format_, cell));
  width_ = widest(width_, width_of(number));
  return {number, cell.mark(), true};
}

}  // namespace literate
