// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "system/error.hpp"

namespace command_line {

/// The number that the whole text spells, rounded once and without regard to the locale. Throws
/// sys::InputError naming `what` and the text if it is none, or not finite.
double parse_number(const std::string& what, const std::string& text);

/// The numbers of a list 0,0.005,0.01. Throws sys::InputError naming the element that is none.
std::vector<double> parse_numbers(const std::string& what, const std::string& text);

/// The numbers of a file, one a line; "-" reads standard input. Empty lines and lines that begin
/// with # are passed over. Throws sys::InputError for a file that cannot be read, for one without a
/// number, and for a line that is none (file:line).
std::vector<double> read_numbers(const std::string& file);

/// The result if it is a finite number; throws sys::InputError naming `what` otherwise.
double finite_result(const std::string& what, double result);

/// The shortest decimal digits that read back as the same double.
std::string shortest(double number);

}  // namespace command_line
