// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// Words of another text, which the document prints between quotation marks: `\quoted{id}`.
struct Quotation {
  std::string id;
  std::string page;   ///< of the other text
  std::string words;  ///< plain text, letter for letter
  std::string place;  ///< «folder/quotations.toml:line:column»
};

/// Reads quotations.toml of a document's folder, a table a quotation, in the order of the file:
///
///   [nearly-identical]
///   page = 8
///   words = "The displacements are nearly identical under the loaded region"
///
/// None without that file. Throws sys::InputError with file, line and column for text that is not
/// TOML, a key that is missing or unknown, a page that is no whole number or text, and empty words.
std::vector<Quotation> read_quotations(const std::filesystem::path& folder);

/// Holds every quotation against the text that is quoted, letter for letter but for white space and
/// hyphens at the ends of lines. One that is not there is told by its place, the longest beginning
/// that is there, the line of the text, and what follows in both.
std::vector<std::string> quotation_errors(const std::vector<Quotation>& quotations,
                                          const std::filesystem::path& text_file);

/// The words as LaTeX. A straight mark of quotation opens at the beginning and behind a blank, a
/// bracket or a dash, and closes elsewhere.
std::string words_latex(const Quotation& quotation);

/// «\LiterateQuotation{id}{page}{words}» for each.
std::string quotations_tex(const std::vector<Quotation>& quotations);

}  // namespace literate
