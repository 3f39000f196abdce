// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/changes/sentences.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>

#include "literate/prose/document_files.hpp"
#include "literate/prose/tex_commands.hpp"
#include "literate/prose/tex_scanner.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

/// What the argument of a command names.
const std::map<std::string, std::string> named_by{
    {"val", "value"},     {"rawval", "value"},  {"tab", "table"},         {"fig", "figure"},
    {"claim", "claim"},   {"finding", "claim"}, {"findingsays", "claim"}, {"statement", "claim"},
    {"verdict", "claim"}, {"ifflag", "flag"},   {"claimcount", "claims"}, {"excerpt", "listing"}};

/// Commands that no sentence goes across.
const std::set<std::string_view> divisions{
    "part",      "chapter", "section",   "subsection",      "subsubsection",
    "paragraph", "title",   "item",      "caption",         "footnote",
    "input",     "include", "maketitle", "tableofcontents", "appendix",
    "clearpage", "newpage"};

/// Those whose argument is a sentence of its own.
const std::set<std::string_view> headings{"part",       "chapter",   "section",
                                          "subsection", "paragraph", "subsubsection"};

/// What the preamble prints, on the title page.
const std::set<std::string_view> titles{"title",     "subtitle", "author",      "date",
                                        "institute", "address",  "affiliation", "thanks"};

/// Words with a full stop behind which a sentence goes on.
constexpr std::array<std::string_view, 17> abbreviations{
    "eq", "eqs", "fig", "figs", "tab", "sec", "ch",   "p",     "pp",
    "no", "vol", "cf",  "e.g",  "i.e", "ref", "refs", "approx"};

bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}

bool is_abbreviated(std::string_view before) {
  const auto begin = before.find_last_of(" \t\n(~{[");
  std::string word(before.substr(begin == std::string_view::npos ? 0 : begin + 1));
  std::ranges::transform(word, word.begin(),
                         [](char c) { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; });
  return std::ranges::find(abbreviations, word) != abbreviations.end();
}

/// Whether the character at `i` of the text ends a sentence.
bool ends_here(std::string_view text, std::size_t i) {
  if (text[i] != '.' && text[i] != '?' && text[i] != '!') return false;
  std::size_t next = i + 1;
  while (next < text.size() && (text[next] == '}' || text[next] == ')' || text[next] == '\'')) {
    ++next;
  }
  if (next < text.size() && text[next] != ' ' && text[next] != '\n' && text[next] != '\t') {
    return false;
  }
  next = text.find_first_not_of(" \t\n", next);
  if (next == std::string_view::npos) return true;
  const char begin = text[next];
  const bool may_begin = is_upper(begin) || sys::is_digit(begin) || begin == '\\' || begin == '$' ||
                         begin == '`' || begin == '}' || begin == '%';
  return may_begin && !is_abbreviated(text.substr(0, i));
}

/// Where sentences end, in ascending order: the offset behind each.
std::vector<std::size_t> ends_in(std::string_view text) {
  std::vector<std::size_t> ends;
  TexScanner scanner(text);
  while (const auto token = scanner.next()) {
    const auto begin = static_cast<std::size_t>(token->text.data() - text.data());
    const std::size_t end = begin + token->text.size();
    const bool divides = token->kind == TexKind::begin || token->kind == TexKind::end ||
                         (token->kind == TexKind::command && divisions.contains(token->name));
    if (divides) {
      ends.push_back(begin);
      if (token->kind != TexKind::command) ends.push_back(end);
      if (headings.contains(token->name)) {
        const std::string_view rest = scanner.rest();
        const std::size_t options = group_at(rest, '[', ']').size();
        ends.push_back(end + options + group_at(rest.substr(options)).size());
      }
      continue;
    }
    if (token->kind != TexKind::text || token->mode != TexMode::text) continue;
    for (std::size_t i = begin; i < end; ++i) {
      const bool is_empty_line =
          text[i] == '\n' &&
          text.substr(i + 1).find_first_not_of(" \t") != std::string_view::npos &&
          text[text.find_first_not_of(" \t", i + 1)] == '\n';
      if (is_empty_line || ends_here(text, i)) ends.push_back(i + 1);
    }
  }
  ends.push_back(text.size());
  std::ranges::sort(ends);  // within a heading others may end
  return ends;
}

/// The extent of a branch of \\ifflag{flag}{yes}{no}, with its flag.
struct Extent {
  std::size_t begin, end;
  std::string flag;
};

std::vector<Extent> branches_in(std::string_view latex) {
  std::vector<Extent> extents;
  for (const TexCommand& use : commands_in(latex, {"ifflag"})) {
    TexScanner scanner(latex.substr(use.end));
    const auto skip_group = [&] {
      scanner.skip_blanks();
      return scanner.skip(group_at(scanner.rest()).size());
    };
    skip_group();  // the flag
    for (int branch = 0; branch < 2; ++branch) {
      const std::string_view text = skip_group();
      const auto begin = static_cast<std::size_t>(text.data() - latex.data());
      extents.push_back({begin, begin + text.size(), use.argument});
    }
  }
  return extents;
}

