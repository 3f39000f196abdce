// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what a document registered as HTML for its page. LaTeX in it stands in <tex></tex>, and
// @uses:kind:name@ where the page tells who uses a name.
#pragma once

#include <filesystem>
#include <string>

#include "literate/document/ledger.hpp"
#include "literate/document/registered.hpp"

namespace literate {

/// An entry of the ledger. \LedgerNumber, \LedgerSentence and \LedgerSource are what the document
/// says of the claim; @origin@ is who states it.
std::string claim_html(const Registered& registered, const LimitNotes& notes, const std::string& id,
                       const Claim& claim);

/// The notes of the limits, to which the entries lead.
std::string limits_html(const LimitNotes& notes);

/// The index of values, as index_tex.
std::string index_html(const Registered& registered);

/// Where figures and tables come from, as provenance_tex.
std::string provenance_html(const Registered& registered, const std::filesystem::path& folder);

/// Writes all of these, and the tables, into a folder.
void write_page_parts(const Registered& registered, const std::filesystem::path& folder);

}  // namespace literate
