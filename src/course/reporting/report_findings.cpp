// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/marked_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string_view>

#include "course/assignment/student.hpp"
#include "literate/prose/prose.hpp"
#include "literate/prose/tex_scanner.hpp"
#include "literate/typesetting/latex_log.hpp"
#include "system/text.hpp"

namespace course {
namespace {

constexpr const char* report_file = "report/report.tex";

/// A command that a text defines.
struct Definition {
  std::string name;  ///< without backslash; empty if the name is not written there
  literate::TexPlace place;
};

/// \DeclareCommandCopy, \NewExpandableDocumentCommand and their like.
bool is_of_the_kernel(std::string_view command) {
  return command.find("Command") != command.npos &&
         std::ranges::any_of(std::array{"New", "Renew", "Provide", "Declare"},
                             [&](const char* begin) { return command.starts_with(begin); });
}

bool defines(std::string_view command) {
  static const std::set<std::string_view> all = {"newcommand", "renewcommand", "providecommand",
                                                 "def",        "edef",         "gdef",
                                                 "xdef",       "let",          "addto"};
  return is_of_the_kernel(command) || all.contains(command);
}

/// The name of \name or of \, and its like; empty if the token is no command.
std::string name_of(const literate::TexToken& token) {
  const bool is_command =
      token.kind == literate::TexKind::command || token.kind == literate::TexKind::symbol;
  if (!is_command) return "";
  return std::string(token.name.empty() ? token.text.substr(1) : token.name);
}

/// What \newcommand and its like define by `token`. A parameter, as #1, stands for a name that is
/// written elsewhere, and so do what makes names and what is expanded first.
Definition definition_by(const literate::TexToken& token, std::string_view text) {
  const std::string name = name_of(token);
  const bool is_made = name == "csname" || name == "expandafter";
  return {is_made ? "" : name, literate::place_in(text, token.text)};
}

bool may_stand_before_a_name(const literate::TexToken& token) {
  return token.kind == literate::TexKind::open || token.kind == literate::TexKind::comment ||
         sys::stripped(token.text).empty();
}

/// Finds \newcommand*\name, \def\name and their like.
std::vector<Definition> definitions_in(std::string_view text) {
  std::vector<Definition> definitions;
  literate::TexScanner scanner(text);
  bool is_awaited = false;
  while (const auto token = scanner.next()) {
    if (is_awaited && may_stand_before_a_name(*token)) continue;
    if (is_awaited) definitions.push_back(definition_by(*token, text));
    is_awaited = !is_awaited && defines(name_of(*token));
  }
  return definitions;
}

/// The commands that stand in a text.
std::set<std::string> commands_in(std::string_view text) {
  std::set<std::string> names;
  literate::TexScanner scanner(text);
  while (const auto token = scanner.next()) {
    const std::string name = name_of(*token);
    if (!name.empty()) names.insert(name);
  }
  return names;
}

std::string at(const char* file, const literate::TexPlace& place, const std::string& what) {
  return fmt::format("{}:{}:{}: {}", file, place.line, place.column, what);
}

/// The place of the first byte that is no UTF-8.
std::optional<literate::TexPlace> place_of_no_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const sys::Utf8Character next = sys::first_character(text.substr(i));
    if (!next.code_point) return literate::place_in(text, text.substr(i));
    i += next.bytes.size();
  }
  return std::nullopt;
}

std::vector<std::string> told_by_latex(const std::string& log) {
  constexpr std::size_t most = 100;  // as many as TeX tells
  std::vector<std::string> findings;
  for (const std::string& error : literate::latex_errors(log, "report")) {
    if (findings.size() == most) {
      findings.push_back(std::string(report_file) + ": there are more errors in typeset.log");
      break;
    }
    findings.push_back(error.substr(0, error.find('\n')));
  }
  return findings;
}

