// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace literate {

/// The number that a formula has as one writes it: «2(a/d)² + ε[1 + ln(2/ε)]».
///
/// It holds numbers, names of terms, + − · /, a − before what stands first, products without a
/// sign, parentheses of both kinds, ² ³ ⁴, and ln of what follows. Products and quotients are taken
/// from the left. Throws std::invalid_argument with the formula for anything else, for a term that
/// is never used, and for a result that is not finite.
double evaluated(std::string_view formula, const std::map<std::string, double>& terms);

}  // namespace literate
