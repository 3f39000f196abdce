// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// Units have the spelling of UDUNITS-2: "lbf/in", "lbf.s^2/in^4", "m s-1", "W/(m2.K)", "um",
/// "degC", "%". An empty text, or "1", means no unit. Each function throws std::invalid_argument
/// for a unit that UDUNITS-2 does not know.

/// Returns the unit as plain text: «lbf s²/in⁴», «m s⁻¹», «µm», «°C»; empty for no unit.
std::string plain_unit(std::string_view unit);

/// Returns the unit as LaTeX for math mode: `\mathrm{lbf}\,\mathrm{s}^{2}/\mathrm{in}^{4}`.
std::string latex_unit(std::string_view unit);

}  // namespace literate
