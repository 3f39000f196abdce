// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// Numbers and units as siunitx sets them, in HTML: digits from five on in groups of three, a minus
/// and not a hyphen, ×10 with a raised exponent. A text that is no number stays as it is.

/// \num{1.23e-6}
std::string number_html(std::string_view number);

/// \unit{lbf/in}; a dot is a thin space, ^2 is raised.
std::string unit_html(std::string_view unit);

/// \qty{1.2}{in}
std::string quantity_html(std::string_view number, std::string_view unit);

/// A number of a table, padded to the width of its column, so that the points stand below one
/// another whatever the alignment. `format` is the widest number of the column, such as -2.3e-1 for
/// a sign, two digits, three decimals, and an exponent of one digit with a sign; `mark` stands
/// behind the last digit.
std::string number_cell_html(std::string_view format, std::string_view number,
                             std::string_view mark = {});

/// The same as MathML, where a number is one token.
std::string number_mathml(std::string_view number);

}  // namespace literate
