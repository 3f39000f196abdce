// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace literate {

/// A number of the document, how wrong it may be, and how it is printed.
struct ManifestNumber {
  double number = 0;
  std::optional<double> abs_error;  ///< none for a number that is exact or whose error is not known
  std::string printed;
};

/// What a document was made from and with, and what came of it. It names no folder of the machine
/// and no time of the clock: two runs of the same sources with the same tools have the same one.
struct Manifest {
  using Texts = std::map<std::string, std::string>;

  std::string project;
  std::map<std::string, Texts> facts;  ///< by part, such as "libraries"
  Texts inputs;                        ///< the SHA-256 of each file, by its relative name
  Texts outputs;
  std::map<std::string, ManifestNumber> numbers;
};

/// The SHA-256 of files, relative to a folder, by `prefix` + file. Throws sys::OutputError.
Manifest::Texts digests(const std::filesystem::path& folder, const std::vector<std::string>& files,
                        const std::string& prefix = "");

/// All values of names.json (as Document::write made it) that have a number. Throws
/// sys::OutputError naming a file that is missing or not of its form.
std::map<std::string, ManifestNumber> numbers_in(const std::filesystem::path& names_json);

/// The SHA-256 of the files that values were imported from, with their scripts, by name, as
/// names.json lists them. Throws sys::OutputError as numbers_in does.
Manifest::Texts imported_files(const std::filesystem::path& names_json);

/// As JSON, all keys sorted.
std::string manifest_json(const Manifest& manifest);

/// Reads what manifest_json wrote. Throws sys::OutputError naming the file if it cannot be read, is
/// no JSON, no manifest, or another project's.
Manifest read_manifest(const std::filesystem::path& file, const std::string& project);

}  // namespace literate
