// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/quotations.hpp"

#include <fmt/core.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <string_view>

#include "literate/prose/document_files.hpp"
#include "literate/text/characters.hpp"
#include "literate/text/latex.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

std::string place_of(const std::string& file, const toml::source_region& source) {
  return fmt::format("{}:{}:{}", file, source.begin.line, source.begin.column);
}

[[noreturn]] void fail(const std::string& place, const std::string& message) {
  throw sys::InputError(fmt::format("{}: {}", place, message));
}

/// A quotation stands where its words do; of a table whose header gives the key, the library knows
/// no other place.
Quotation quotation_of(const std::string& file, const toml::key& key_of_it,
                       const toml::node& node) {
  const std::string_view id = key_of_it.str();
  Quotation quotation{
      .id = std::string(id), .page = "", .words = "", .place = place_of(file, key_of_it.source())};
  if (!is_key(id)) fail(quotation.place, fmt::format("'{}' is no key", id));
  const toml::table* table = node.as_table();
  if (table == nullptr) fail(quotation.place, fmt::format("'{}' is not a table", id));
  for (const auto& [key, value] : *table) {
    const std::string place = place_of(file, value.source());
    if (key == "words" && value.is_string()) {
      quotation.words = value.as_string()->get();
      quotation.place = place;
    } else if (key == "page" && value.is_integer()) {
      quotation.page = fmt::format("{}", value.as_integer()->get());
    } else if (key == "page" && value.is_string()) {
      quotation.page = value.as_string()->get();
    } else {
      fail(place,
           fmt::format("'{}' of quotation '{}': a quotation has words, a text, and a page, a "
                       "number or a text",
                       key.str(), id));
    }
  }
  if (quotation.words.empty())
    fail(quotation.place, fmt::format("quotation '{}' has no words", id));
  if (quotation.page.empty()) fail(quotation.place, fmt::format("quotation '{}' has no page", id));
  return quotation;
}

bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\f';
}

/// What stands between a letter and the one before it. A line that ends behind a dash or a slash
/// may break a word or not.
enum class Gap { none, blank, either };

/// A letter of the text, which is no white space, with its line.
struct Letter {
  char c;
  std::size_t at;  // its byte in the text
  int line;
  bool may_be_missing;  // a hyphen at the end of a line
  Gap before;
};

std::vector<Letter> letters_of(std::string_view text) {
  std::vector<Letter> letters;
  int line = 1;
  Gap gap = Gap::none;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_space(text[i])) {
      const auto next = text.find_first_not_of(" \t\r", i + 1);
      const bool ends_line = next == std::string_view::npos || text[next] == '\n';
      letters.push_back({text[i], i, line, text[i] == '-' && ends_line, gap});
      gap = Gap::none;
    } else if (gap != Gap::either) {
      const std::string_view before = text.substr(0, i);
      const bool may_break_word = before.ends_with('-') || before.ends_with('/') ||
                                  before.ends_with("–") || before.ends_with("—");
      gap = may_break_word && text.find_first_not_of(" \t\r", i) == text.find('\n', i) ? Gap::either
                                                                                       : Gap::blank;
    }
    if (text[i] == '\n') ++line;
  }
  return letters;
}

bool are_alike(Gap one, Gap other) {
  return one == other || one == Gap::either || other == Gap::either;
}

/// How many of the words' letters stand in the text from a place on, and where that ends.
struct Match {
  std::size_t n_letters = 0;
  std::size_t end = 0;
};

Match match_at(const std::vector<Letter>& words, const std::vector<Letter>& text, std::size_t at) {
  Match match{0, at};
  bool breaks_word = false;  // at a hyphen that only the end of its line needs
  while (match.n_letters < words.size() && match.end < text.size()) {
    const Letter& word = words[match.n_letters];
    const Letter& there = text[match.end];
    const Gap gap = breaks_word ? Gap::none : there.before;
    if (word.c == there.c && (match.n_letters == 0 || are_alike(word.before, gap))) {
      ++match.n_letters;
      breaks_word = false;
    } else if (there.may_be_missing) {
      breaks_word = true;
    } else {
      break;
    }
    ++match.end;
  }
  return match;
}

