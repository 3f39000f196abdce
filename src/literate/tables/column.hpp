// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <source_location>
#include <string>

#include "literate/values/format.hpp"

namespace literate {

/// What a column says of itself and of its numbers. Column explains it.
struct ColumnFormat {
  std::string heading;            ///< LaTeX
  std::optional<Format> numbers;  ///< none for a column of texts
  std::string unit;               ///< literal text; empty for none
  std::string group = {};         ///< the heading over this column and its neighbours, LaTeX
  int exponent = 0;               ///< the power of ten that the unit line states
  bool is_exact = false;          ///< whether bare numbers are exact
  double width_cm = 0;            ///< at which texts are broken into lines; 0 for one line
  std::string plain = {};         ///< the heading as plain text, if that is what it was

  /// The heading as it was given, for messages.
  const std::string& name() const { return plain.empty() ? heading : plain; }
};

/// One column of a Table: its heading (LaTeX), how it prints numbers, and their unit (literal
/// text).
///
///     Column("$u_z$", significant(8), "in")     // the power of ten they share: below the heading
///     Column("FEA", fixed(3), "in").scaled(-6)  // in 10⁻⁶ in
///     Column("$x$", fixed(2), "in").exact()     // parameters, which have no error
///     Column("misfit", percent(1))              // ratios; (%) below the heading
///     Column("nodes", integer())
///     Column::text("method")
///     Column::text("remark", 4.5)               // in lines of 4.5 cm
///
/// What is refused is told with the line of the code that asked for it.
class Column {
 public:
  using Location = std::source_location;

  /// Throws std::invalid_argument for a unit that require_unit refuses, and for a percentage with a
  /// unit.
  Column(std::string heading, const Format& numbers, std::string unit = "",
         Location location = Location::current());

  /// Prints plain text, flush left, in lines of `width_cm` or, without it, in one line. Throws
  /// std::invalid_argument for a width that is negative or not finite.
  static Column text(std::string heading, double width_cm = 0,
                     Location location = Location::current());

  /// Prints the numbers divided by 10^exponent, which the unit line states. Only for fixed():
  /// throws std::invalid_argument for other formats.
  Column scaled(int exponent, Location location = Location::current()) const;

  /// Declares that bare numbers in this column have no error, such as parameters and abscissae.
  /// They are not rounded: one with more digits than the format has prints them all. Columns of
  /// integer() and exact() numbers need not say so.
  Column exact() const;

  /// Puts a heading over this column and those beside it that have the same one.
  Column under(std::string group) const;

  /// Says what the heading was before it was escaped for LaTeX, for messages and CSV files.
  Column named(std::string plain) const;

  const ColumnFormat& format() const { return format_; }

 private:
  Column(ColumnFormat format, const Location& location);

  ColumnFormat format_;
};

}  // namespace literate
