// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/assignment/variant.hpp"
#include "course/sandbox/sandbox.hpp"

namespace course {

/// What a student's functions give for the report.
struct ReportNumbers {
  Files files;                        ///< by name, such as "numbers.tex"
  std::vector<std::string> problems;  ///< a line each: what does not compile, run or come out
};

/// Compiles the handout's report/figures.cpp with the student's numbers and files, and runs it in
/// the sandbox, as `make figures` of the handout does; a second run must give the same. Of the
/// files that it leaves numbers.tex and NAME.dat are taken. `toolkit` is the toolkit's folder,
/// `scratch` an empty one. The program may take `seconds_left`, of which what it takes is
/// subtracted. Nothing is computed if the handout has no such program. Throws ToolError
/// if compiler or sandbox cannot work, never because of what was submitted.
ReportNumbers report_numbers(const Assignment& assignment, const std::filesystem::path& toolkit,
                             const Files& exercises, const Variant& variant,
                             const std::filesystem::path& scratch, Isolation isolation,
                             double& seconds_left);

}  // namespace course
