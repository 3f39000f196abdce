// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace literate {

/// One column of a Table: its heading (LaTeX), its unit (literal text) and how it prints numbers.
/// Every factory throws std::invalid_argument for a unit that require_unit refuses.
class Column {
 public:
  /// Numbers with `decimals` digits after the point.
  static Column fixed(std::string heading, std::string unit, int decimals);

  /// Numbers divided by 10^exponent, which moves to the unit line: (10⁻⁶ in).
  static Column scaled(std::string heading, std::string unit, int exponent, int decimals);

  /// As scaled(), with the exponent of the column's largest magnitude and `n_digits` digits there.
  static Column common_exponent(std::string heading, std::string unit, int n_digits);

  /// Numbers with `n_digits` significant digits and each its own exponent.
  static Column scientific(std::string heading, std::string unit, int n_digits);

  /// Whole numbers; a cell with a fraction throws std::invalid_argument when the table is written.
  static Column integer(std::string heading, std::string unit = "");

  /// Plain text, set flush left.
  static Column text(std::string heading);

  const std::string& heading() const { return heading_; }
  const std::string& unit() const { return unit_; }

 private:
  enum class Kind { fixed, common_exponent, scientific, integer, text };
  Column(Kind kind, std::string heading, std::string unit, int exponent, int digits);
  friend class ColumnWriter;

  Kind kind_;
  std::string heading_;
  std::string unit_;
  int exponent_;
  int digits_;
};

/// A number, a text, or nothing. A text is plain and gets escaped unless made by Cell::latex.
class Cell {
 public:
  Cell() = default;
  template <typename Number>
  requires(std::integral<Number> || std::floating_point<Number>) Cell(Number number)
      : content_(static_cast<double>(number)) {}
  Cell(std::string_view text);
  Cell(const std::string& text) : Cell(std::string_view(text)) {}
  Cell(const char* text) : Cell(std::string_view(text)) {}

  /// A number whose last digit stands at 10^place, whatever the column says of decimals: for
  /// numbers quoted from elsewhere, which keep their digits.
  static Cell to_place(double number, int place);

  /// A text that is LaTeX already.
  static Cell latex(std::string text);

  bool is_empty() const { return std::holds_alternative<std::monostate>(content_); }
  /// The number, or null.
  const double* number() const { return std::get_if<double>(&content_); }
  /// Where the number's last digit stands; none where the column decides.
  const std::optional<int>& place() const { return place_; }
  /// The text as LaTeX, or null.
  const std::string* text() const { return std::get_if<std::string>(&content_); }

 private:
  std::variant<std::monostate, double, std::string> content_;
  std::optional<int> place_;
};

/// A table, written as a booktabs tabular whose numbers stand on the decimal point.
class Table {
 public:
  /// Throws std::invalid_argument when there is no column.
  explicit Table(std::vector<Column> columns);

  /// Throws std::invalid_argument unless there is one cell a column.
  Table& add_row(std::vector<Cell> cells);

  /// The tabular, with siunitx S columns whose table-format is taken from the data. Throws
  /// std::invalid_argument for a number that is not finite, or in a text column.
  std::string latex() const;

  /// The same as CSV, with the headings and units as in LaTeX and numbers that read back the same.
  std::string csv() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace literate
