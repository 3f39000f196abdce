// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "course/assignment/assignment.hpp"
#include "course/assignment/files.hpp"
#include "course/sandbox/sandbox.hpp"

namespace course {

/// A submission, compiled.
struct Built {
  std::filesystem::path program;
  /// The compiler's message by exercise, for those whose file is missing or does not compile; a
  /// stub stands in for them.
  std::map<std::string, std::string> compile_errors;
  std::string link_error;  ///< empty unless there is no program at all
};

/// Compiles the exercises' files with the toolkit (what `toolkit` wrote) into the folder `scratch`.
/// Throws ToolError if the compiler or the sandbox cannot be started, never for what is submitted.
Built build(const Assignment& assignment, const std::filesystem::path& toolkit, const Files& files,
            const std::filesystem::path& scratch, Isolation isolation);

}  // namespace course
