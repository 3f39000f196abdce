// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace course {

/// Throws sys::SourceError unless the id consists of 1 to 64 letters, digits, '.', '_', '-' and
/// '@', begins with a letter, digit or '_', and ends neither with ".part" nor as an archive does.
/// Such an id may name a folder, is no formula in a table, and is not the name of an unfinished
/// folder.
void require_student_id(const std::string& student);

/// The endings of archives that can be read, ".zip, .7z, …".
std::string archive_endings();

/// Whether a file's name ends with one of them, also in capitals.
bool names_archive(const std::filesystem::path& path);

/// The student from whom a submission is: the name of its folder, or of its archive without the
/// ending.
std::string student_of(const std::filesystem::path& path);

}  // namespace course
