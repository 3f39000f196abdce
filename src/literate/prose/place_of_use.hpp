// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace literate {

/// Rewrites a message of LaTeX («file:line: message») about a generated table, figure or excerpt so
/// that it names the place at which the document uses that, where its author can mend it:
/// «report/part.tex:12: in table 'name': message (tables/name.tex:3)». Returns other messages as
/// they are, but names the figures and tables that stand in the lines of an overfull box:
/// «report/part.tex:12: in figure 'name': Overfull …», and names all places of a label that is
/// defined more than once, and that of a brace that nothing closes. Throws sys::OutputError if the
/// document cannot be read.
std::string with_place_of_use(const std::string& message, const std::filesystem::path& source_dir);

}  // namespace literate