/// Commands that reach under LaTeX's surface:
constexpr std::string_view unusual =
    // that make or change names
    "csname expandafter let futurelet @namedef @nameuse makeatletter primitive csdef cslet "
    "letcs csuse patchcmd apptocmd pretocmd robustify newrobustcmd renewrobustcmd "
    "renewenvironment ExplSyntaxOn "
    // that make characters and numbers of others
    "catcode lccode uccode lowercase uppercase scantokens number romannumeral char chardef "
    "symbol mathchar mathchardef mathcode DeclareMathSymbol numexpr dimexpr endlinechar "
    "escapechar "
    // that skip text, or read and write files
    "iffalse include openin openout read write immediate special jobname "
    // that act later, or keep LaTeX from saying something
    "everypar everyeof everyjob AtBeginDocument AtEndDocument AddToHook batchmode "
    "errorstopmode scrollmode interactionmode ";

/// Those of pdfTeX all begin with «pdf».
bool is_unusual(std::string_view command) {
  static const std::vector<std::string> all = sys::split(unusual, ' ');
  return std::ranges::find(all, command) != all.end() || is_of_the_kernel(command) ||
         command.starts_with("pdf");
}

/// Each of them once, where it stands first; so too notations of characters by their codes, and
/// other files that are read.
std::vector<std::string> unusual_commands(std::string_view text) {
  std::vector<std::string> findings;
  std::set<std::string, std::less<>> told;
  const auto tell = [&](std::string_view what, std::string_view place) {
    if (!told.emplace(what).second) return;
    findings.push_back(
        at(report_file, literate::place_in(text, place),
           fmt::format("{} is not needed in an ordinary report; see what it does", what)));
  };
  literate::TexScanner scanner(text);
  while (const auto token = scanner.next()) {
    if (token->kind == literate::TexKind::command) {
      const bool reads_another = token->name == "input" &&
                                 literate::argument_at(scanner.rest()) != "generated/numbers.tex";
      if (reads_another || is_unusual(token->name)) tell(token->text, token->text);
    }
  }
  if (const auto code = text.find("^^"); code != text.npos) tell("^^", text.substr(code));
  return findings;
}

/// Why a definition in the report is to be looked at; empty if it is an ordinary one. A number is
/// forged by other commands in it, as \, too.
std::string fault_in(const Definition& definition, const std::set<std::string>& computed) {
  if (definition.name.empty()) return "defines a command whose name is not written there";
  const std::string name = shown_name(definition.name);
  if (computed.contains(definition.name)) {
    return fmt::format("\\{} is defined anew, but numbers.tex has it", name);
  }
  if (definition.name == "includegraphics" || definition.name == "input") {
    return fmt::format("\\{} is defined anew, but shows what the program computes", name);
  }
  return "";
}

/// The texts, those of the report in UTF-8.
ReportTexts readable(ReportTexts texts) {
  if (place_of_no_utf8(texts.report)) {
    texts.report = shown(texts.report, std::numeric_limits<std::size_t>::max());
  }
  return texts;
}

void append(std::vector<std::string>& findings, std::vector<std::string> more) {
  for (const std::string& finding : more) findings.push_back(shown_name(finding));
}

}  // namespace

std::vector<std::string> findings_of_commands(const ReportTexts& given) {
  std::vector<std::string> findings;
  if (const auto place = place_of_no_utf8(given.report)) {
    findings.push_back(at(report_file, *place, "this is no UTF-8"));
  }
  const ReportTexts texts = readable(given);
  append(findings, told_by_latex(texts.log));
  const std::set<std::string> computed = commands_in(texts.computed);
  for (const Definition& definition : definitions_in(texts.report)) {
    const std::string fault = fault_in(definition, computed);
    if (!fault.empty()) findings.push_back(at(report_file, definition.place, fault));
  }
  append(findings, unusual_commands(texts.report));
  return findings;
}

std::vector<std::string> findings_of_numbers(const ReportTexts& given) {
  const ReportTexts texts = readable(given);
  std::vector<std::string> findings;
  append(findings, literate::typed_numbers(texts.report, report_file));
  return findings;
}

}  // namespace course
