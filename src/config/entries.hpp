// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace config {

/// All entries of a case file as text, by their keys with dots between: «load.peak» → «1000 psi».
///
/// A quantity is its number and its unit, a text has no quotes, and everything else stands as the
/// file writes it, in one line. Throws Error for a file that cannot be read or is not TOML.
std::map<std::string, std::string> entries_of(const std::filesystem::path& file);

}  // namespace config
