// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace literate {

/// A number, a text, or nothing. Text is plain and is escaped, unless Cell::latex made it.
class Cell {
 public:
  Cell() = default;
  template <typename Number>
  requires(std::integral<Number> || std::floating_point<Number>) Cell(Number number)
      : content_(static_cast<double>(number)) {}
  Cell(std::string_view text);
  Cell(const std::string& text) : Cell(std::string_view(text)) {}
  Cell(const char* text) : Cell(std::string_view(text)) {}

  /// Makes a number whose last digit stands at 10^place, whatever the column says of decimals: for
  /// quoted numbers, which keep the digits of their source.
  static Cell to_place(double number, int place);

  /// Makes a text that is LaTeX already.
  static Cell latex(std::string text);

  bool is_empty() const { return std::holds_alternative<std::monostate>(content_); }
  /// The number, or null.
  const double* number() const { return std::get_if<double>(&content_); }
  /// The place of the number's last digit; none if the column decides it.
  const std::optional<int>& place() const { return place_; }
  /// The text as LaTeX, or null.
  const std::string* text() const { return std::get_if<std::string>(&content_); }

 private:
  std::variant<std::monostate, double, std::string> content_;
  std::optional<int> place_;
};

}  // namespace literate
