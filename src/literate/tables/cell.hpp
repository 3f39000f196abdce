// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "literate/values/decimal.hpp"
#include "literate/values/format.hpp"

namespace literate {

/// A number, a text, or nothing. Text is plain and is escaped, unless Cell::latex made it.
///
/// A number is exact (an integer), an estimate or a measured number with its error, or quoted with
/// its last place. Table::add_row() takes one that is none of these, a bare double, only in a
/// column that is declared to hold exact numbers.
class Cell {
 public:
  Cell() = default;
  template <std::integral Integer>
  Cell(Integer number)
      : content_(static_cast<double>(number)), not_held_(not_held(number)), uncertainty_(0.0) {}
  template <std::floating_point Number>
  Cell(Number number) : content_(static_cast<double>(number)) {}
  /// Prints as the column says, but no digit that the error does not support.
  Cell(numerics::Estimate estimate) : content_(estimate.value), uncertainty_(estimate.abs_error) {}
  /// The same with the standard uncertainty and the bound, added.
  Cell(const numerics::Measured& number) : Cell(number.value(), number) {}
  Cell(double number, const Uncertainty& uncertainty)
      : content_(number), uncertainty_(uncertainty) {}
  Cell(std::string_view text);
  Cell(const std::string& text) : Cell(std::string_view(text)) {}
  Cell(const char* text) : Cell(std::string_view(text)) {}

  /// Makes a number that another source prints with its last digit at 10^place, and with an error
  /// if that source tells one: it keeps these digits as far as the error supports them,
  /// whatever the column says. Throws
  /// std::invalid_argument for a number that has more digits.
  static Cell quoted(double number, int place,
                     const std::optional<Uncertainty>& uncertainty = std::nullopt);

  /// Makes a text that is LaTeX already. Its CSV file has it as plain_text() makes it.
  static Cell latex(std::string text);

  /// The same cell with a small mark behind it, which a note below the table explains.
  Cell marked(std::string mark) const;

  bool is_empty() const { return std::holds_alternative<std::monostate>(content_); }
  /// The number, or null.
  const double* number() const { return std::get_if<double>(&content_); }
  /// A whole number beyond ±2^53, which number() may not be, as text; empty for any other.
  const std::string& beyond_doubles() const { return not_held_; }
  /// What is not known of the number: 0 for an integer; none for a bare or a quoted number.
  const std::optional<Uncertainty>& uncertainty() const { return uncertainty_; }

  /// What its digits count as its error; 0 where nobody told it.
  double error() const { return uncertainty_ ? uncertainty_->error() : 0; }
  /// The place of a quoted number's last digit; none if the column decides it.
  const std::optional<int>& place() const { return place_; }
  /// The text as LaTeX, or null.
  const std::string* text() const { return std::get_if<std::string>(&content_); }
  /// The text as it was given; empty for one that was LaTeX already.
  const std::string& plain() const { return plain_; }
  /// The mark, plain text; empty for none.
  const std::string& mark() const { return mark_; }

 private:
  std::variant<std::monostate, double, std::string> content_;
  std::string plain_;
  std::string not_held_ = {};
  std::optional<Uncertainty> uncertainty_;
  std::optional<int> place_;
  std::string mark_;
};

}  // namespace literate
