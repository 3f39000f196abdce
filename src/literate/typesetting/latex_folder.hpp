// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "literate/typesetting/typeset_options.hpp"

namespace literate {

/// The files that LaTeX and latexmk wrote for themselves and read in the next run: .aux, .toc,
/// .fdb_latexmk, the log and the PDF.
///
/// A run that was interrupted or failed leaves them broken in ways that neither tool recovers from,
/// so they are kept only as a run that ended well left them. «as-left.sha256» tells: it is written
/// by keep() and removed by begin().
class LatexFolder {
 public:
  explicit LatexFolder(const TypesetOptions& options);

  /// Whether there are such files, and they are as the last run that ended well left them.
  bool is_as_left() const;

  /// Removes all of them, so that LaTeX begins from nothing. Throws sys::OutputError.
  void clear() const;

  /// From now on until keep() the files are not to be trusted.
  void begin() const;
  void keep() const;

 private:
  std::vector<std::string> files() const;
  std::string digests() const;

  std::filesystem::path folder_;
  std::string stem_;  // of the main file, which begins the names
};

}  // namespace literate
