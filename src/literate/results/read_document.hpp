// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "literate/document/document.hpp"

namespace literate {

/// Reads what a script in any language registered, as document.schema.json in this folder describes
/// it, with the same rules as for a C++ program. What names no place has the file's name as
/// its place. Throws Error «FILE: key: …» for a file that is not of this form: no JSON, a key
/// twice, an unknown key (with the nearest known one), a different schema, and whatever Document
/// refuses.
Document read_document(const std::filesystem::path& file);

}  // namespace literate
