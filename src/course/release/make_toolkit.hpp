// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "course/assignment/assignment.hpp"

namespace course {

/// Compiles the toolkit from the assignment's template and the files of `source`/src that it
/// provides, and replaces the folder `output` when all is done. Throws ToolError with the
/// compiler's message, OutputError if the folder cannot be written or holds something else, and
/// SourceError as read_project does.
void make_toolkit(const Assignment& assignment, const std::filesystem::path& source,
                  const std::filesystem::path& output);

}  // namespace course
