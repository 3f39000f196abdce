// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/tables/table.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"
#include "literate/values/decimal.hpp"
#include "literate/values/rounding.hpp"
#include "system/text.hpp"

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

/// The parts of a printed number that are aligned.
struct Parts {
  bool is_negative = false;
  std::string whole, decimals;
  std::string error;     ///< «(22)», «\pm 0.012» or both
  std::string exponent;  ///< «-6»
};

Parts parts_of(const RoundedNumber& number) {
  Parts parts;
  parts.is_negative = number.digits.starts_with('-');
  const std::string digits = number.digits.substr(parts.is_negative ? 1 : 0);
  const auto point = digits.find('.');
  parts.whole = digits.substr(0, point);
  if (point != digits.npos) parts.decimals = digits.substr(point + 1);
  if (!number.standard.empty()) parts.error = "(" + number.standard + ")";
  if (!number.bound.empty()) parts.error += "\\pm " + number.bound;
  if (number.exponent) parts.exponent = std::to_string(*number.exponent);
  return parts;
}

/// Throws std::invalid_argument if the column cannot print the cell: for a number that is not
/// finite, a bare number in a column that is not exact, a number in a column of texts, and whatever
/// the column's format refuses.
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

/// Prints one column of a table, all of whose cells must be printable.
class PrintedColumn {
 public:
  PrintedColumn(const Column& column, const std::vector<const Cell*>& cells);

  /// The column's type in a tabular: l, p{4.5cm} or c.
  std::string specification() const;

  const std::string& heading() const { return column_.heading(); }
  const std::string& group() const { return column_.group(); }

  /// The unit in parentheses with the common power of ten, as LaTeX; empty without both.
  std::string unit() const;

  /// A cell as LaTeX. Numbers are padded with spaces to the same width, so that their decimal
  /// points align in a centred column.
  std::string cell(std::size_t row) const;

  /// A cell as plain text; a number includes the power of ten of the head.
  std::string plain(std::size_t row) const;

 private:
  struct Printed {
    std::string text;  ///< of a cell without a number
    std::optional<RoundedNumber> number;
  };

  std::string aligned(const RoundedNumber& number) const;

  Column column_;
  int exponent_;  // of the head
  std::vector<Printed> cells_;
  Parts widest_;  // the longest of each part
};

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
      const Parts parts = parts_of(*printed.number);
      widest_.is_negative = widest_.is_negative || parts.is_negative;
      for (const auto part : {&Parts::whole, &Parts::decimals, &Parts::error, &Parts::exponent}) {
        if ((parts.*part).size() > (widest_.*part).size()) widest_.*part = parts.*part;
      }
    } else if (!cell->is_empty()) {
      printed.text = cell->is_latex() ? author_latex(*cell->text()) : *cell->text();
    }
    cells_.push_back(std::move(printed));
  }
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
  const Parts parts = parts_of(number);
  const bool has_brackets = number.exponent && !number.bound.empty();
  std::string text = blank_digits(parts.whole.size(), widest_.whole.size());
  if (has_brackets) text += "(";
  // Braces tie the sign to the number. After a blank it would be a binary operator, with spaces.
  if (widest_.is_negative) text += parts.is_negative ? "{-}" : blank("-");
  text += grouped(parts.whole, false);
  if (!parts.decimals.empty()) text += "." + grouped(parts.decimals, true);
  text += parts.error;
  if (has_brackets) text += ")";
  const auto power = [](const std::string& exponent) {
    return fmt::format("\\times10^{{{}}}", exponent);
  };
  if (number.exponent) text += power(parts.exponent);

  // Room for the errors and exponents of other numbers.
  if (parts.decimals.empty() && !widest_.decimals.empty()) text += blank(".");
  text += blank_digits(parts.decimals.size(), widest_.decimals.size());
  if (parts.error.size() < widest_.error.size()) {
    text += parts.error.empty()
                ? blank(widest_.error)
                : blank(std::string(widest_.error.size() - parts.error.size(), '0'));
  }
  if (parts.exponent.empty() && !widest_.exponent.empty()) {
    text += blank("{}" + power(widest_.exponent));
  } else if (parts.exponent.size() < widest_.exponent.size()) {
    const std::size_t n_missing = widest_.exponent.size() - parts.exponent.size();
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

using Columns = std::vector<PrintedColumn>;

Columns printed_columns(const Table& table) {
  Columns columns;
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    std::vector<const Cell*> cells;
    for (const auto& row : table.rows()) cells.push_back(&row[i]);
    columns.emplace_back(table.columns()[i], cells);
  }
  return columns;
}

/// One line of the tabular. The empty group in front keeps LaTeX from reading a cell that begins
/// with [ or * as an argument of the rule or the \\ before it.
template <typename CellText>
std::string line(const Columns& columns, CellText&& text) {
  std::vector<std::string> cells;
  for (const PrintedColumn& column : columns) cells.push_back(text(column));
  return fmt::format("  {{}}{} \\\\\n", fmt::join(cells, " & "));
}

