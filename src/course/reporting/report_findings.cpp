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
  std::string name;
  literate::TexPlace place;
};

/// \DeclareCommandCopy, \NewExpandableDocumentCommand and their like.
bool is_of_the_kernel(std::string_view command) {
  return command.find("Command") != command.npos &&
         std::ranges::any_of(std::array{"New", "Renew", "Provide", "Declare"},
                             [&](const char* begin) { return command.starts_with(begin); });
}

bool defines(std::string_view command) {
  static const std::set<std::string_view> all = {"newcommand",
                                                 "newcommand*",
                                                 "renewcommand",
                                                 "renewcommand*",
                                                 "providecommand",
                                                 "providecommand*",
                                                 "def",
                                                 "edef",
                                                 "gdef",
                                                 "xdef",
                                                 "let"};
  return is_of_the_kernel(command) || all.contains(command);
}

/// Finds \newcommand*\name, \def\name and their like.
std::vector<Definition> definitions_in(std::string_view text) {
  std::vector<Definition> definitions;
  literate::TexScanner scanner(text);
  bool is_awaited = false;
  while (const auto token = scanner.next()) {
    using literate::TexKind;
    if (is_awaited && token->kind == TexKind::command) {
      definitions.push_back({std::string(token->name), literate::place_in(text, token->text)});
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

/// Commands that reach under LaTeX's surface: they make names and characters of others, skip text,
/// or read and write files. Those of pdfTeX all begin with «pdf».
bool is_unusual(std::string_view command) {
  static const std::set<std::string_view> all = {"csname",
                                                 "expandafter",
                                                 "let",
                                                 "futurelet",
                                                 "catcode",
                                                 "lccode",
                                                 "uccode",
                                                 "lowercase",
                                                 "uppercase",
                                                 "scantokens",
                                                 "makeatletter",
                                                 "@namedef",
                                                 "@nameuse",
                                                 "iffalse",
                                                 "number",
                                                 "romannumeral",
                                                 "char",
                                                 "chardef",
                                                 "numexpr",
                                                 "dimexpr",
                                                 "openin",
                                                 "openout",
                                                 "read",
                                                 "write",
                                                 "immediate",
                                                 "special",
                                                 "jobname",
                                                 "endlinechar",
                                                 "escapechar",
                                                 "include",
                                                 "everypar",
                                                 "everyeof",
                                                 "everyjob",
                                                 "ExplSyntaxOn",
                                                 "renewenvironment",
                                                 "primitive",
                                                 "AtEndDocument",
                                                 "batchmode",
                                                 "errorstopmode",
                                                 "scrollmode",
                                                 "interactionmode",
                                                 "AtBeginDocument",
                                                 "AddToHook",
                                                 "csdef",
                                                 "cslet",
                                                 "letcs",
                                                 "csuse",
                                                 "patchcmd",
                                                 "apptocmd",
                                                 "pretocmd",
                                                 "robustify",
                                                 "newrobustcmd",
                                                 "renewrobustcmd"};
  return all.contains(command) || is_of_the_kernel(command) || command.starts_with("pdf");
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
  append(findings, told_by_latex(texts.log));
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
  return findings;
}

}  // namespace course
