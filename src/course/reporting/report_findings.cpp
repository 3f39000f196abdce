// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/reporting/report_findings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "course/assignment/student_text.hpp"
#include "literate/prose/prose_lint.hpp"
#include "literate/prose/tex_scanner.hpp"
#include "literate/typesetting/latex_log.hpp"
#include "system/lines.hpp"
#include "system/nearest_name.hpp"
#include "system/utf8.hpp"

namespace course {
namespace {

constexpr const char* report_file = "report/report.tex";
constexpr const char* numbers_file = "report/generated/numbers.tex";

/// A command that a text defines.
struct Definition {
  std::string name, value;
  literate::TexPlace place;
};

bool defines(std::string_view command) {
  static const std::set<std::string_view> all = {"newcommand",
                                                 "newcommand*",
                                                 "renewcommand",
                                                 "renewcommand*",
                                                 "providecommand",
                                                 "providecommand*",
                                                 "DeclareRobustCommand",
                                                 "DeclareRobustCommand*",
                                                 "NewDocumentCommand",
                                                 "RenewDocumentCommand",
                                                 "DeclareDocumentCommand",
                                                 "def",
                                                 "edef",
                                                 "gdef",
                                                 "xdef",
                                                 "let"};
  return all.contains(command);
}

/// Finds \newcommand*\name{value}, \def\name{value} and their like.
std::vector<Definition> definitions_in(std::string_view text) {
  constexpr std::size_t reach = 4096;  // no number is longer
  std::vector<Definition> definitions;
  literate::TexScanner scanner(text);
  bool is_awaited = false;
  while (const auto token = scanner.next()) {
    using literate::TexKind;
    if (is_awaited && token->kind == TexKind::command) {
      std::string_view rest = scanner.rest().substr(0, reach);
      if (rest.starts_with('}')) rest.remove_prefix(1);
      rest.remove_prefix(literate::group_at(rest, '[', ']').size());
      definitions.push_back({std::string(token->name), std::string(literate::argument_at(rest)),
                             literate::place_in(text, token->text)});
      is_awaited = false;
    } else if (token->kind == TexKind::command) {
      is_awaited = defines(token->name);
    } else {
      const bool may_stand_between = token->kind == TexKind::open ||
                                     token->kind == TexKind::comment ||
                                     sys::stripped(token->text).empty();
      is_awaited = is_awaited && may_stand_between;
    }
  }
  return definitions;
}

std::set<std::string> names_of(const std::vector<Definition>& definitions) {
  std::set<std::string> names;
  for (const Definition& definition : definitions) names.insert(definition.name);
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

/// One error of the log: «file:line: message», and below it «  l.12 text up to the place».
class LoggedError {
 public:
  explicit LoggedError(std::string_view error) : message_(error.substr(0, error.find('\n'))) {
    const std::string_view shows = error.substr(message_.size());
    const auto blank = shows.find(' ', shows.find("l."));
    if (blank != shows.npos) context_ = shows.substr(blank + 1);
    if (context_.starts_with("...")) context_.remove_prefix(3);
    slash_ = context_.rfind('\\');
    if (message_.ends_with("Undefined control sequence.") && slash_ != context_.npos) {
      unknown_ = sys::stripped(context_.substr(slash_ + 1));
    }
  }

  /// With the column, where the log tells one, and for an unknown command the nearest of the names.
  std::string told(const std::vector<std::string_view>& lines,
                   const std::set<std::string>& names) const {
    const std::string told = with_column(lines);
    if (unknown_.empty()) return told;
    return fmt::format("{} \\{}{}", told, unknown_, sys::suggestion(unknown_, names));
  }

 private:
  std::string with_column(const std::vector<std::string_view>& lines) const {
    const std::string file = std::string(report_file) + ":";
    if (!message_.starts_with(file) || context_.empty()) return std::string(message_);
    const std::string_view rest = message_.substr(file.size());
    std::size_t number = 0;
    std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (number == 0 || number > lines.size()) return std::string(message_);
    const std::string_view line = lines[number - 1];
    const auto found = line.find(context_);
    if (found == line.npos) return std::string(message_);
    const std::size_t n_bytes = found + (unknown_.empty() ? context_.size() : slash_);
    return fmt::format("{}{}:{}{}", file, number, sys::n_characters(line.substr(0, n_bytes)) + 1,
                       rest.substr(rest.find(':')));
  }

  std::string_view message_, context_;
  std::size_t slash_ = 0;  ///< in the context
  std::string unknown_;    ///< the name of a command; empty if the error is another one
};

std::vector<std::string> told_by_latex(const ReportTexts& texts,
                                       const std::set<std::string>& names) {
  constexpr std::size_t most = 100;  // as many as TeX tells
  const std::vector<std::string_view> lines = sys::lines_of(texts.report);
  std::vector<std::string> findings;
  for (const std::string& error : literate::latex_errors(texts.log, "report")) {
    if (findings.size() == most) {
      findings.push_back(std::string(report_file) + ": there are more errors in typeset.log");
      break;
    }
    findings.push_back(LoggedError(error).told(lines, names));
  }
  return findings;
}

/// What was handed in as numbers.tex against what is computed.
std::vector<std::string> differences(const std::vector<Definition>& handed_in,
                                     const std::vector<Definition>& computed) {
  std::vector<std::string> findings;
  for (const Definition& one : handed_in) {
    const auto same = std::ranges::find(computed, one.name, &Definition::name);
    if (same == computed.end()) {
      findings.push_back(at(numbers_file, one.place,
                            fmt::format("\\{} was handed in, and is not computed", one.name)));
    } else if (same->value != one.value) {
      findings.push_back(at(numbers_file, one.place,
                            fmt::format("\\{} was handed in as {}, and is computed as {}", one.name,
                                        one.value, same->value)));
    }
  }
  return findings;
}

/// Commands that reach under LaTeX's surface: they make names and characters of others, skip text,
/// or read and write files. Those of pdfTeX all begin with «pdf».
bool is_unusual(std::string_view command) {
  static const std::set<std::string_view> all = {
      "csname",          "expandafter",    "let",         "futurelet",     "catcode",
      "lccode",          "uccode",         "lowercase",   "uppercase",     "scantokens",
      "makeatletter",    "@namedef",       "@nameuse",    "iffalse",       "number",
      "romannumeral",    "char",           "chardef",     "numexpr",       "dimexpr",
      "openin",          "openout",        "read",        "write",         "immediate",
      "special",         "jobname",        "endlinechar", "escapechar",    "include",
      "everypar",        "everyeof",       "everyjob",    "ExplSyntaxOn",  "renewenvironment",
      "primitive",       "AtEndDocument",  "batchmode",   "errorstopmode", "scrollmode",
      "interactionmode", "AtBeginDocument"};
  return all.contains(command) || command.starts_with("pdf");
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
  const std::set<std::string> names = names_of(definitions_in(texts.computed));
  append(findings, told_by_latex(texts, names));
  for (const Definition& anew : definitions_in(texts.report)) {
    if (!names.contains(anew.name)) continue;
    findings.push_back(
        at(report_file, anew.place,
           fmt::format("\\{} is defined anew, but numbers.tex gives it", shown_name(anew.name))));
  }
  append(findings, unusual_commands(texts.report));
  return findings;
}

std::vector<std::string> findings_of_numbers(const ReportTexts& given) {
  const ReportTexts texts = readable(given);
  std::vector<std::string> findings;
  append(findings, literate::typed_numbers(texts.report, report_file));
  if (!texts.computed.empty()) {
    append(findings, differences(definitions_in(texts.handed_in), definitions_in(texts.computed)));
  }
  return findings;
}

}  // namespace course
