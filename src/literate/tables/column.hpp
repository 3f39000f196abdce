// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "literate/text/place.hpp"
#include "literate/values/format.hpp"

namespace literate {

/// One column of a Table: its heading (LaTeX), how it prints numbers, and their unit.
///
///     Column("$u_z$", significant(8), "in")     the power of ten they share is in the head
///     Column("FEA", fixed(3), "in").scaled(-6)  in 10⁻⁶ in
///     Column("$x$", fixed(2), "in").exact()     parameters, which have no error
///     Column("misfit", percent(1))              ratios; (%) below the heading
///     Column("nodes", integer())
///     Column::text("method")
///     Column::text("remark", 4.5)               in lines of 4.5 cm
///
/// In a column of significant(n) it is the largest number that has n digits.
class Column {
 public:
  /// Throws Error for a heading whose braces do not match, a unit that UDUNITS-2 does not know, and
  /// a percentage with a unit.
  Column(std::string heading, const Format& numbers, std::string unit = "",
         const Place& place = std::source_location::current());

  /// A column of texts, flush left, in lines of `width_cm` or, if that is 0, in one line.
  static Column text(std::string heading, double width_cm = 0,
                     const Place& place = std::source_location::current());

  /// Prints the numbers divided by 10^exponent, which the head states. For fixed() only.
  Column scaled(int exponent, const Place& place = std::source_location::current()) const;

  /// Declares that bare numbers in this column are exact, such as parameters and abscissae. One
  /// with more digits than the format has prints them all. Columns of integer() and exact() numbers
  /// need not say so.
  Column exact() const;

  /// Puts a heading (LaTeX) over this column and its neighbours that have the same one.
  Column under(std::string group, const Place& place = std::source_location::current()) const;

  const std::string& heading() const { return heading_; }
  const std::string& group() const { return group_; }
  /// How numbers are printed; none for a column of texts.
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

}  // namespace literate
