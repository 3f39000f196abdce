// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace literate {

/// A number in the document's text or in a table, the bound of its error, and its printed text.
struct ManifestNumber {
  double number = 0;
  std::optional<double> abs_error;  ///< none if the number is exact or its error unknown
  std::string printed;
  double standard = 0;                                  ///< its standard uncertainty, if it has one
  std::optional<std::pair<double, double>> sides = {};  ///< bounds below and above, if they differ
  std::optional<std::string> unit = {};  ///< none where an earlier version did not tell it
};

/// The sources and tools that a document was made with, and the results. It names no folder of the
/// machine and no time of the clock, so two runs of the same sources with the same tools have equal
/// manifests.
struct Manifest {
  using Texts = std::map<std::string, std::string>;

  std::string project;
  std::map<std::string, Texts> facts;  ///< by topic, such as "libraries"
  Texts inputs;                        ///< the SHA-256 of each file, by its relative name
  Texts outputs;
  std::map<std::string, ManifestNumber> numbers;
  Texts verdicts;     ///< of each claim, and whether each check passed
  Texts limits = {};  ///< of each claim's criteria, «claim x: quantity»: «at most 1 %»
  Texts texts = {};  ///< «value x», «table x, row 1, column 2» and «flag x» that are no numbers,
                     ///< and what criteria found, «claim x: quantity»
  Texts outcomes = {};  ///< of criteria, by the same names: «holds»; an earlier version has none
  /// What the program says in words: «claim x: route», «claim x: quantity: reason» and «… margin»,
  /// «check x: statement», «value x: sources of uncertainty», «table x: headings» and «table x:
  /// notes», and, as the ledger has it, «claim x: quantity: age of the limit». An earlier version
  /// has none, or fewer.
  Texts words = {};
  Texts ages = {};  ///< of limits, by the same names, as dated_limits() tells them
  bool is_of_earlier_version = false;  ///< whether limits, texts or outcomes were not told then
};

/// Returns the SHA-256 of files in a folder, by `prefix` + file; throws sys::OutputError for a file
/// that cannot be read.
Manifest::Texts digests(const std::filesystem::path& folder, const std::vector<std::string>& files,
                        const std::string& prefix = "");

/// The results that the names.json of Document::write tells of, as the manifest of a project
/// without the rest. Throws sys::OutputError naming a file that is missing or malformed.
Manifest results_in(const std::filesystem::path& names_json, const std::string& project);

/// The flags, by name, that a manifest has among its texts.
std::map<std::string, bool> flags_of(const Manifest& manifest);

/// The SHA-256 of the files that values were imported from, with their scripts, by name, as
/// names.json lists them. Throws sys::OutputError as results_in does.
Manifest::Texts imported_files(const std::filesystem::path& names_json);

/// Writes the manifest as JSON with sorted keys.
std::string manifest_json(const Manifest& manifest);

/// The sum of the bounds of two numbers, each towards the other. Both must have one.
double bounds_between(const ManifestNumber& a, const ManifestNumber& b);

/// Whether two numbers are known to be in different units.
bool have_other_units(const ManifestNumber& a, const ManifestNumber& b);

/// Whether two numbers are in one unit and differ by no more than the sum of their error bounds or,
/// if one has no bound, are printed the same.
bool agree(const ManifestNumber& a, const ManifestNumber& b);

/// Reads what manifest_json wrote. Throws sys::OutputError naming the file if it cannot be read, is
/// not JSON or not a manifest, or belongs to another project.
Manifest read_manifest(const std::filesystem::path& file, const std::string& project);

/// The same of a text, which messages call `file`.
Manifest manifest_of(const std::string& json_text, const std::string& file,
                     const std::string& project);

/// How a document differs from the same one made elsewhere.
struct ManifestComparison {
  std::vector<std::string> changed_outputs;  ///< files whose bytes differ or that one of them lacks
  std::vector<std::string> reasons;          ///< each tool or input that differs, a line each
  std::vector<std::string> moved;            ///< numbers beyond their errors, and other verdicts
  bool has_same_results =
      false;  ///< numbers, verdicts, limits and texts are the same to the letter
};

/// Compares the bytes of files, verdicts and numbers: two numbers agree if they differ by no more
/// than the sum of their error bounds, or, if one has no bound, if they are printed the same.
ManifestComparison compare(const Manifest& theirs, const Manifest& ours);

}  // namespace literate
