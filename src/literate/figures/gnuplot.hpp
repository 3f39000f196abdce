// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "system/process.hpp"

namespace literate {

/// Runs `gnuplot name.gp` inside the folder, after `settings` if there are any, with gnuplot's own
/// defaults instead of a user's, and sets the creation date in name.pdf to a fixed day: the same
/// script gives the same bytes on any day, for any user. What gnuplot says and its exit status are
/// the caller's to judge. Throws sys::ToolError if there is no gnuplot.
sys::ProcessResult run_gnuplot(const std::filesystem::path& folder, const std::string& name,
                               const std::string& settings = {});

}  // namespace literate
