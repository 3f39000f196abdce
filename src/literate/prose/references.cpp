// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/references.hpp"

#include <fmt/core.h>

#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "literate/prose/document_files.hpp"
#include "literate/prose/quotations.hpp"
#include "literate/prose/statements.hpp"
#include "literate/prose/tex_commands.hpp"
#include "literate/prose/tex_scanner.hpp"
#include "system/files.hpp"
#include "system/nearest_name.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

/// A command, what its argument names, and where each name is registered.
struct ReferenceKind {
  const char* command;
  const char* noun;
  const Names::Places& places;
};

/// Whether a text prints the ledger, in which all claims stand.
bool prints_ledger(std::string_view text) {
  TexScanner scanner(text);
  while (const auto token = scanner.next()) {
    if (token->name == "claimledger") return true;
  }
  return false;
}

std::set<std::string> names_in(const Names::Places& places) {
  std::set<std::string> names;
  for (const auto& [name, place] : places) names.insert(name);
  return names;
}

}  // namespace

ReferenceReport check_references(const std::filesystem::path& source_dir, const Names& names) {
  Names::Places claims, quotations, excerpts;
  for (const auto& [id, claim] : names.claims) claims[id] = claim.place;
  for (const std::string& excerpt : names.excerpts) excerpts[excerpt];
  for (const Quotation& quotation : read_quotations(source_dir)) {
    quotations[quotation.id] = quotation.place;
  }
  const std::array<ReferenceKind, 11> kinds{{{"val", "value", names.values},
                                             {"rawval", "value", names.values},
                                             {"ifflag", "flag", names.flag_places},
                                             {"tab", "table", names.tables},
                                             {"fig", "figure", names.figures},
                                             {"excerpt", "excerpt", excerpts},
                                             {"claim", "claim", claims},
                                             {"finding", "claim", claims},
                                             {"findingsays", "claim", claims},
                                             {"quoted", "quotation", quotations},
                                             {"quotedpage", "quotation", quotations}}};
  std::set<std::string> commands;
  for (const ReferenceKind& kind : kinds) commands.insert(kind.command);

  const OwnCommands own = own_commands_of(source_dir);
  ReferenceReport report;
  std::set<std::pair<std::string, std::string>> used;
  for (const DocumentFile& file : read_document(source_dir)) {
    if (prints_ledger(file.text)) {
      for (const auto& [id, place] : claims) used.emplace("claim", id);
    }
    for (const auto& use : commands_in(file.text, commands, own)) {
      const ReferenceKind& kind = *std::ranges::find(kinds, use.name, &ReferenceKind::command);
      used.emplace(kind.noun, use.argument);
      if (kind.places.contains(use.argument) || is_left_out(use.branches, names.flags)) continue;
      const std::string place = file.at(use.line, use.column);
      const bool is_flag =
          kind.noun == std::string_view("value") && names.flags.contains(use.argument);
      report.errors.push_back(
          is_flag ? fmt::format("{}: '{}' is a flag, which \\ifflag{{{}}}{{yes}}{{no}} asks for",
                                place, use.argument, use.argument)
                  : fmt::format("{}: unknown {} '{}'{}", place, kind.noun, use.argument,
                                sys::suggestion(use.argument, names_in(kind.places))));
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
    for (const auto& [name, place] : kind.places) {
      if (!used.contains({kind.noun, name})) {
        report.unused.push_back(fmt::format("{}: {} '{}'", place, kind.noun, name));
      }
    }
  }
  return report;
}

namespace {

/// A folder of generated files, the command that reads one of them, and what that is called.
struct GeneratedKind {
  const char* folder;
  const char* command;
  const char* noun;
};
constexpr std::array<GeneratedKind, 3> kinds{
    {{"tables", "tab", "table"}, {"figures", "fig", "figure"}, {"excerpts", "excerpt", "excerpt"}}};

/// The places at which the document gives a command a name, each «folder/file.tex:line».
std::vector<std::string> uses(const char* command, std::string_view name,
                              const std::filesystem::path& source_dir) {
  std::vector<std::string> places;
  for (const DocumentFile& file : read_document(source_dir)) {
    for (const TexCommand& use : commands_in(file.text, {command})) {
      if (use.argument == name) places.push_back(fmt::format("{}:{}", file.label, use.line));
    }
  }
  return places;
}

/// The first brace that nothing closes, «folder/file.tex:line:column: »; empty if there is none.
std::string place_of_open_brace(const std::filesystem::path& source_dir) {
  for (const DocumentFile& file : read_document(source_dir)) {
    std::vector<std::string_view> open;
    TexScanner scanner(file.text);
    while (const auto token = scanner.next()) {
      if (token->kind == TexKind::open) open.push_back(token->text);
      if (token->kind == TexKind::close && !open.empty()) open.pop_back();
    }
    if (open.empty()) continue;
    const TexPlace place = place_in(file.text, open.back());
    return file.at(place.line, place.column) + ": ";
  }
  return {};
}

/// The lines of a paragraph that ends in line `last`, as far as they stand in this text. TeX tells
/// only the number of the line where it began, which may be a line of another file, such as that of
/// a table. No paragraph reaches across the begin or the end of a float.
std::pair<int, int> paragraph_before(std::string_view text, int first, int last) {
  static const sys::Pattern float_ends(
      R"(^\s*\\(begin|end)\{(?:sub|wrap|sideways)?(?:table|figure)\*?\})");
  int begin = 1, number = 0;
  for (const std::string_view line : sys::lines_of(text)) {
    if (++number >= last) break;
    if (sys::stripped(line).empty()) begin = number + 1;
    if (const auto found = float_ends.find_in(line)) begin = number + (found->parts[1] == "end");
  }
  return {first >= begin && first <= last ? first : begin, last};
}

/// Tells a box that does not fit at the first figure or table in its lines, and names them all:
/// «report/a.tex:12: in figure 'name': Overfull …».
std::string with_name_of_box(const std::string& message, const std::filesystem::path& source_dir) {
  static const sys::Pattern box(
      R"(^([^\n]+\.tex):(\d+): (Overfull [^\n]*?(?:at lines? (\d+)(?:--(\d+))?)[^\n]*)$)");
  const auto match = box.find_in(message);
  if (!match) return message;
  const std::vector<std::string_view>& parts = match->parts;
  const std::string label = source_label(source_dir) + "/";
  if (!parts[1].starts_with(label)) return message;
  const std::filesystem::path file = source_dir / parts[1].substr(label.size());
  if (!std::filesystem::is_regular_file(file)) return message;
  const std::string text = sys::read_file(file);
  const int told = std::stoi(std::string(parts[4]));
  const auto [first, last] =
      paragraph_before(text, told, parts[5].empty() ? told : std::stoi(std::string(parts[5])));
  int line = first;
  std::vector<std::string> names;
  for (const TexCommand& use : commands_in(text, {"fig", "tab", "includegraphics"})) {
    if (use.line < first || use.line > last) continue;
    if (names.empty()) line = use.line;
    const char* const noun = use.name == "fig" ? "figure" : use.name == "tab" ? "table" : "picture";
    names.push_back(fmt::format("{} '{}'", noun, use.argument));
  }
  const std::string in = names.empty() ? "" : fmt::format("in {}: ", fmt::join(names, ", "));
  return fmt::format("{}:{}: {}{}", parts[1], line, in, parts[3]);
}

/// «figures/a.gp:3, drawn for », where the script of a figure, or the style that all share, has the
/// command at which LaTeX stopped; empty if that is not known.
std::string place_in_script(std::string_view message, std::string_view figure,
                            const std::filesystem::path& scripts) {
  static const sys::Pattern stopped(R"(\n\s*<[a-z ]+> [^\n]*(\\[A-Za-z@]+)\s*(?:\n|$))");
  const auto found = stopped.find_in(message);
  if (!found) return "";
  for (const std::string& script : {fmt::format("{}.gp", figure), std::string("style.gp")}) {
    if (!std::filesystem::is_regular_file(scripts / script)) continue;
    const std::string text = sys::read_file(scripts / script);
    int number = 0;
    for (const std::string_view line : sys::lines_of(text)) {
      ++number;
      if (line.find(found->parts[1]) != line.npos) {
        return fmt::format("{}/{}:{}, drawn for ", scripts.filename().string(), script, number);
      }
    }
  }
  return "";
}

}  // namespace

std::string with_place_of_use(const std::string& message, const std::filesystem::path& source_dir,
                              const std::filesystem::path& scripts) {
  // Only the first line is rewritten. The lines after it show the place in the generated file.
  static const sys::Pattern generated(
      R"(^(?:\S.*/)?((tables|figures|excerpts)/(?:[^/:]+/)?([^/:]+)\.(?:tex|txt)(?::\d+)?):\s*([^\n]*))");
  static const sys::Pattern twice(R"(LaTeX Warning: Label `([^']+)' multiply defined)");
  if (const auto label = twice.find_in(message)) {
    const std::vector<std::string> places = uses("label", label->parts[1], source_dir);
    if (places.size() < 2) return message;
    return fmt::format("{}: label '{}' is defined more than once", fmt::join(places, " and "),
                       label->parts[1]);
  }
  if (message.starts_with("! File ended while scanning")) {
    const std::string place = place_of_open_brace(source_dir);
    return place.empty() ? message : place + "this brace is not closed\n  " + message;
  }
  const auto match = generated.find_in(message);
  if (!match) return with_name_of_box(message, source_dir);
  const std::vector<std::string_view>& parts = match->parts;
  for (const GeneratedKind& kind : kinds) {
    if (parts[2] != kind.folder) continue;
    const std::vector<std::string> places = uses(kind.command, parts[3], source_dir);
    if (places.empty()) return message;
    const std::string in_script =
        parts[2] == "figures" ? place_in_script(message, parts[3], scripts) : "";
    return fmt::format("{}{}: in {} '{}': {} ({}){}", in_script, fmt::join(places, " or "),
                       kind.noun, parts[3], parts[4], parts[1], match->rest);
  }
  return message;
}

}  // namespace literate
