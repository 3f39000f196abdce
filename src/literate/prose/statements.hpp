// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "literate/document/names.hpp"
#include "literate/prose/tex_commands.hpp"

namespace literate {

/// A sentence that the computation checks, as the document's author writes it:
/// `\statement[source]{id}{sentence}`.
struct Statement {
  std::string id;                ///< of the claim
  std::string source;            ///< who else says it, and where; empty for the document's own
  std::string sentence;          ///< LaTeX
  std::string place;             ///< «report/a.tex:line:column» of the command
  std::vector<Branch> branches;  ///< of \ifflag around it, outermost first
};

/// All statements of the *.tex files below a folder, in the order of reading: each \input stands
/// where it is asked for, and files that nothing asks for come last. Throws sys::OutputError if the
/// folder or a file cannot be read.
std::vector<Statement> statements_below(const std::filesystem::path& folder);

/// «file:line:column: message» for each statement that is made twice, has no claim of its id or no
/// sentence, and for each claim without a statement; unknown names with the nearest known one.
std::vector<std::string> statement_errors(const std::vector<Statement>& statements,
                                          const Names& names);

/// «file:line:column: message» for each statement of others that is neither a quotation, \quoted,
/// nor says in its source that it is a paraphrase.
std::vector<std::string> unquoted_statements(const std::vector<Statement>& statements);

/// A statement with its number in the ledger: C1, C2, … of others, R1, R2, … of the document
/// itself.
struct NumberedStatement {
  std::string number;
  Statement statement;
};

/// The statements of the claims, numbered in their order. Those in a branch of
/// \ifflag that is not taken and ids without a claim are passed over.
std::vector<NumberedStatement> numbered_statements(const std::vector<Statement>& statements,
                                                   const Names& names);

/// What LaTeX reads besides what was computed: the sentence, source and number of each claim, and
/// how many of each part of the ledger have which verdict.
std::string statements_tex(const std::vector<Statement>& statements, const Names& names);

/// Writes what the document's folder says of claims, quotations and ages of limits, if it changed,
/// for LaTeX.
void write_statements(const std::filesystem::path& document, const Names& names,
                      const std::filesystem::path& file);

}  // namespace literate
