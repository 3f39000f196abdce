// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "literate/prose/tex_commands.hpp"

namespace literate {

/// A sentence of a document, as its author wrote it.
struct Sentence {
  std::string file;    ///< relative to the document's folder
  int first_line = 0;  ///< from 1
  int last_line = 0;
  std::string latex;  ///< in one line, without comments
  /// That it prints, «value x», «table x», «figure x», «claim x», counts, «claims cited», or that
  /// decide whether it is printed, «flag x».
  std::set<std::string> names;
  /// Of these, each with the options that it is printed with, an empty text for none, and «rawval »
  /// before those of \rawval.
  std::map<std::string, std::set<std::string>> styles = {};
  std::string heading = {};  ///< LaTeX, of the section that it stands in or begins with
  std::string folder = {};   ///< what messages call the document's folder, if it is known
};

/// What begins the names of counts of verdicts, «claims cited».
inline constexpr std::string_view counts_claims = "claims ";

/// The file of a sentence as messages name it, «report/sections/a.tex», and its place there,
/// «report/sections/a.tex:12».
std::string path_of(const Sentence& sentence);
std::string place_of(const Sentence& sentence);

/// Splits a LaTeX text into sentences, in order.
///
/// A sentence ends with a full stop, a question mark or an exclamation mark before a blank and
/// something that may begin a sentence, unless an abbreviation such as «Fig.» ends there; with an
/// empty line; and where a heading, an item, a caption or an environment begins or ends. Of what
/// precedes \begin{document} titles, authors and the like are, if they print a name. Whatever holds
/// no letter and no name is left out. It prints what the document's own commands in it do, and no
/// name in a branch of \ifflag that these flags do not take.
std::vector<Sentence> sentences_in(std::string_view latex, const std::string& file,
                                   const std::map<std::string, bool>& flags = {},
                                   const OwnCommands& own = {});

/// The sentences of all files of a document (document_files). Throws sys::OutputError if the folder
/// or a file cannot be read.
std::vector<Sentence> sentences_below(const std::filesystem::path& document,
                                      const std::map<std::string, bool>& flags = {});

}  // namespace literate
