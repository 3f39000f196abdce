// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/tex_commands.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "literate/text/characters.hpp"
#include "system/lines.hpp"
#include "system/utf8.hpp"

namespace literate {
namespace {

/// The text in braces at the start of `text`, after spaces; none if there is no such argument.
std::string_view argument_at(std::string_view text) {
  const auto open = text.find_first_not_of(" \t");
  if (open == std::string_view::npos || text[open] != '{') return {};
  const auto close = text.find('}', open);
  if (close == std::string_view::npos) return {};
  return text.substr(open + 1, close - open - 1);
}

bool is_verbatim(std::string_view environment) {
  return environment == "verbatim" || environment == "verbatim*" || environment == "lstlisting";
}

/// Follows the braces of a text and knows in which branches of \ifflag{flag}{yes}{no} it is.
class Conditionals {
 public:
  void begin(std::string_view flag) { open_.push_back({std::string(flag), depth_, 0}); }

  void read(char c) {
    if (c == '{') {
      if (is_between_groups()) ++open_.back().group;
      ++depth_;
    } else if (c == '}') {
      --depth_;
      while (!open_.empty() && open_.back().depth > depth_) open_.pop_back();
      if (is_between_groups() && open_.back().group == no) open_.pop_back();
    } else if (c != ' ' && c != '\t' && is_between_groups()) {
      open_.pop_back();  // something else than a branch follows
    }
  }

  std::vector<Branch> branches() const {
    std::vector<Branch> branches;
    for (const Conditional& c : open_) {
      if (c.depth < depth_ && c.group != key) branches.push_back({c.flag, c.group == yes});
    }
    return branches;
  }

 private:
  static constexpr int key = 1, yes = 2, no = 3;
  struct Conditional {
    std::string flag;
    int depth;  // of braces where \ifflag stands
    int group;  // the group of braces it has reached: key, yes or no
  };
  bool is_between_groups() const { return !open_.empty() && open_.back().depth == depth_; }

  std::vector<Conditional> open_;
  int depth_ = 0;
};

/// Reads a LaTeX text line by line and collects commands.
class Scanner {
 public:
  explicit Scanner(const std::set<std::string>& names) : names_(names) {}

  void read(std::string_view line) {
    ++line_;
    std::size_t at = 0;
    if (!verbatim_.empty()) at = behind_verbatim(line);
    while (at < line.size() && line[at] != '%') {
      if (line[at] == '\\') {
        at = behind_command(line, at);
      } else {
        conditionals_.read(line[at++]);
      }
    }
  }

  std::vector<TexCommand> commands;

 private:
  std::size_t behind_verbatim(std::string_view line) {
    const std::string end = fmt::format("\\end{{{}}}", verbatim_);
    const auto at = line.find(end);
    if (at == std::string_view::npos) return line.size();
    verbatim_.clear();
    return at + end.size();
  }

  std::size_t behind_command(std::string_view line, std::size_t backslash) {
    const auto first = line.begin() + static_cast<std::ptrdiff_t>(backslash) + 1;
    const auto name_end =
        static_cast<std::size_t>(std::find_if_not(first, line.end(), is_letter) - line.begin());
    const std::string_view name = line.substr(backslash + 1, name_end - backslash - 1);
    if (name.empty()) return backslash + 2;  // an escaped character, such as \%
    const std::string_view argument = argument_at(line.substr(name_end));
    if (name == "verb") return behind_verb(line, name_end);
    if (name == "begin" && is_verbatim(argument)) {
      verbatim_ = argument;
      return behind_verbatim(line);
    }
    conditionals_.read('\\');
    const bool is_use = !argument.empty() && argument.find('#') == std::string_view::npos;
    if (is_use && names_.contains(std::string(name))) {
      commands.push_back({std::string(name), std::string(sys::stripped(argument)), line_,
                          static_cast<int>(sys::n_characters(line.substr(0, backslash))) + 1,
                          conditionals_.branches()});
    }
    if (is_use && name == "ifflag") conditionals_.begin(sys::stripped(argument));
    return name_end;
  }

  static std::size_t behind_verb(std::string_view line, std::size_t at) {
    if (at < line.size() && line[at] == '*') ++at;
    if (at >= line.size()) return at;
    const auto end = line.find(line[at], at + 1);
    return end == std::string_view::npos ? line.size() : end + 1;
  }

  const std::set<std::string>& names_;
  int line_ = 0;
  Conditionals conditionals_;
  std::string verbatim_;  // the environment that the present line lies in
};

}  // namespace

std::vector<TexCommand> commands_in(std::string_view text, const std::set<std::string>& names) {
  Scanner scanner(names);
  for (const std::string_view line : sys::lines_of(text)) scanner.read(line);
  return std::move(scanner.commands);
}

}  // namespace literate