void add_use(Sentence& sentence, const TexCommand& use) {
  const std::string name = named_by.at(use.name) + " " + use.argument;
  sentence.names.insert(name);
  sentence.styles[name].insert((use.name == "rawval" ? "rawval " : "") + use.options);
}

/// The titles of a preamble that print something.
std::vector<Sentence> titles_in(std::string_view preamble, const std::string& file,
                                const std::set<std::string>& commands,
                                const std::map<std::string, bool>& flags, const OwnCommands& own) {
  std::vector<Sentence> sentences;
  TexScanner scanner(preamble);
  while (const auto token = scanner.next()) {
    if (token->kind != TexKind::command || !titles.contains(token->name)) continue;
    scanner.skip(group_at(scanner.rest(), '[', ']').size());
    scanner.skip_blanks();
    const std::string_view group = group_at(scanner.rest());
    Sentence sentence;
    sentence.file = file;
    sentence.latex = fmt::format("\\{}{}", token->name, without_comments(group));
    sentence.first_line = place_in(preamble, token->text).line;
    sentence.last_line = sentence.first_line + static_cast<int>(std::ranges::count(group, '\n'));
    for (const TexCommand& use : commands_in(group, commands, own)) {
      if (!is_left_out(use.branches, flags)) add_use(sentence, use);
    }
    if (!sentence.names.empty()) sentences.push_back(std::move(sentence));
  }
  return sentences;
}

}  // namespace

std::vector<Sentence> sentences_in(std::string_view latex, const std::string& file,
                                   const std::map<std::string, bool>& flags,
                                   const OwnCommands& own) {
  std::set<std::string> commands;
  for (const auto& [command, kind] : named_by) commands.insert(command);
  const std::vector<TexCommand> uses = commands_in(latex, commands, own);
  const std::vector<TexCommand> sections =
      commands_in(latex, {"chapter", "section", "subsection", "subsubsection"});

  constexpr std::string_view beginning = "\\begin{document}";
  const auto preamble = latex.find(beginning);
  std::size_t begin = preamble == std::string_view::npos ? 0 : preamble + beginning.size();
  const std::vector<Extent> branches = branches_in(latex);
  std::vector<Sentence> sentences = titles_in(latex.substr(0, begin), file, commands, flags, own);
  std::size_t n_used = 0, n_headings = 0;
  for (const std::size_t end : ends_in(latex)) {
    if (end <= begin) continue;
    // The braces that closed what the sentence before stood in are none of this one.
    begin = std::min(latex.find_first_not_of(" \t\r\n}", begin), end);
    const std::string_view text = latex.substr(begin, end - begin);
    Sentence sentence;
    sentence.file = file;
    sentence.latex = without_comments(text);
    for (; n_used < uses.size() && uses[n_used].end <= end; ++n_used) {
      if (uses[n_used].end < begin || is_left_out(uses[n_used].branches, flags)) continue;
      add_use(sentence, uses[n_used]);
    }
    for (const Extent& branch : branches) {
      if (branch.begin < end && begin < branch.end) sentence.names.insert("flag " + branch.flag);
    }
    while (n_headings < sections.size() && sections[n_headings].end <= end) ++n_headings;
    if (n_headings > 0) sentence.heading = sections[n_headings - 1].argument;
    const bool has_letter = std::ranges::any_of(sentence.latex, sys::is_letter);
    const bool is_environment =
        sentence.latex.starts_with("\\begin{") || sentence.latex.starts_with("\\end{");
    if ((has_letter && !is_environment) || !sentence.names.empty()) {
      sentence.first_line = place_in(latex, text).line;
      const std::string_view written = sys::stripped(text);
      sentence.last_line =
          sentence.first_line + static_cast<int>(std::ranges::count(written, '\n'));
      sentences.push_back(std::move(sentence));
    }
    begin = end;
  }
  return sentences;
}

std::vector<Sentence> sentences_below(const std::filesystem::path& document,
                                      const std::map<std::string, bool>& flags) {
  const OwnCommands own = own_commands_of(document);
  std::vector<Sentence> all;
  for (const DocumentFile& file : read_document(document)) {
    std::ranges::move(sentences_in(file.text, file.name, flags, own), std::back_inserter(all));
  }
  for (Sentence& sentence : all) sentence.folder = source_label(document);
  return all;
}

std::string path_of(const Sentence& sentence) {
  return sentence.folder.empty() ? sentence.file : sentence.folder + "/" + sentence.file;
}

std::string place_of(const Sentence& sentence) {
  return path_of(sentence) + ":" + std::to_string(sentence.first_line);
}

}  // namespace literate
