// SPDX-License-Identifier: GPL-3.0-or-later
// What a document registered, as the macros that literate.sty reads.
#pragma once

#include <filesystem>
#include <string>

#include "literate/document/document.hpp"

namespace literate {

/// Definitions of all values, as LaTeX and as text for PDF bookmarks, of all flags and claims, and
/// what is to be stamped on every page if the document is not to be trusted.
std::string values_tex(const Document& document);

/// The ledger: how many claims fare how, and an entry for each.
std::string claims_tex(const Document& document);

/// The index of values: key, value, error and place of each.
std::string index_tex(const Document& document);

/// Where each figure and table comes from: its place in the code, and its files with their SHA-256,
/// those of tables from below `folder`, those of figures as draw_figures lists them.
std::string provenance_tex(const Document& document, const std::filesystem::path& folder);

}  // namespace literate
