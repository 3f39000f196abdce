// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/column_writer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"

namespace literate {
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
    const bool has_exponent = format.notation() == Notation::scientific;
    return {rounded_to_place(number, *cell.place()),
            has_exponent ? RoundedNumber::Style::with_exponent : RoundedNumber::Style::plain,
            cell.error() > 0};
  }
  if (format.notation() == Notation::fixed && !format.rounds_up()) {
    // Moving the decimal point is exact, so the number is rounded only once; dividing it would
    // round it again.
    const int of_percentage = format.is_percentage() ? -2 : 0;
    return rounded_at(number, cell.uncertainty(),
                      column.exponent + of_percentage - format.digits());
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
  const std::string aligned = aligned_number(cell.text, width_, mark);
  const std::string format = table_format(width_);
  return mark.empty() ? fmt::format("\\LiterateCell{{{}}}{{{}}}{{{}}}", format, cell.text, aligned)
                      : fmt::format("\\LiterateMarkedCell{{{}}}{{{}}}{{{}}}{{{}}}", format,
                                    cell.text, aligned, mark);
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
