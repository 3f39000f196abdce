// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "literate/prose/tex_commands.hpp"

namespace literate {

/// The last part of a folder's path, by which messages name it wherever it lies.
inline std::string source_label(const std::filesystem::path& folder) {
  const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

/// The file beside the main one that is read for the page alone, and so is no part of the document.
inline constexpr std::string_view page_preamble = "page.tex";

/// Lists the LaTeX files of the document in a folder: all *.tex files in it and below but for the
/// page's, sorted, as generic paths relative to it. A folder below that has a \documentclass holds
/// a document of its own and is left out. Throws sys::OutputError if the folder or a file cannot be
/// read.
std::vector<std::string> document_files(const std::filesystem::path& source_dir);

/// One of these files.
struct DocumentFile {
  std::string name;
  std::string label;  ///< source_label and name, by which messages call it
  std::string text;

  /// «report/a.tex:line:column».
  std::string at(int line, int column) const;
};

/// The same files with their texts.
std::vector<DocumentFile> read_document(const std::filesystem::path& source_dir);

/// The commands that the files of a document, and styles (.sty) beside them, define.
OwnCommands own_commands_of(const std::filesystem::path& source_dir);

/// Finds the pictures that a document shows by \includegraphics and no program made: files of PNG,
/// JPEG or PDF of exactly the name that is given there, from the document's folder on and not above
/// it; sorted, relative to that folder. Throws sys::OutputError if the document cannot be read.
std::vector<std::string> images_of(const std::filesystem::path& source_dir);

/// The parts that a document asks for by \input or \include and that are neither in its folder, nor
/// among the generated files, nor in TeX's: each «report/a.tex:line:column: there is no file
/// 'name'», with the nearest name of a part; and bibliographies likewise, unless the document
/// brings the references as a .bbl. Names that a macro makes are left to LaTeX. Throws
/// sys::OutputError if the folder or a file cannot be read.
std::vector<std::string> missing_inputs(const std::filesystem::path& folder,
                                        const std::filesystem::path& generated);

/// The parts and files that would take the place of others without a word: an \input of the page's
/// own preamble, whose changes do not typeset the document again, and files of the document's
/// folder that bear the name of one of the `generated` files, which TeX would not find. Each is one
/// line.
std::vector<std::string> misplaced_files(const std::filesystem::path& folder,
                                         const std::vector<std::string>& generated);

}  // namespace literate
