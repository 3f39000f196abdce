// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/references.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

#include "literate/prose/document_files.hpp"
#include "literate/prose/source_label.hpp"
#include "literate/prose/tex_commands.hpp"
#include "literate/prose/tex_scanner.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

/// A command, what its argument names, and the names that are registered.
struct ReferenceKind {
  const char* command;
  const char* noun;
  const std::set<std::string>& names;
};

/// Counts the single-letter edits that turn one text into the other (Levenshtein's distance).
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

/// Suggests the nearest name, unless more than a third of the letters would have to change.
std::string suggestion(const std::string& unknown, const std::set<std::string>& names) {
  const auto nearest = std::ranges::min_element(
      names, {}, [&](const std::string& name) { return distance(unknown, name); });
  if (nearest == names.end()) return "";
  const std::size_t limit = std::max<std::size_t>(2, unknown.size() / 3);
  if (distance(unknown, *nearest) > limit) return "";
  return fmt::format(", did you mean '{}'?", *nearest);
}

/// Whether a use stands in a branch that this document does not take.
bool is_left_out(const TexCommand& use, const Names& names) {
  return std::ranges::any_of(use.branches, [&](const Branch& branch) {
    const auto flag = names.flags.find(branch.flag);
    return flag != names.flags.end() && flag->second != branch.is_yes;
  });
}

/// Whether a text prints the ledger, in which all claims stand.
bool prints_ledger(std::string_view text) {
  TexScanner scanner(text);
  while (const auto token = scanner.next()) {
    if (token->name == "claimledger") return true;
  }
  return false;
}

}  // namespace

ReferenceReport check_references(const std::filesystem::path& source_dir, const Names& names) {
  std::set<std::string> flags;
  for (const auto& [flag, is_set] : names.flags) flags.insert(flag);
  const std::array<ReferenceKind, 7> kinds{{{"val", "value", names.values},
                                            {"rawval", "value", names.values},
                                            {"ifflag", "flag", flags},
                                            {"tab", "table", names.tables},
                                            {"fig", "figure", names.figures},
                                            {"excerpt", "excerpt", names.excerpts},
                                            {"claim", "claim", names.claims}}};
  std::set<std::string> commands;
  for (const ReferenceKind& kind : kinds) commands.insert(kind.command);

  ReferenceReport report;
  std::set<std::pair<std::string, std::string>> used;
  for (const std::string& file : document_files(source_dir)) {
    const std::string text = sys::read_file(source_dir / file);
    if (prints_ledger(text)) {
      for (const std::string& claim : names.claims) used.emplace("claim", claim);
    }
    for (const auto& use : commands_in(text, commands)) {
      const ReferenceKind& kind = *std::ranges::find(kinds, use.name, &ReferenceKind::command);
      used.emplace(kind.noun, use.argument);
      if (kind.names.contains(use.argument) || is_left_out(use, names)) continue;
      report.errors.push_back(
          fmt::format("{}/{}:{}:{}: unknown {} '{}'{}", source_label(source_dir), file, use.line,
                      use.column, kind.noun, use.argument, suggestion(use.argument, kind.names)));
    }
  }
  for (const ReferenceKind& kind : kinds) {
    if (kind.noun == std::string_view("excerpt")) continue;    // another document may print it
    if (kind.command == std::string_view("rawval")) continue;  // told already, as \val
    for (const std::string& name : kind.names) {
      if (!used.contains({kind.noun, name})) {
        report.unused.push_back(fmt::format("{} '{}'", kind.noun, name));
      }
    }
  }
  return report;
}

}  // namespace literate
