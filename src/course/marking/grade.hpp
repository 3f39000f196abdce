// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "course/marking/feedback_picture.hpp"
#include "course/marking/mark.hpp"

namespace course {

/// One submission, and by what it is judged.
struct GradingTask {
  std::filesystem::path submission;  ///< folder or archive
  std::string student;
  std::optional<Time> submitted;
  Variant variant;
  std::filesystem::path toolkit;
  Checks checks;
  Curves curves;  ///< may be empty
  Isolation isolation = Isolation::sandbox;
};

/// Grades one submission and writes results.json, junit.xml, feedback.html, mark.json and log.txt
/// to the folder, all or none. The same submission gives the same bytes. Throws OutputError,
/// ToolError; nothing for what is submitted, but for a path that is no submission at all.
Graded grade_submission(const Assignment& assignment, const GradingTask& task,
                        const std::filesystem::path& output);

}  // namespace course
