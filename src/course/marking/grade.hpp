// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "course/marking/feedback.hpp"
#include "course/marking/mark.hpp"

namespace course {

/// One submission, and everything that is needed to grade it.
struct GradingTask {
  std::filesystem::path submission;  ///< folder or archive
  std::string student;
  std::optional<Time> submitted;
  std::optional<int> slip_days;  ///< that the student has left
  Variant variant;
  std::filesystem::path toolkit;
  Checks checks;
  Curves curves;  ///< may be empty
  Isolation isolation = Isolation::sandbox;
};

/// Grades one submission and writes results.json, feedback.html, mark.json and log.txt to the
/// folder `output`, all of them or none. The same submission gives the same bytes. Throws
/// OutputError if the path is no submission or a file cannot be written, and ToolError if the
/// grader cannot work, but nothing because of what was submitted.
Graded grade_submission(const Assignment& assignment, const GradingTask& task,
                        const std::filesystem::path& output);

}  // namespace course
