// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/tex_commands.hpp"

#include <algorithm>
#include <string>

#include "literate/prose/tex_scanner.hpp"

namespace literate {
namespace {

/// Follows the braces of a text and knows in which branches of \ifflag{flag}{yes}{no} it is.
class Conditionals {
 public:
  void begin(std::string_view flag) { open_.push_back({std::string(flag), depth_, 0}); }

  void read(const TexToken& token) {
    const bool is_blank = token.kind == TexKind::comment ||
                          token.text.find_first_not_of(" \t\r\n") == std::string_view::npos;
    if (token.kind == TexKind::open) {
      if (is_between_groups()) ++open_.back().group;
      ++depth_;
    } else if (token.kind == TexKind::close) {
      --depth_;
      while (!open_.empty() && open_.back().depth > depth_) open_.pop_back();
      if (is_between_groups() && open_.back().group == no) open_.pop_back();
    } else if (!is_blank && is_between_groups()) {
      open_.pop_back();  // no branch follows
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
    int depth;  // how many braces are open at \ifflag
    int group;  // the group that the text has reached: key, yes or no
  };
  bool is_between_groups() const { return !open_.empty() && open_.back().depth == depth_; }

  std::vector<Conditional> open_;
  int depth_ = 0;
};

/// The content of a group in brackets, as TeX reads it: white space is one blank.
std::string in_one_line(std::string_view group) {
  if (group.empty()) return "";
  const auto open = group.find('[');
  std::string text;
  for (const char c : group.substr(open + 1, group.size() - open - 2)) {
    const bool is_blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!is_blank) {
      text += c;
    } else if (!text.ends_with(' ')) {
      text += ' ';
    }
  }
  return text;
}

}  // namespace

bool is_left_out(const std::vector<Branch>& branches, const std::map<std::string, bool>& flags) {
  return std::ranges::any_of(branches, [&](const Branch& branch) {
    const auto flag = flags.find(branch.flag);
    return flag != flags.end() && flag->second != branch.is_yes;
  });
}

std::vector<TexCommand> commands_in(std::string_view text, const std::set<std::string>& names) {
  std::vector<TexCommand> commands;
  Conditionals conditionals;
  TexScanner scanner(text);
  while (const auto token = scanner.next()) {
    conditionals.read(*token);
    if (token->kind != TexKind::command) continue;
    const std::string name(token->name);
    const std::string_view rest = scanner.rest();
    const std::string_view in_brackets = group_at(rest, '[', ']');
    const std::string argument(argument_at(rest.substr(in_brackets.size())));
    if (argument.empty() || argument.find('#') != std::string::npos) continue;
    if (names.contains(name)) {
      const auto [line, column] = place_in(text, token->text);
      const auto end = static_cast<std::size_t>(rest.data() - text.data());
      commands.push_back(
          {name, argument, in_one_line(in_brackets), line, column, conditionals.branches(), end});
    }
    if (name == "ifflag") conditionals.begin(argument);
  }
  return commands;
}

}  // namespace literate
