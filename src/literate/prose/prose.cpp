// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/prose.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>

namespace literate {
namespace {

constexpr auto npos = std::string_view::npos;

/// Commands that print none of their first arguments, and how many these are.
const std::map<std::string_view, int> silent_commands = {{"addcontentsline", 3},
                                                         {"addtocounter", 2},
                                                         {"addtolength", 2},
                                                         {"bibitem", 1},
                                                         {"bibliography", 1},
                                                         {"bibliographystyle", 1},
                                                         {"captionsetup", 1},
                                                         {"cite", 1},
                                                         {"claim", 1},
                                                         {"color", 1},
                                                         {"Cref", 1},
                                                         {"cref", 1},
                                                         {"crefrange", 2},
                                                         {"definecolor", 3},
                                                         {"documentclass", 1},
                                                         {"eqref", 1},
                                                         {"excerpt", 1},
                                                         {"fig", 1},
                                                         {"fontsize", 2},
                                                         {"href", 1},
                                                         {"hspace", 1},
                                                         {"hypertarget", 1},
                                                         {"ifflag", 1},
                                                         {"include", 1},
                                                         {"includegraphics", 1},
                                                         {"input", 1},
                                                         {"label", 1},
                                                         {"makebox", 0},
                                                         {"pageref", 1},
                                                         {"parbox", 1},
                                                         {"phantom", 1},
                                                         {"raisebox", 1},
                                                         {"ref", 1},
                                                         {"rule", 2},
                                                         {"setcounter", 2},
                                                         {"setlength", 2},
                                                         {"tab", 1},
                                                         {"tag", 1},
                                                         {"textcolor", 1},
                                                         {"url", 1},
                                                         {"usepackage", 1},
                                                         {"val", 1},
                                                         {"vspace", 1}};

/// Environments that take an argument which is not printed: the form of columns, a width.
const std::set<std::string_view> formed_environments = {
    "tabular", "tabular*", "tabularx", "array", "minipage", "multicols", "alignat", "alignat*"};
const std::set<std::string_view> upright_commands = {"mathrm", "text",   "textrm",
                                                     "unit",   "mathup", "operatorname"};
const std::set<std::string_view> quantity_commands = {"qty", "SI"};

/// Symbols that the prose keeps: a per-cent sign and spaces, which may stand before a unit.
const std::set<std::string_view> visible_symbols = {"\\%", "\\,", "\\;", "\\:", "\\ "};

/// Walks through a text once and blanks what is not prose.
class Reader {
 public:
  explicit Reader(std::string_view latex)
      : latex_(latex),
        scanner_(latex),
        prose_{std::string(latex), std::vector<TexMode>(latex.size(), TexMode::text)} {}

  Prose read() {
    if (const auto begin = latex_.find("\\begin{document}"); begin != npos) blank_next(begin);
    while (const auto token = scanner_.next()) {
      std::fill_n(prose_.modes.begin() + position(token->text), token->text.size(), token->mode);
      read(*token);
    }
    return std::move(prose_);
  }

 private:
  std::ptrdiff_t position(std::string_view part) const { return part.data() - latex_.data(); }

  void blank(std::string_view part) {
    const auto first = prose_.text.begin() + position(part);
    std::replace_if(
        first, first + std::ssize(part), [](char c) { return c != '\n'; }, ' ');
  }
  void blank_next(std::size_t n_bytes) { blank(scanner_.skip(n_bytes)); }
  void blank_group(char open, char close) {
    blank_next(group_at(scanner_.rest(), open, close).size());
  }
  void blank_arguments(int n_groups) {
    blank_group('[', ']');
    for (int i = 0; i < n_groups; ++i) {
      blank_group('{', '}');
      blank_group('[', ']');
    }
  }

  void read(const TexToken& token);
  void read_command(const TexToken& command);

  std::string_view latex_;
  TexScanner scanner_;
  Prose prose_;
};

void Reader::read(const TexToken& token) {
  switch (token.kind) {
    case TexKind::text:
    case TexKind::dollar:
    case TexKind::open:
    case TexKind::close:
      return;
    case TexKind::comment:
    case TexKind::verbatim:
    case TexKind::end:
      return blank(token.text);
    case TexKind::symbol:
      if (visible_symbols.contains(token.text)) return;
      blank(token.text);
      if (token.text == "\\\\") blank_group('[', ']');  // the height of a line end
      return;
    case TexKind::begin:
      blank(token.text);
      if (token.name == "thebibliography") {
        return blank_next(scanner_.rest().find("\\end{thebibliography}"));
      }
      return blank_arguments(formed_environments.contains(token.name) ? 1 : 0);
    case TexKind::command:
      return read_command(token);
  }
}

void Reader::read_command(const TexToken& command) {
  blank(command.text);
  char& first = *(prose_.text.begin() + position(command.text));
  if (upright_commands.contains(command.name)) first = Prose::upright;
  if (quantity_commands.contains(command.name)) first = Prose::quantity;
  if (command.name == "cite") first = Prose::citation;
  const auto silent = silent_commands.find(command.name);
  if (silent != silent_commands.end()) blank_arguments(silent->second);
}

}  // namespace

Prose prose_of(std::string_view latex) {
  return Reader(latex).read();
}

}  // namespace literate
