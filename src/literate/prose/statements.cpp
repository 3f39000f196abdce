// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/statements.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "literate/prose/document_files.hpp"
#include "literate/prose/quotations.hpp"
#include "literate/prose/recorded_ages.hpp"
#include "literate/prose/tex_scanner.hpp"
#include "system/files.hpp"
#include "system/nearest_name.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

constexpr const char* cited = "cited";
constexpr const char* own_part = "own";

/// Takes the next group off a text, over the ends of lines, without its delimiters.
std::string take_group(std::string_view& text, char open, char close) {
  const auto begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  const std::string_view group = group_at(text.substr(begin), open, close);
  if (group.empty()) return {};
  text.remove_prefix(begin + group.size());
  return std::string(group.substr(1, group.size() - 2));
}

/// Reads the files of a document as LaTeX does, each once.
class InReadingOrder {
 public:
  explicit InReadingOrder(const std::filesystem::path& folder) {
    for (DocumentFile& file : read_document(folder)) files_.emplace(file.name, std::move(file));
    for (const auto& [name, file] : files_) {
      if (file.text.find("\\documentclass") != std::string::npos) read(name);
    }
    for (const auto& [name, file] : files_) read(name);
  }

  std::vector<Statement> statements;

 private:
  void read(const std::string& name) {
    const auto found = files_.find(name);
    if (found == files_.end() || !seen_.insert(name).second) return;
    const DocumentFile& file = found->second;
    for (const TexCommand& command : commands_in(file.text, {"statement", "input", "include"})) {
      if (command.name == "statement") {
        add(file, command);
      } else {
        read(command.argument.ends_with(".tex") ? command.argument : command.argument + ".tex");
      }
    }
  }

  void add(const DocumentFile& file, const TexCommand& command) {
    std::string_view rest = std::string_view(file.text).substr(command.end);
    Statement& statement = statements.emplace_back();
    statement.source = without_comments(take_group(rest, '[', ']'));
    statement.id = take_group(rest, '{', '}');
    statement.sentence = without_comments(take_group(rest, '{', '}'));
    statement.place = file.at(command.line, command.column);
    statement.branches = command.branches;
  }

  std::map<std::string, DocumentFile> files_;
  std::set<std::string> seen_;
};

}  // namespace

std::vector<Statement> statements_below(const std::filesystem::path& folder) {
  return InReadingOrder(folder).statements;
}

std::vector<std::string> statement_errors(const std::vector<Statement>& statements,
                                          const Names& names) {
  std::vector<std::string> errors;
  std::set<std::string> known, stated_ids;
  std::map<std::string, const Statement*> stated;
  for (const auto& [id, claim] : names.claims) known.insert(id);
  for (const Statement& statement : statements) stated_ids.insert(statement.id);
  for (const Statement& statement : statements) {
    if (is_left_out(statement.branches, names.flags)) continue;
    const auto report = [&](const std::string& message) {
      errors.push_back(fmt::format("{}: {}", statement.place, message));
    };
    if (!known.contains(statement.id)) {
      report(
          fmt::format("unknown claim '{}'{}", statement.id, sys::suggestion(statement.id, known)));
    }
    if (statement.sentence.empty()) {
      report(fmt::format("statement '{}' has no sentence", statement.id));
    }
    const auto [first, is_new] = stated.try_emplace(statement.id, &statement);
    if (!is_new) {
      report(fmt::format("claim '{}' is stated twice, first at {}", statement.id,
                         first->second->place));
    }
  }
  for (const auto& [id, claim] : names.claims) {
    if (stated.contains(id)) continue;
    stated_ids.erase(id);
    errors.push_back(fmt::format("{}: claim '{}' has no \\statement in the document{}", claim.place,
                                 id, sys::suggestion(id, stated_ids)));
  }
  return errors;
}

std::vector<std::string> unquoted_statements(const std::vector<Statement>& statements) {
  std::vector<std::string> findings;
  for (const Statement& statement : statements) {
    const bool is_quoted = statement.sentence.find("\\quoted{") != std::string::npos;
    const bool is_paraphrase = statement.source.find("paraphrase") != std::string::npos;
    if (statement.source.empty() || is_quoted || is_paraphrase) continue;
    findings.push_back(
        fmt::format("{}: statement '{}' is neither a quotation nor says 'paraphrase' in its source",
                    statement.place, statement.id));
  }
  return findings;
}

std::vector<NumberedStatement> numbered_statements(const std::vector<Statement>& statements,
                                                   const Names& names) {
  std::vector<NumberedStatement> numbered;
  int n_cited = 0, n_own = 0;
  for (const Statement& statement : statements) {
    if (is_left_out(statement.branches, names.flags)) continue;
    if (!names.claims.contains(statement.id)) continue;
    numbered.push_back(
        {statement.source.empty() ? fmt::format("R{}", ++n_own) : fmt::format("C{}", ++n_cited),
         statement});
  }
  return numbered;
}

std::string statements_tex(const std::vector<Statement>& statements, const Names& names) {
  std::string text;
  std::map<std::string, std::map<std::string, int>> counts{{cited, {}}, {own_part, {}}};
  for (const auto& [number, statement] : numbered_statements(statements, names)) {
    const NamedClaim& claim = names.claims.at(statement.id);
    const char* part = statement.source.empty() ? own_part : cited;
    auto& count = counts[part];
    ++count["all"];
    ++count[claim.found];
    if (claim.found != claim.expected) ++count["unexpected"];
    text += fmt::format("\\LiterateStatement{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}\n", statement.id, number,
                        part, statement.source, statement.sentence);
  }
  for (auto& [part, count] : counts) {
    for (const char* verdict :
         {"all", "confirmed", "partly confirmed", "refuted", "undecided", "unexpected"}) {
      text += fmt::format("\\LiterateCount{{{}}}{{{}}}{{{}}}\n", part, verdict, count[verdict]);
    }
  }
  return text;
}

void write_statements(const std::filesystem::path& document, const Names& names,
                      const std::filesystem::path& file) {
  std::filesystem::create_directories(file.parent_path());
  sys::write_if_changed(file, quotations_tex(read_quotations(document)) +
                                  statements_tex(statements_below(document), names) +
                                  RecordedAges(document, names).latex());
}

}  // namespace literate
