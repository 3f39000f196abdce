// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace course {

/// Throws sys::SourceError unless the id is of 1 to 64 letters, digits, '.', '_', '-' and '@',
/// begins with a letter, digit or '_', and ends neither with ".part" nor as an archive does: so
/// that it may name a folder, is no formula in a table, and is no unfinished folder's name.
void require_student_id(const std::string& student);

/// Whether the name ends as one of an archive that is understood: .zip, .tar, .tar.gz, .tgz,
/// .tar.xz.
bool names_archive(const std::filesystem::path& path);

/// The name of a folder or archive without its ending: the student it is from.
std::string student_of(const std::filesystem::path& path);

}  // namespace course
