// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/assignment/files.hpp"
#include "course/sandbox/sandbox.hpp"

namespace course {

/// What was taken from a submission, and what is wrong with it.
struct Submission {
  Files files;                        ///< the exercises' files that are fit to be compiled
  bool has_report = false;            ///< whether there is a report/report.tex, which people mark
  std::vector<std::string> problems;  ///< a line each, fit to be shown
};

/// Takes the exercises' files from a folder or archive, and reads nothing else of it. They may be
/// at the top or in one folder below. What is no regular file of a text within the limits is left
/// out with a line in `problems`; so is all of an archive that cannot be read. `work` is a folder
/// for the sandbox. Throws OutputError if the submission is neither folder nor archive.
Submission take_submission(const Assignment& assignment, const std::filesystem::path& submission,
                           const std::filesystem::path& work, Isolation isolation);

/// The folder, "" or "name/", in which an archive or folder of these entries holds the files that
/// are wanted, the top first. Throws std::invalid_argument if there are several.
std::string place_of_files(const std::vector<std::string>& entries,
                           const std::vector<std::string>& wanted);

/// Why a text cannot be a file of an exercise; empty if it can.
std::string fault_of(std::string_view text);

}  // namespace course
