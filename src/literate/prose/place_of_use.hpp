// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace literate {

/// A message of LaTeX («file:line: message») about a generated table, figure or excerpt, told at
/// the place of the document that uses it, because that is where its author can go:
/// «report/part.tex:12: in table 'name': message (tables/name.tex:3)». Other messages come back as
/// they are. Throws sys::OutputError if the document cannot be read.
std::string told_at_place_of_use(const std::string& message,
                                 const std::filesystem::path& source_dir);

}  // namespace literate
