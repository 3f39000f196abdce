// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// A unit is typed as UDUNITS reads it: names with their powers, «m2», «m^2», «m**2», «m²», «s-1»
/// or «s⁻¹»; between them a blank, «.», «·», «*» or «-» for a product, «/» or « per » for a
/// quotient, and parentheses. What UDUNITS does not know, such as {kWh} or {vehicles}, stands in
/// braces, which are not printed. As there, a slash divides by the one factor behind it, so that
/// «N/m.s» is printed as N s/m. «m^0.5» and «m^(1/2)» are printed as well; «1» is no unit.
///
/// Each of these functions throws std::invalid_argument, which tells how a unit is spelt, for
/// anything else.
void require_unit(std::string_view unit);

/// A unit as plain text with its signs: «µm» for um, «°C» for degC, «kΩ» for kohm, «m s⁻¹» for
/// m.s-1, «W/(m² K)» for W/m2/K, «%» for percent. Empty for «1».
std::string plain_unit(std::string_view unit);

/// The same for siunitx, which prints a power only behind a «^», loses blanks, and in formulas a
/// sign beyond ASCII, without a word.
std::string latex_unit(std::string_view unit);

/// The plain unit that latex_unit() made this of; any other LaTeX stays as it is.
std::string unit_of_latex(std::string_view latex);

}  // namespace literate
