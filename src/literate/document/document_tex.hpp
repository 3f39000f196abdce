// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what a document registered as the macros that literate.sty reads.
#pragma once

#include <filesystem>
#include <string>

#include "literate/document/registered.hpp"

namespace literate {

/// Defines all values, as LaTeX and as text for PDF bookmarks, all flags and claims, and the stamp
/// for every page of a document that is not to be trusted.
std::string values_tex(const Registered& registered);

/// What is not known of a value, as LaTeX in the unit in which it is printed: «error $\le$ …»,
/// «standard uncertainty …», «exact»; empty if nobody told it.
std::string error_tex(const Value& value);

/// Writes the index of values: key, value, error bound and place of each.
std::string index_tex(const Registered& registered);

/// values.csv: key, printed text, unrounded number, bound of its error, unit and place in the code
/// of every value; and sources.csv: kind, name, place and function of each figure, table and claim.
/// Both as RFC 4180 has it.
std::string values_csv(const Registered& registered);
std::string sources_csv(const Registered& registered);

/// Writes where each figure and table comes from: its place in the code, and its files with their
/// SHA-256. Those of tables lie below `folder`; those of figures are listed by draw_figures.
std::string provenance_tex(const Registered& registered, const std::filesystem::path& folder);

}  // namespace literate
