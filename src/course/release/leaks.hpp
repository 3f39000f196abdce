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
  std::vector<Secret> words;  ///< found if no letter, digit, '_' or '-' stands beside them
  SecretNumbers numbers{{}};
};

/// The secret lines of a project and of `files` (the hidden checks' sources), the ids of hidden
/// checks, the names of hidden tests and files, and the expected values.
///
/// A line is secret if it has at least ten characters besides white space and does not stand in
/// the public part of the handout.
Secrets secrets_of(const Assignment& assignment, const Project& project,
                   const std::vector<std::filesystem::path>& files,
                   const std::vector<double>& expected_values);

/// A line for each solution of at least three such lines that all stand in the public part as
/// well. No search could tell a copy of such a solution from public text.
std::vector<std::string> published_solutions(const Project& project);

/// A line for each provided file that belongs to the answers with which submissions are
/// compared: it is one of `files` (the hidden checks' sources) or lies in a folder of source/src
/// from which these include, directly or indirectly. The folders assignment/, course/ and numerics/
/// do not count, since both sides use them.
std::vector<std::string> published_references(const Assignment& assignment,
                                              const std::filesystem::path& source,
                                              const std::vector<std::filesystem::path>& files);

/// A line for each secret found in a file, or in any file of a folder, its name included. All
/// files are searched as bytes. PDFs are also searched as text and with their attachments, and zips
/// are unpacked; an archive of another kind gives a line itself. Throws sys::ToolError if
/// pdftotext, pdfdetach or bsdtar fails.
std::vector<std::string> leaks(const Secrets& secrets, const std::filesystem::path& place);

}  // namespace course
