// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "literate/document/registered.hpp"
#include "literate/excerpts/excerpt.hpp"

namespace literate {

/// A limit of a claim, which decides one of its criteria.
struct NamedLimit {
  std::string quantity;   ///< the name of the criterion
  std::string condition;  ///< «at most 1 %»
  std::string reason;     ///< «choice: a tenth»
};

/// What names.json says of a claim.
struct NamedClaim {
  std::string place;     ///< «file:line:column» of its registration
  std::string expected;  ///< verdict
  std::string found;
  std::vector<NamedLimit> limits = {};  ///< in the order of the criteria
};

/// A text of the program that reaches the document, and where it was registered.
struct NamedText {
  std::string what;   ///< «route of claim 'x'»
  std::string place;  ///< «file:line»
  std::string latex;
};

/// A number as names.json stores it, for printing it in another way.
struct StoredNumber {
  double number = 0;                       ///< of a percentage the ratio
  std::optional<Uncertainty> uncertainty;  ///< none of a number whose error nobody told
  std::string unit;
  Notation notation = Notation::significant;
  int digits = 0;      ///< that its format names
  int last_place = 0;  ///< of the printed digits, in the unit of `number` before any conversion
  bool is_exact = false;
  bool is_percentage = false;
  bool rounds_up = false;
  bool tells_kinds = false;
  double conversion = 1;  ///< from the unit that last_place counts in
};

/// The names that a document may refer to, read from names.json.
struct Names {
  using Places = std::map<std::string, std::string>;  ///< where each was registered, by its name

  Places values, tables, figures;
  std::map<std::string, StoredNumber> numbers;  ///< of those values that are no texts
  std::map<std::string, bool> flags;            ///< with whether they are set
  Places flag_places;
  std::set<std::string> excerpts;
  std::map<std::string, NamedClaim> claims;
  std::vector<NamedText> texts;     ///< of the program that reach the document
  std::vector<std::string> faults;  ///< a line each; empty if the document is to be trusted
  std::vector<std::string> claim_notes = {};  ///< what an author should know of the claims
  std::vector<std::string> files;             ///< all files written, sorted, relative to names.json
  std::string case_sha256 = {};  ///< of the case as the computation read it; empty if not told
};

/// Writes names.json: all names, sorted; for each value its printed text and its place, and its
/// number, what is not known of it, unit and style if it has them; flags, checks and claims with
/// their outcome; faults.
std::string names_json(const Registered& registered, const std::vector<Excerpt>& excerpts,
                       const std::vector<std::string>& files);

/// Reads what names_json wrote; throws sys::OutputError naming a file that is missing or malformed.
Names read_names(const std::filesystem::path& file);

/// Only the files that a names.json lists, whichever version of the engine wrote it; none if it is
/// missing or lists none. These may be removed when they are not made again.
std::vector<std::string> former_files(const std::filesystem::path& file);

}  // namespace literate
