// SPDX-License-Identifier: GPL-3.0-or-later
// How LaTeX is run on a document, whatever it is run for.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "literate/typesetting/typeset_options.hpp"

namespace literate {

/// The path relative to the folder in which LaTeX runs, so that its output names no folder of this
/// machine.
std::string seen_from(const std::filesystem::path& source_dir, const std::filesystem::path& path);

/// The variables by which a run depends on nothing of this machine and day: date, time zone,
/// locale, no packages of the user's; and where the generated files are found.
std::map<std::string, std::string> latex_environment(const TypesetOptions& options);

/// A file that LaTeX makes of the document, by its extension such as ".log".
std::filesystem::path in_build_dir(const TypesetOptions& options, const char* extension);

}  // namespace literate
