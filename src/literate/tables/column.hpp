// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "literate/text/place.hpp"
#include "literate/values/format.hpp"

namespace literate {

/// One column of a Table: its heading (LaTeX), and the format and unit of its numbers.
///
///     Column("$u_z$", significant(8), "in")     a common power of ten goes into the head
///     Column("FEA", fixed(3), "in").scaled(-6)  in 10⁻⁶ in
///     Column("$x$", fixed(2), "in").exact()     parameters, which have no error
///     Column("misfit", percent(1))              ratios; (%) below the heading
///     Column("nodes", integer())
///     Column::text("method")
///     Column::text("remark", 4.5)               in lines of 4.5 cm
///
/// In a column of significant(n) the largest number has n digits.
class Column {
 public:
  /// Throws Error for unmatched braces in the heading, a unit that UDUNITS-2 does not know, and a
  /// percentage with a unit.
  Column(std::string heading, const Format& numbers, std::string unit = "",
         const Place& place = std::source_location::current());

  /// A column of texts, flush left, broken into lines of `width_cm` unless that is 0.
  static Column text(std::string heading, double width_cm = 0,
                     const Place& place = std::source_location::current());

  /// Prints the numbers divided by 10^exponent, a factor that the head states. For fixed() only.
  Column scaled(int exponent, const Place& place = std::source_location::current()) const;

  /// Declares that bare numbers in this column, such as parameters and abscissae, are exact. If
  /// such a number has more digits than the format, all of them are printed. In columns of
  /// integer() and exact() this is the default.
  Column exact() const;

  /// Puts a heading (LaTeX) over this column and its neighbours with the same heading.
  Column under(std::string group, const Place& place = std::source_location::current()) const;

  const std::string& heading() const { return heading_; }
  const std::string& group() const { return group_; }
  /// The format of the numbers; none for a column of texts.
  const std::optional<Format>& numbers() const { return numbers_; }
  const std::string& unit() const { return unit_; }
  int exponent() const { return exponent_; }
  bool is_exact() const { return is_exact_; }
  double width_cm() const { return width_cm_; }

 private:
  Column() = default;

  std::string heading_;
  std::string group_;
  std::optional<Format> numbers_;
  std::string unit_;
  int exponent_ = 0;
  bool is_exact_ = false;
  double width_cm_ = 0;
};

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
