// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/release/handout.hpp"
#include "course/release/secret_numbers.hpp"

namespace course {

/// A text that students must not see.
struct Secret {
  std::string what;  ///< such as "the solution of template/src/root.cpp:12"
  std::string text;
};

/// What a handout must not hold.
struct Secrets {
  std::vector<Secret> lines;  ///< compared without white space
  std::vector<Secret> words;  ///< found where no letter, digit, '_' or '-' stands beside them
  SecretNumbers numbers{{}};
};

/// The secret lines of a project and of `files` (the hidden checks' sources), the ids of hidden
/// checks, the names of hidden tests and files, and the expected values.
///
/// A line counts if it has ten characters besides white space and does not stand in what students
/// are given anyhow.
Secrets secrets_of(const Assignment& assignment, const Project& project,
                   const std::vector<std::filesystem::path>& files,
                   const std::vector<double>& expected_values);

/// A line for each solution of at least three lines that count, all of which stand in the public
/// part as well: a copy that no scan can tell from what is public.
std::vector<std::string> published_solutions(const Project& project);

/// A line for each provided file that lies in a folder of source/src which `files` (the hidden
/// checks' sources) include from, directly or by what they include: the answers that submissions
/// are compared with. Files of assignment/, course/ and numerics/, which both sides use, are none,
/// but for `files` themselves.
std::vector<std::string> published_references(const Assignment& assignment,
                                              const std::filesystem::path& source,
                                              const std::vector<std::filesystem::path>& files);

/// A line for each secret found in a file, or in any file of a folder, its name included. All files
/// are searched as bytes; PDFs as text too, with their attachments; zips are unpacked; an archive
/// of another kind is a line by itself. Throws sys::ToolError if pdftotext, pdfdetach or
/// bsdtar cannot do its work.
std::vector<std::string> leaks(const Secrets& secrets, const std::filesystem::path& place);

}  // namespace course
