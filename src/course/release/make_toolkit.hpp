// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/marking/toolkit.hpp"

namespace course {

/// Compiles the toolkit from the assignment's template and the files of `source`/src that it
/// provides, and replaces the folder `output` when all is done. Throws ToolError with the
/// compiler's message, OutputError if the folder cannot be written or holds something else, and
/// SourceError as read_project does.
void make_toolkit(const Assignment& assignment, const std::filesystem::path& source,
                  const std::filesystem::path& output);

/// Runs g++ for a product of the toolkit. Throws sys::ToolError with what it says if it fails.
void run_compiler(std::vector<std::string> arguments, const std::filesystem::path& product);

/// Compiles a source with the toolkit's header and flags. Throws so, too.
void compile(const Toolkit& toolkit, const std::filesystem::path& source,
             const std::filesystem::path& object);

/// Compiles the programs on which students' own tests are tried, for each exercise that asks for
/// tests: the solution, and the solution with the mistake that each wrong solution makes in the
/// exercise's own file. They lie beside the toolkit, where this process's user alone can read them.
/// Throws config::Error as read_wrong_solutions does, sys::SourceError if no wrong solution changes
/// such an exercise's file, and sys::ToolError with what the compiler says.
void make_programs(const Assignment& assignment, const Toolkit& toolkit, const Files& solution);

}  // namespace course