/// The words of a text from the one on that holds the letter with this number; at its end nothing.
std::string words_from(const std::string& text, const std::vector<Letter>& letters,
                       std::size_t at) {
  constexpr int most_words = 4;
  if (at == letters.size()) return "";
  std::size_t begin = letters[at].at;
  while (begin > 0 && !is_space(text[begin - 1])) --begin;
  std::string shown;
  int n_words = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    if (!is_space(text[i])) {
      shown += text[i];
    } else if (shown.back() != ' ') {
      if (++n_words == most_words) break;
      shown += ' ';
    }
  }
  return shown.substr(0, shown.find_last_not_of(' ') + 1);
}

/// How many letters stand before the letter with this number in its word.
std::size_t n_letters_before_in_word(const std::vector<Letter>& letters, std::size_t at) {
  std::size_t n = 0;
  while (n < at && letters[at - n - 1].at + 1 == letters[at - n].at) ++n;
  return n;
}

/// The whole words before the letter with this number.
std::string words_before(const std::string& words, const std::vector<Letter>& letters,
                         std::size_t at) {
  std::size_t end = letters[at].at;
  while (end > 0 && !is_space(words[end - 1])) --end;
  while (end > 0 && is_space(words[end - 1])) --end;
  return words.substr(0, end);
}

}  // namespace

std::vector<Quotation> read_quotations(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "quotations.toml";
  if (!std::filesystem::exists(path)) return {};
  const std::string file = source_label(folder) + "/quotations.toml";
  std::vector<Quotation> quotations;
  try {
    const toml::table table = toml::parse(sys::read_file(path));
    for (const auto& [id, node] : table) quotations.push_back(quotation_of(file, id, node));
    // The library sorts the tables by name.
    std::ranges::sort(quotations, {}, [&](const Quotation& quotation) {
      return table.find(quotation.id)->first.source().begin.line;
    });
  } catch (const toml::parse_error& error) {
    fail(place_of(file, error.source()), std::string(error.description()));
  }
  return quotations;
}

std::vector<std::string> quotation_errors(const std::vector<Quotation>& quotations,
                                          const std::filesystem::path& text_file) {
  const std::string whole = sys::read_file(text_file);
  const std::vector<Letter> text = letters_of(whole);
  std::vector<std::string> errors;
  for (const Quotation& quotation : quotations) {
    const std::vector<Letter> words = letters_of(quotation.words);
    Match best;
    for (std::size_t at = 0; at < text.size() && best.n_letters < words.size(); ++at) {
      const Match match = match_at(words, text, at);
      if (match.n_letters > best.n_letters) best = match;
    }
    if (best.n_letters == words.size()) continue;
    const int line = best.end < text.size() ? text[best.end].line
                     : text.empty()         ? 0
                                            : text.back().line;
    errors.push_back(fmt::format(
        "{}: quotation '{}' differs after '{}': it goes on '{}', line {} of the text '{}'",
        quotation.place, quotation.id, words_before(quotation.words, words, best.n_letters),
        words_from(quotation.words, words, best.n_letters), line,
        words_from(whole, text, best.end - n_letters_before_in_word(words, best.n_letters))));
  }
  return errors;
}

std::string words_latex(const Quotation& quotation) {
  std::string words;
  for (const char c : quotation.words) {
    const bool opens =
        words.empty() || is_space(words.back()) ||
        std::ranges::any_of(std::array<std::string_view, 6>{"(", "[", "-", "–", "—", "“"},
                            [&](std::string_view before) { return words.ends_with(before); });
    if (c == '"') {
      words += opens ? "“" : "”";
    } else {
      words += c;
    }
  }
  return escape_latex(words);
}

std::string quotations_tex(const std::vector<Quotation>& quotations) {
  std::string text;
  for (const Quotation& quotation : quotations) {
    text += fmt::format("\\LiterateQuotation{{{}}}{{{}}}{{{}}}\n", quotation.id,
                        escape_latex(quotation.page), words_latex(quotation));
  }
  return text;
}

}  // namespace literate
