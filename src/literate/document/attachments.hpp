// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace literate {

/// A file from outside the program that values came from, or the script that wrote it.
struct AttachedFile {
  std::string name;  ///< relative to the checkout; letters, digits and _ + . , = / - only
  std::string text;  ///< its bytes
  std::string kind;  ///< what it is to the document, such as «numbers» or «script»
};

/// The files from outside the program that a document keeps with it.
class Attachments {
 public:
  /// Keeps a file; the same one may come again. Throws std::logic_error if another content is kept
  /// under its name.
  void add(const AttachedFile& file);

  /// Keeps all files of `others`, as add() does.
  void add(const Attachments& others);

  /// The SHA-256 of each file, by name.
  std::map<std::string, std::string> digests() const;

  /// Writes all files below a folder, by name. Throws sys::OutputError.
  void write(const std::filesystem::path& folder) const;

  /// The list of the files with their digests for LaTeX, which attaches them to the PDF; `folder`
  /// is where they lie relative to the other generated files.
  std::string latex(const std::string& folder) const;

 private:
  std::map<std::string, AttachedFile> files_;
};

}  // namespace literate
