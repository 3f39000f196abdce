// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what a document registered as HTML for its page. LaTeX in it stands in <tex></tex>, and
// @uses:kind:name@ where the page tells who uses a name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "literate/document/ledger.hpp"
#include "literate/document/registered.hpp"

namespace literate {

/// An entry of the ledger. \LedgerNumber, \LedgerSentence and \LedgerSource are what the document
/// says of the claim; @origin@ is who states it, and @age:1@ the age of its first limit.
std::string claim_html(const Registered& registered, const LimitNotes& notes, const std::string& id,
                       const Claim& claim);

/// The notes of the limits, to which the entries lead.
std::string limits_html(const LimitNotes& notes);

/// An entry whose limits have the letters of the order of reading: `order` holds the letters that
/// claim_html gave those read so far, and those that come first here are added.
std::string lettered(const std::string& claim_html, std::vector<std::string>& order);

/// The notes in that order, with the same letters. Notes that no entry needs are left out.
std::string in_order(const std::string& limits_html, const std::vector<std::string>& order);

/// The index of values, as index_tex.
std::string index_html(const Registered& registered);

/// Where figures and tables come from, as provenance_tex.
std::string provenance_html(const Registered& registered, const std::filesystem::path& folder);

/// Writes all of these, and the tables, into a folder.
void write_page_parts(const Registered& registered, const std::filesystem::path& folder);

}  // namespace literate
