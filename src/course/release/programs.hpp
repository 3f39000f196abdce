// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "course/assignment/assignment.hpp"
#include "course/marking/toolkit.hpp"

namespace course {

/// Compiles the programs on which students' own tests are tried, for each exercise that asks for
/// tests: the solution, and the solution with the mistake that each wrong solution makes in the
/// exercise's own file. They lie beside the toolkit, where this process's user alone can read them.
/// Throws config::Error as read_wrong_solutions does, sys::SourceError if no wrong solution changes
/// such an exercise's file, and sys::ToolError with what the compiler says.
void make_programs(const Assignment& assignment, const Toolkit& toolkit, const Files& solution);

}  // namespace course
