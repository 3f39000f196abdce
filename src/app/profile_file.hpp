// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "contact/profile.hpp"

namespace app {

/// A measured profile from a CSV file: a heading `x,gap`, then a line each with x and the gap h
/// there, x rising, in the unit of length of the case. Empty lines and lines that begin with # are
/// passed over. Throws sys::InputError naming file and line for a file that cannot be read, a
/// missing column, a number that is none, or an x that is not greater than the one before.
contact::Profile read_profile(const std::string& file);

}  // namespace app
