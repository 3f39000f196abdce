// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/references.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "literate/prose/document_files.hpp"
#include "literate/prose/quotations.hpp"
#include "literate/prose/statements.hpp"
#include "literate/prose/tex_commands.hpp"
#include "literate/prose/tex_scanner.hpp"
#include "system/files.hpp"
#include "system/nearest_name.hpp"

namespace literate {
namespace {

/// A command, what its argument names, and the names that are registered.
struct ReferenceKind {
  const char* command;
  const char* noun;
  const std::set<std::string>& names;
  const std::map<std::string, std::string>& places;  ///< where each was registered
};

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
  std::set<std::string> flags, claims, quotations;
  std::map<std::string, std::string> claim_places, quotation_places, excerpt_places;
  for (const auto& [flag, is_set] : names.flags) flags.insert(flag);
  for (const auto& [id, claim] : names.claims) {
    claims.insert(id);
    claim_places[id] = claim.place;
  }
  for (const Quotation& quotation : read_quotations(source_dir)) {
    quotations.insert(quotation.id);
    quotation_places[quotation.id] = quotation.place;
  }
  const std::array<ReferenceKind, 11> kinds{
      {{"val", "value", names.values, names.value_places},
       {"rawval", "value", names.values, names.value_places},
       {"ifflag", "flag", flags, names.flag_places},
       {"tab", "table", names.tables, names.table_places},
       {"fig", "figure", names.figures, names.figure_places},
       {"excerpt", "excerpt", names.excerpts, excerpt_places},
       {"claim", "claim", claims, claim_places},
       {"finding", "claim", claims, claim_places},
       {"findingsays", "claim", claims, claim_places},
       {"quoted", "quotation", quotations, quotation_places},
       {"quotedpage", "quotation", quotations, quotation_places}}};
  std::set<std::string> commands;
  for (const ReferenceKind& kind : kinds) commands.insert(kind.command);

  ReferenceReport report;
  std::set<std::pair<std::string, std::string>> used;
  for (const std::string& file : document_files(source_dir)) {
    const std::string text = sys::read_file(source_dir / file);
    if (prints_ledger(text)) {
      for (const std::string& claim : claims) used.emplace("claim", claim);
    }
    for (const auto& use : commands_in(text, commands)) {
      const ReferenceKind& kind = *std::ranges::find(kinds, use.name, &ReferenceKind::command);
      used.emplace(kind.noun, use.argument);
      if (kind.names.contains(use.argument) || is_left_out(use.branches, names.flags)) continue;
      const std::string place =
          fmt::format("{}/{}:{}:{}", source_label(source_dir), file, use.line, use.column);
      const bool is_flag = kind.noun == std::string_view("value") && flags.contains(use.argument);
      report.errors.push_back(
          is_flag ? fmt::format("{}: '{}' is a flag, which \\ifflag{{{}}}{{yes}}{{no}} asks for",
                                place, use.argument, use.argument)
                  : fmt::format("{}: unknown {} '{}'{}", place, kind.noun, use.argument,
                                sys::suggestion(use.argument, kind.names)));
    }
  }
  for (std::string& error : statement_errors(statements_below(source_dir), names)) {
    report.errors.push_back(std::move(error));
  }
  for (const ReferenceKind& kind : kinds) {
    if (kind.noun == std::string_view("excerpt")) continue;        // another document may print it
    if (kind.command == std::string_view("rawval")) continue;      // told already, as \val
    if (kind.command == std::string_view("quotedpage")) continue;  // as \quoted
    if (std::string_view(kind.command).starts_with("finding")) continue;  // as \claim
    for (const std::string& name : kind.names) {
      if (!used.contains({kind.noun, name})) {
        report.unused.push_back(fmt::format("{}: {} '{}'", kind.places.at(name), kind.noun, name));
      }
    }
  }
  return report;
}

}  // namespace literate
