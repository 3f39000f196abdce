// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace literate {

/// One of the two branches of \ifflag{flag}{yes}{no}.
struct Branch {
  std::string flag;
  bool is_yes = false;
};

/// A use of a LaTeX command, `\name{argument}` or `\name[options]{argument}`, and where its
/// backslash stands.
struct TexCommand {
  std::string name;
  std::string argument;
  std::string options;           ///< as they are written, in one line; empty if there are none
  int line = 0;                  ///< from 1
  int column = 0;                ///< from 1, counted in characters
  std::vector<Branch> branches;  ///< of \ifflag around it, outermost first
  std::size_t end = 0;           ///< the byte after the name, where the arguments begin
};

/// Whether one of the branches is not taken.
bool is_left_out(const std::vector<Branch>& branches, const std::map<std::string, bool>& flags);

/// A command that the document defines by \newcommand or \def.
struct OwnCommand {
  std::size_t n_arguments = 0;
  bool has_option = false;   ///< whether the first argument stands in brackets
  std::string default_text;  ///< of the first argument
  std::string body;
};
/// What a command with this body prints: the arguments in place of #1, #2 and so on.
std::string filled(std::string_view body, const std::vector<std::string>& arguments);

/// By name. Of one that is defined twice both stand there.
using OwnCommands = std::multimap<std::string, OwnCommand, std::less<>>;
OwnCommands own_commands_in(std::string_view text);

/// Finds the uses of the named commands in a LaTeX text, in order, and those to which the
/// document's own commands in it expand, at the places of these.
///
/// Comments and verbatim text are skipped, and so is what belongs to a definition: a name without
/// an argument in braces, and an argument or option with a parameter (#1).
std::vector<TexCommand> commands_in(std::string_view text, const std::set<std::string>& names,
                                    const OwnCommands& own = {});

}  // namespace literate