/// The headings that span several columns, each with a rule below it; empty if there are none.
std::string spanning_headings(const Columns& columns) {
  std::vector<std::string> cells, rules;
  for (std::size_t first = 0; first < columns.size();) {
    const std::string& group = columns[first].group();
    std::size_t end = first + 1;
    while (!group.empty() && end < columns.size() && columns[end].group() == group) ++end;
    if (group.empty()) {
      cells.emplace_back();
    } else {
      cells.push_back(fmt::format("\\multicolumn{{{}}}{{c}}{{{}}}", end - first, group));
      rules.push_back(fmt::format("\\cmidrule(lr){{{}-{}}}", first + 1, end));
    }
    first = end;
  }
  if (rules.empty()) return "";
  return fmt::format("  {} \\\\\n  {}\n", fmt::join(cells, " & "), fmt::join(rules, " "));
}

std::string head(const Columns& columns) {
  std::string text = spanning_headings(columns);
  text += line(columns, [](const PrintedColumn& column) { return column.heading(); });
  const auto has_unit = [](const PrintedColumn& column) { return !column.unit().empty(); };
  if (std::ranges::any_of(columns, has_unit)) {
    text += line(columns, [](const PrintedColumn& column) { return column.unit(); });
  }
  return text;
}

}  // namespace

Table::Table(std::string name, std::vector<Column> columns, const Place& place)
    : name_(std::move(name)), columns_(std::move(columns)) {
  if (columns_.empty()) fail_at(place, fmt::format("table '{}' has no column", name_));
}

Table& Table::add_row(std::vector<Cell> cells, const Place& place) {
  const std::string row = fmt::format("table '{}', row {}", name_, rows_.size() + 1);
  if (cells.size() != columns_.size()) {
    fail_at(place, fmt::format("{}: {} cells for {} columns", row, cells.size(), columns_.size()));
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    try {
      require_printable(columns_[i], cells[i]);
    } catch (const std::invalid_argument& error) {
      fail_at(place, fmt::format("{}, column {} '{}': {}", row, i + 1, columns_[i].heading(),
                                 error.what()));
    }
  }
  rows_.push_back(std::move(cells));
  return *this;
}

Table& Table::note(std::string text, const Place& place) {
  try {
    notes_.push_back(author_latex(text));
  } catch (const std::invalid_argument& error) {
    fail_at(place, fmt::format("table '{}', note: {}", name_, error.what()));
  }
  return *this;
}

std::string Table::latex() const {
  const Columns columns = printed_columns(*this);
  std::string specification, rows;
  for (const PrintedColumn& column : columns) specification += column.specification();
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    rows += line(columns, [row](const PrintedColumn& column) { return column.cell(row); });
  }
  const std::string tabular = fmt::format(
      "\\begin{{tabular}}{{{}}}\n  \\toprule\n{}  \\midrule\n{}  \\bottomrule\n"
      "\\end{{tabular}}",
      specification, head(columns), rows);
  if (notes_.empty()) return tabular + "%\n";
  std::string notes;
  for (const std::string& note : notes_) notes += fmt::format("\\LiterateNote{{{}}}%\n", note);
  return fmt::format("\\LiterateNoted{{%\n{}}}{{%\n{}}}%\n", tabular, notes);
}

std::vector<std::vector<std::string>> Table::printed() const {
  const Columns columns = printed_columns(*this);
  std::vector<std::vector<std::string>> rows(rows_.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (const PrintedColumn& column : columns) rows[row].push_back(column.plain(row));
  }
  return rows;
}

std::string Table::csv() const {
  // The columns of errors that follow a column.
  struct Errors {
    bool has_bound = false, has_standard = false;
  };
  std::vector<Errors> errors(columns_.size());
  std::vector<std::string> fields;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    for (const auto& row : rows_) {
      const auto& known = row[i].known();
      errors[i].has_bound = errors[i].has_bound || (known && known->bound > 0);
      errors[i].has_standard = errors[i].has_standard || (known && known->standard > 0);
    }
    const std::string group = column.group().empty() ? "" : column.group() + ": ";
    const std::string unit = column.unit().empty() ? "" : fmt::format(" ({})", column.unit());
    fields.push_back(group + column.heading() + unit);
    if (errors[i].has_bound) fields.emplace_back("bound");
    if (errors[i].has_standard) fields.emplace_back("standard");
  }
  std::string text = sys::csv_line(fields);
  for (const auto& row : rows_) {
    fields.clear();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Cell& cell = row[i];
      const bool is_number = cell.number() != nullptr;
      fields.push_back(is_number ? round_trip(*cell.number()) : sys::one_line(cell.given()));
      const bool is_known = is_number && cell.known();
      if (errors[i].has_bound) fields.push_back(is_known ? round_trip(cell.known()->bound) : "");
      if (errors[i].has_standard) {
        fields.push_back(is_known ? round_trip(cell.known()->standard) : "");
      }
    }
    text += sys::csv_line(fields);
  }
  for (const std::string& note : notes_) text += fmt::format("# {}\n", sys::one_line(note));
  return text;
}

}  // namespace literate
