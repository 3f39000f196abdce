// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

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

/// A text from a submission as it may be shown. Bytes that are not UTF-8, control characters
/// other than tab and line end and characters that turn the direction of a text become '?'; a text
/// longer than `max_bytes` is cut and says so.
std::string shown(std::string_view text, std::size_t max_bytes);

/// The same in one line, for names: line ends and tabs become '?' as well.
std::string shown_name(std::string_view name);

/// The first `max_bytes` bytes of a file; empty if it cannot be read.
std::string beginning_of(const std::filesystem::path& file, std::size_t max_bytes);

}  // namespace course
