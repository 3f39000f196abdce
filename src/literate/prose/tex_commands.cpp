// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/tex_commands.hpp"

#include <algorithm>
#include <optional>
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

std::string filled(std::string_view body, const std::vector<std::string>& arguments) {
  std::string text;
  for (std::size_t i = 0; i < body.size(); ++i) {
    const auto n = body[i] == '#' && i + 1 < body.size()
                       ? static_cast<std::size_t>(body[i + 1] - '1')
                       : arguments.size();
    if (n < arguments.size()) {
      text += arguments[n];
      ++i;
    } else {
      text += body[i];
    }
  }
  return text;
}

bool is_left_out(const std::vector<Branch>& branches, const std::map<std::string, bool>& flags) {
  return std::ranges::any_of(branches, [&](const Branch& branch) {
    const auto flag = flags.find(branch.flag);
    return flag != flags.end() && flag->second != branch.is_yes;
  });
}

namespace {

/// Reads what \NewDocumentCommand says of arguments, as far as \newcommand could say it, too:
/// {O{default} m m}, {o m}, {}. False for others, such as stars.
bool read_arguments(std::string_view specification, OwnCommand& command) {
  TexScanner scanner(specification.substr(1, specification.size() - 2));
  bool may_be_option = true;
  for (scanner.skip_blanks(); !scanner.rest().empty(); scanner.skip_blanks()) {
    const std::string_view kind = scanner.skip(1);
    const bool is_option = may_be_option && (kind == "o" || kind == "O");
    if (!is_option && kind != "m") return false;
    if (is_option) {
      command.has_option = true;
      const std::string_view text =
          kind == "O" ? scanner.skip(group_at(scanner.rest()).size()) : "";
      if (text.size() > 2) command.default_text = text.substr(1, text.size() - 2);
    }
    may_be_option = false;
    ++command.n_arguments;
  }
  return true;
}

}  // namespace

OwnCommands own_commands_in(std::string_view text) {
  static const std::set<std::string_view> defining{"newcommand",
                                                   "renewcommand",
                                                   "providecommand",
                                                   "def",
                                                   "DeclareRobustCommand",
                                                   "gdef",
                                                   "NewDocumentCommand",
                                                   "RenewDocumentCommand",
                                                   "ProvideDocumentCommand",
                                                   "DeclareDocumentCommand"};
  OwnCommands own;
  TexScanner scanner(text);
  while (const auto token = scanner.next()) {
    if (token->kind != TexKind::command || !defining.contains(token->name)) continue;
    // {\name}[2][default]{body}, \name[2][default]{body}, of \def \name#1#2{body}, and of
    // \NewDocumentCommand {\name}{O{default} m}{body}
    const std::string_view rest = scanner.rest();
    const auto slash = rest.find('\\');
    if (slash == rest.npos || rest.substr(0, slash).find_first_not_of("* \t\n{") != rest.npos) {
      continue;
    }
    TexScanner behind(rest.substr(slash));
    const std::string name(behind.next()->name);
    behind.skip(behind.rest().find_first_not_of("} \t\n"));
    OwnCommand command;
    const auto in_brackets = [&] { return behind.skip(group_at(behind.rest(), '[', ']').size()); };
    if (token->name.ends_with("def")) {
      const std::string_view pattern = behind.skip(behind.rest().find('{'));
      command.n_arguments = static_cast<std::size_t>(std::ranges::count(pattern, '#'));
    } else if (token->name.ends_with("DocumentCommand")) {
      if (!read_arguments(behind.skip(group_at(behind.rest()).size()), command)) continue;
    } else if (const std::string_view number = in_brackets(); number.size() == 3) {
      command.n_arguments = static_cast<std::size_t>(number[1] - '0');
      const std::string_view default_text = in_brackets();
      command.has_option = !default_text.empty();
      command.default_text = in_one_line(default_text);
    }
    const std::string_view body = group_at(behind.rest());
    if (body.size() > 2) command.body = body.substr(body.find('{') + 1, body.size() - 2);
    own.emplace(name, std::move(command));
  }
  return own;
}

namespace {

/// What a command of the document's own expands to before `rest`; none where its arguments are not
/// groups, as in its definition.
std::optional<std::string> expanded(const OwnCommand& command, std::string_view rest) {
  TexScanner scanner(rest);
  std::vector<std::string> arguments;
  if (command.has_option) {
    const std::string_view option = group_at(scanner.rest(), '[', ']');
    scanner.skip(option.size());
    arguments.push_back(option.empty() ? command.default_text : in_one_line(option));
  }
  while (arguments.size() < command.n_arguments) {
    scanner.skip_blanks();
    const std::string_view group = group_at(scanner.rest());
    if (group.empty()) return std::nullopt;
    arguments.emplace_back(group.substr(1, group.size() - 2));
    scanner.skip(group.size());
  }
  return filled(command.body, arguments);
}

void add_commands(std::string_view text, const std::set<std::string>& names, const OwnCommands& own,
                  int depth, std::vector<TexCommand>& commands) {
  constexpr int deepest = 8;  // a command may contain itself
  Conditionals conditionals;
  TexScanner scanner(text);
  while (const auto token = scanner.next()) {
    conditionals.read(*token);
    if (token->kind != TexKind::command) continue;
    const std::string name(token->name);
    const std::string_view rest = scanner.rest();
    const auto end = static_cast<std::size_t>(rest.data() - text.data());
    const auto [first, last] = own.equal_range(name);
    for (auto command = first; command != last && depth < deepest; ++command) {
      const auto expansion = expanded(command->second, rest);
      if (!expansion) continue;
      std::vector<TexCommand> inner;
      add_commands(*expansion, names, own, depth + 1, inner);
      const auto [line, column] = place_in(text, token->text);
      for (TexCommand& use : inner) {
        std::vector<Branch> branches = conditionals.branches();
        branches.insert(branches.end(), use.branches.begin(), use.branches.end());
        commands.push_back(
            {use.name, use.argument, use.options, line, column, std::move(branches), end});
      }
    }
    const std::string_view in_brackets = group_at(rest, '[', ']');
    const std::string argument(argument_at(rest.substr(in_brackets.size())));
    const bool has_parameter =
        argument.find('#') != std::string::npos || in_brackets.find('#') != std::string_view::npos;
    if (argument.empty() || has_parameter) continue;
    if (names.contains(name)) {
      const auto [line, column] = place_in(text, token->text);
      commands.push_back(
          {name, argument, in_one_line(in_brackets), line, column, conditionals.branches(), end});
    }
    if (name == "ifflag") conditionals.begin(argument);
  }
}

}  // namespace

std::vector<TexCommand> commands_in(std::string_view text, const std::set<std::string>& names,
                                    const OwnCommands& own) {
  std::vector<TexCommand> commands;
  add_commands(text, names, own, 0, commands);
  return commands;
}

}  // namespace literate
