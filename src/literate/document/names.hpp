// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "literate/excerpts/excerpt.hpp"

namespace literate {

class Document;

/// What a document may refer to, as the engine last wrote it to names.json.
struct Names {
  std::set<std::string> values;
  std::map<std::string, bool> flags;  ///< and whether they are set
  std::set<std::string> tables;
  std::set<std::string> figures;
  std::set<std::string> excerpts;
  std::set<std::string> claims;
  std::map<std::string, std::string> figure_places;  ///< where each was registered
  std::vector<std::string> faults;  ///< a line each; none if the document is to be trusted
  std::vector<std::string> files;   ///< all files written, sorted, relative to names.json
};

/// The text of names.json: all names sorted; with each value its printed text, raw number, error
/// bound, unit (those it has) and place; flags, checks and claims with their outcome; the faults.
std::string names_json(const Document& document, const std::vector<Excerpt>& excerpts,
                       const std::vector<std::string>& files);

/// Reads what names_json wrote; throws sys::OutputError naming a file that is missing or not of its
/// form.
Names read_names(const std::filesystem::path& file);

/// Only the files that a names.json lists, whichever version of the engine wrote it; none if it is
/// missing or lists none. These may be removed when they are not made again.
std::vector<std::string> former_files(const std::filesystem::path& file);

}  // namespace literate
