// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// A use of a LaTeX command, `\name{argument}`, and where its backslash stands.
struct TexCommand {
  std::string name;
  std::string argument;
  int line = 0;                  ///< from 1
  int column = 0;                ///< from 1, in characters
  std::vector<Branch> branches;  ///< of \ifflag that it stands in, outermost first
};

/// Finds the uses of the named commands in a LaTeX text, in order.
///
/// Comments, `\verb`, verbatim and lstlisting environments are skipped, and so are definitions:
/// a name without a braced argument, or an argument that holds a parameter (#1).
std::vector<TexCommand> commands_in(std::string_view text, const std::set<std::string>& names);

}  // namespace literate
