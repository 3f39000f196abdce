// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/assignment/check.hpp"
#include "course/assignment/variant.hpp"

namespace course {

/// The texts of a project's files, by path, such as "src/closed_form.cpp".
using Files = std::map<std::string, std::string>;

/// Whether what a submission holds is compiled and run apart from everything else.
enum class Isolation { sandbox, none };

/// A submission, compiled.
struct Built {
  std::filesystem::path program;
  /// The compiler's message by exercise, for those whose file is missing or does not compile; a
  /// stub stands in for them.
  std::map<std::string, std::string> compile_errors;
  std::string link_error;  ///< empty unless there is no program at all
};

/// Compiles the exercises' files with the toolkit (what `course toolkit` made) into `scratch`.
/// Throws ToolError if the compiler or the sandbox cannot be started, never for what is submitted.
Built build(const Assignment& assignment, const std::filesystem::path& toolkit, const Files& files,
            const std::filesystem::path& scratch, Isolation isolation);

class ProgramRun;

/// What a check gave.
struct CheckResult {
  std::string id;
  double points = 0;  ///< reached, before any deduction
  std::string message;
};

/// Runs every check of the assignment, in its order. Throws std::logic_error for a check that
/// `checks` does not hold.
std::vector<CheckResult> evaluate(const Assignment& assignment, const Checks& checks,
                                  const Built& built, const Variant& variant, Isolation isolation);

/// The same of a program that runs already, for what is asked besides.
std::vector<CheckResult> evaluate(const Assignment& assignment, const Checks& checks,
                                  const Built& built, const Variant& variant, ProgramRun& run);

double total(const std::vector<CheckResult>& results);

}  // namespace course
