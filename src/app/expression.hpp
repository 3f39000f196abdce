// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>

namespace app {

/// The function of x that a formula spells, such as p0*(1-(x/a)^4): muParser's operators and
/// functions (sin, sqrt, abs, exp, ln, min, …), pi, and these constants. The function throws
/// sys::InputError naming x where the formula has no finite value. `what` begins the messages.
///
/// Throws sys::InputError naming the column of the formula where it is wrong. A decimal point is
/// one in every locale.
std::function<double(double)> parse_expression(const std::string& what, const std::string& formula,
                                               const std::map<std::string, double>& constants);

}  // namespace app
