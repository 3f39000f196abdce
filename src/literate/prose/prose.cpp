// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/prose.hpp"

#include <algorithm>
#include <cstddef>
#include <set>

namespace literate {
namespace {

/// Commands whose first argument, or first two or three, are not printed.
// clang-format off
const std::set<std::string_view> one_silent = {
    "bibitem", "bibliography", "bibliographystyle", "captionsetup", "cite", "claim", "color",
    "Cref", "cref", "documentclass", "eqref", "fig", "finding", "findingsays", "hspace", "hypertarget",
    "ifflag", "include", "includegraphics", "input", "label", "pageref", "parbox", "phantom",
    "quoted", "quotedpage", "raisebox", "rawval", "ref", "statement", "tag", "textcolor", "usepackage",
    "val", "verdictsign", "vspace"};
const std::set<std::string_view> two_silent = {
    "addtocounter", "addtolength", "claimcount", "crefrange", "fontsize", "rule", "setcounter", "setlength"};
const std::set<std::string_view> three_silent = {"addcontentsline", "definecolor"};
// clang-format on

/// Environments with an argument that is not printed, such as column types or a width.
const std::set<std::string_view> formed_environments = {
    "tabular", "tabular*", "tabularx", "array", "minipage", "multicols", "alignat", "alignat*"};
const std::set<std::string_view> upright_commands = {"mathrm", "text", "textrm", "textup",
                                                     "mbox",   "unit", "mathup", "operatorname"};
const std::set<std::string_view> quantity_commands = {"qty", "SI", "ang"};
const std::set<std::string_view> unit_signs = {
    "circ",        "degree",   "celsius",        "Omega",  "ohm",
    "AA",          "angstrom", "prime",          "textmu", "textdegree",
    "textcelsius", "textohm",  "textperthousand"};

/// Environments whose options say where they stand.
const std::set<std::string_view> placed_environments = {"figure", "figure*", "table", "table*"};

/// What of a preamble is printed: titles, and what its definitions hold.
const std::set<std::string_view> titles = {"title", "subtitle", "shorttitle"};
const std::set<std::string_view> definitions = {
    "newcommand", "providecommand",     "DeclareRobustCommand",   "def",
    "gdef",       "NewDocumentCommand", "ProvideDocumentCommand", "DeclareDocumentCommand"};

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
    if (const auto begin = latex_.find("\\begin{document}"); begin != std::string_view::npos) {
      read_preamble(static_cast<std::ptrdiff_t>(begin));
    }
    while (const auto token = scanner_.next()) {
      read_in_its_mode(*token);
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

  /// Blanks the name of a table or a listing, but not the caption in brackets before it, which is
  /// printed.
  void blank_name_behind_options() {
    const std::string_view caption = group_at(scanner_.rest(), '[', ']');
    blank(group_at(scanner_.rest().substr(caption.size())));
  }

  void read_in_its_mode(const TexToken& token) {
    std::fill_n(prose_.modes.begin() + position(token.text), token.text.size(), token.mode);
    read(token);
  }
  void read_preamble(std::ptrdiff_t end);
  void read(const TexToken& token);
  void read_command(const TexToken& command);

  std::string_view latex_;
  TexScanner scanner_;
  Prose prose_;
};

void Reader::read_preamble(std::ptrdiff_t end) {
  while (position(scanner_.rest()) < end) {
    const TexToken token = *scanner_.next();
    blank(token.text);
    const bool is_definition = definitions.contains(token.name);
    const bool has_specification = token.name.ends_with("DocumentCommand");
    if (token.kind != TexKind::command || !(is_definition || titles.contains(token.name))) continue;
    if (is_definition) {  // the name, with or without braces, and the number of its arguments
      blank_group('{', '}');
      if (scanner_.rest().starts_with('\\')) blank(scanner_.next()->text);
      if (has_specification) {
        blank_group('{', '}');
      } else {
        blank_group('[', ']');
      }
    }
    const std::string_view rest = scanner_.rest();
    const std::size_t n_options = group_at(rest, '[', ']').size();
    const std::size_t n_body = group_at(rest.substr(n_options)).size();
    const std::ptrdiff_t end_of_body = position(rest.substr(n_options + n_body));
    while (position(scanner_.rest()) < end_of_body) read_in_its_mode(*scanner_.next());
  }
}

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
      if (formed_environments.contains(token.name)) return blank_arguments(1);
      // The name of a theorem is printed; where a float stands, and what has the form key=value, is
      // not.
      if (placed_environments.contains(token.name) ||
          group_at(scanner_.rest(), '[', ']').find('=') != std::string_view::npos) {
        blank_group('[', ']');
      }
      return;
    case TexKind::command:
      return read_command(token);
  }
}

void Reader::read_command(const TexToken& command) {
  blank(command.text);
  char& first = *(prose_.text.begin() + position(command.text));
  if (upright_commands.contains(command.name)) first = Prose::upright;
  if (quantity_commands.contains(command.name)) first = Prose::quantity;
  if (unit_signs.contains(command.name)) first = Prose::unit_sign;
  if (command.name == "cite") first = Prose::citation;
  if (command.name == "makebox") blank_arguments(0);
  if (command.name == "tab" || command.name == "excerpt") blank_name_behind_options();
  if (one_silent.contains(command.name)) blank_arguments(1);
  if (two_silent.contains(command.name)) blank_arguments(2);
  if (three_silent.contains(command.name)) blank_arguments(3);
}

}  // namespace

Prose prose_of(std::string_view latex) {
  return Reader(latex).read();
}

}  // namespace literate
