// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "course/assignment/assignment.hpp"

namespace course {

/// Compiles the toolkit from the assignment's template and the files of `source`/src that it
/// provides, all or nothing. Throws ToolError with the compiler's message, OutputError,
/// SourceError.
void make_toolkit(const Assignment& assignment, const std::filesystem::path& source,
                  const std::filesystem::path& output);

}  // namespace course
