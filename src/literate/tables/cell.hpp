// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "literate/values/number.hpp"

namespace literate {

/// A number, a text, or nothing. A text is plain and is escaped, unless Cell::latex made it.
///
/// An integer is exact; an Estimate or a Number has its errors. Only a column of exact numbers
/// accepts a bare double.
class Cell {
 public:
  Cell() = default;
  template <std::integral Integer>
  Cell(Integer number) : Cell(Number(static_cast<double>(number), 0)) {}
  template <std::floating_point Float>
  Cell(Float number) : content_(static_cast<double>(number)) {}
  Cell(const Number& number) : content_(number.value), known_(number) {}
  Cell(numerics::Estimate estimate) : Cell(Number(estimate)) {}
  Cell(std::string_view text);
  Cell(const std::string& text) : Cell(std::string_view(text)) {}
  Cell(const char* text) : Cell(std::string_view(text)) {}

  /// A number that a different source prints with its last digit at 10^place. It keeps these digits
  /// in any column, and has no error.
  static Cell quoted(double number, int place);

  /// A text in LaTeX.
  static Cell latex(std::string text);

  bool is_empty() const { return std::holds_alternative<std::monostate>(content_); }
  /// The number, or null.
  const double* number() const { return std::get_if<double>(&content_); }
  /// The text as LaTeX, or null.
  const std::string* text() const { return std::get_if<std::string>(&content_); }
  /// The text as given: plain, or LaTeX if is_latex().
  const std::string& given() const { return given_; }
  bool is_latex() const { return is_latex_; }
  /// The number with its errors; none for a bare or a quoted number.
  const std::optional<Number>& known() const { return known_; }
  /// The place of a quoted number's last digit.
  const std::optional<int>& place() const { return place_; }

 private:
  std::variant<std::monostate, double, std::string> content_;
  std::optional<Number> known_;
  std::optional<int> place_;
  std::string given_;
  bool is_latex_ = false;
};

}  // namespace literate
