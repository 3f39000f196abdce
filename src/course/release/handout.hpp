// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/assignment/variant.hpp"
#include "course/release/markers.hpp"

namespace course {

/// A file of the student's project.
struct ProjectFile {
  std::filesystem::path origin;  ///< the marked file
  MarkedText text;
  std::filesystem::perms permissions = std::filesystem::perms::none;
};

/// The student's project with its solution, by path in the project.
using Project = std::map<std::string, ProjectFile>;

enum class Edition { handout, solution };

/// Reads the assignment's template/ and the provided files of source/src, which go to
/// provided/, and fills their lists. Throws sys::SourceError for wrong markers and lists, for a
/// provided file that does not exist or that the template also holds, and for a template in which
/// somebody has compiled.
Project read_project(const Assignment& assignment, const std::filesystem::path& source);

/// The texts of one edition.
Files texts(const Project& project, Edition edition);

/// The exercises' files among `files`, as they would be submitted.
Files submission(const Assignment& assignment, const Files& files);

/// The file of the project that holds the student's numbers.
inline constexpr const char* variant_file = "provided/variant_of_this_handout.hpp";

/// The text of variant_file, which defines `this_variant`.
std::string variant_header(const Assignment& assignment, const Variant& variant);

/// Writes an edition for a variant, with a copy of the file `sheet` as sheet.pdf unless `sheet`
/// is empty. The folder is replaced as a whole when everything is written; scripts stay executable.
/// Throws sys::OutputError if it cannot be written or holds something else.
void write_project(const Project& project, Edition edition, const Assignment& assignment,
                   const Variant& variant, const std::filesystem::path& sheet,
                   const std::filesystem::path& output);

/// Unpacks a zip that this project made into an existing folder. Throws sys::ToolError if
/// bsdtar is missing or cannot read the zip.
void unpack_zip(const std::filesystem::path& zip, const std::filesystem::path& folder);

/// A line for each file that differs between a zip and a folder or is missing in one of them.
/// The zip may hold the files at its top or in one folder. Throws as unpack_zip does.
std::vector<std::string> differences_of_zip(const std::filesystem::path& zip,
                                            const std::filesystem::path& folder);

/// Fills the lists of a file of the template, so that what names all exercises follows from
/// assignment.toml alone. A list is a comment on a line of its own,
///
///     // EACH EXERCISE: #include "assignment/exercises/@name@.hpp"
///     // EACH PUBLIC CHECK: {@number@, "@check@", @points@},
///     # EACH OWN TESTS: add_executable(@check@ @tests@)
///
/// in whose place its text stands once for each exercise, each public check or each exercise that
/// asks for tests, with the indentation and line end of that line. In it `@number@` is the number
/// of the exercise, from 1; `@name@` the name of its file without folder and ending; `@file@` its
/// file; `@id@` and `@title@` are as assignment.toml has them; `@points@` are those of the exercise
/// or check; `@check@` and `@says@` are the id and the words of the check; and `@tests@` is the
/// file of tests.
///
/// Throws sys::SourceError «file:line: …» for a list of something else, and for another word
/// between two @.
std::string with_lists(const Assignment& assignment, std::string_view text,
                       const std::string& file);

}  // namespace course
