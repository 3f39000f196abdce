// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace toolchain {

/// The numerical libraries that the mechanics stand on, by name, and their versions: as compiled
/// in, that of FFTW as it runs.
std::map<std::string, std::string> libraries();

}  // namespace toolchain
