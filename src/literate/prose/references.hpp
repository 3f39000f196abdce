// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "literate/document/names.hpp"

namespace literate {

/// The names in a document that are not registered, and those registered that it does not use.
struct ReferenceReport {
  /// «folder/file.tex:line:column: unknown value 'x', did you mean 'y'?», in the order of the text.
  std::vector<std::string> errors;
  /// What is registered but never used, sorted by kind and name: «value 'x'», «table 'y'». Excerpts
  /// are not listed, and claims are not if the document prints its ledger.
  std::vector<std::string> unused;
};

/// Looks up each \val, \rawval, \ifflag, \tab, \fig, \excerpt and \claim of the *.tex files below a
/// folder, and holds its statements against the claims (statement_errors).
/// Names in a branch of \ifflag that the document does not take need not be registered.
///
/// Messages put source_label in front of the files' names. Throws sys::OutputError if the folder or
/// a file cannot be read.
ReferenceReport check_references(const std::filesystem::path& source_dir, const Names& names);

/// Rewrites a message of LaTeX («file:line: message») about a generated table, figure or excerpt so
/// that it names the place at which the document uses that, where its author can mend it:
/// «report/part.tex:12: in table 'name': message (tables/name.tex:3)». Of a figure, the line of its
/// script that has the command at which LaTeX stopped comes first. Returns other messages as
/// they are, but names the figures and tables that stand in the lines of an overfull box:
/// «report/part.tex:12: in figure 'name': Overfull …», and names all places of a label that is
/// defined more than once, and that of a brace that nothing closes. Throws sys::OutputError if the
/// document cannot be read.
std::string with_place_of_use(const std::string& message, const std::filesystem::path& source_dir,
                              const std::filesystem::path& scripts = {});

}  // namespace literate
