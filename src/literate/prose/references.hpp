// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "literate/document/names.hpp"

namespace literate {

/// How the names in a document compare with those registered.
struct ReferenceReport {
  /// «folder/file.tex:line:column: unknown value 'x', did you mean 'y'?», in the order of the text.
  std::vector<std::string> errors;
  /// «value 'x'», «table 'y'» …: registered and not used anywhere, by kind and name. Excerpts are
  /// not among them, nor claims if the document prints its ledger.
  std::vector<std::string> unused;
};

/// Looks up each \val, \ifflag, \tab, \fig, \excerpt and \claim of the *.tex files below a folder.
/// In a branch of \ifflag that the document does not take, names need not be registered.
///
/// Files are named with the folder's own last name in front. Throws sys::OutputError if the folder
/// or a file cannot be read.
ReferenceReport check_references(const std::filesystem::path& source_dir, const Names& names);

}  // namespace literate
