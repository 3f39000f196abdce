// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "literate/document/document.hpp"

namespace literate {

/// Reads the document that a script in any language wrote. results.schema.json in this folder
/// describes it; the rules are those of a C++ program. An entry without a place gets the name of
/// the file. Throws Error «FILE: …» with the entry for invalid JSON, a repeated key, an unknown key
/// (with the nearest known one), a wrong type, a different schema, and whatever Document refuses.
Document read_document(const std::filesystem::path& file);

}  // namespace literate
