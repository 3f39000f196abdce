// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/prose.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "literate/text/characters.hpp"

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
                                                         {"end", 1},
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
const std::set<std::string_view> displays = {
    "equation", "equation*", "align",     "align*",   "alignat",     "alignat*", "gather",
    "gather*",  "multline",  "multline*", "eqnarray", "displaymath", "eqnarray*"};
const std::set<std::string_view> skipped_environments = {"verbatim", "verbatim*", "lstlisting",
                                                         "thebibliography"};
const std::set<std::string_view> upright_commands = {"mathrm", "text",   "textrm",
                                                     "unit",   "mathup", "operatorname"};
const std::set<std::string_view> quantity_commands = {"qty", "SI"};

/// Walks through a text once and blanks what is not prose.
class Reader {
 public:
  explicit Reader(std::string_view latex)
      : latex_(latex), prose_{std::string(latex), std::vector<Mode>(latex.size(), Mode::text)} {}

  Prose read() {
    constexpr std::string_view beginning = "\\begin{document}";
    if (const auto begin = latex_.find(beginning); begin != npos) blank_to(begin);
    while (at_ < latex_.size()) {
      if (latex_[at_] == '%') {
        blank_to(std::min(latex_.find('\n', at_), latex_.size()));
      } else if (latex_[at_] == '\\') {
        read_command();
      } else if (latex_[at_] == '$') {
        read_dollar();
      } else {
        keep();
      }
    }
    return std::move(prose_);
  }

 private:
  void keep() { prose_.modes[at_++] = mode_; }

  void blank_to(std::size_t end) {
    for (; at_ < end; ++at_) {
      prose_.modes[at_] = mode_;
      if (latex_[at_] != '\n') prose_.text[at_] = ' ';
    }
  }

  void read_dollar() {
    const bool is_double = latex_.substr(at_, 2) == "$$";
    const Mode inside = is_double ? Mode::display_math : Mode::inline_math;
    for (const auto end = at_ + (is_double ? 2 : 1); at_ < end;) keep();
    mode_ = mode_ == Mode::text ? inside : Mode::text;
  }

  /// Behind the group that begins at `at`, after blanks; `at` if there is none.
  std::size_t behind_group(std::size_t at, char open, char close) const {
    auto first = latex_.find_first_not_of(" \t", at);
    if (first == npos || latex_[first] != open) return at;
    int depth = 0;
    for (; first < latex_.size(); ++first) {
      if (latex_[first] == '\\') {
        ++first;
      } else if (latex_[first] == open) {
        ++depth;
      } else if (latex_[first] == close && --depth == 0) {
        return first + 1;
      }
    }
    return latex_.size();
  }

  void blank_arguments(int n_groups) {
    blank_to(behind_group(at_, '[', ']'));
    for (int i = 0; i < n_groups; ++i) {
      blank_to(behind_group(at_, '{', '}'));
      blank_to(behind_group(at_, '[', ']'));
    }
  }

  void read_symbol();
  void read_verb();
  void read_environment(bool begins);
  void read_command();

  std::string_view latex_;
  Prose prose_;
  std::size_t at_ = 0;
  Mode mode_ = Mode::text;
};

/// \[ \] \( \) and line ends with their lengths; escaped characters stay as they are.
void Reader::read_symbol() {
  const char symbol = at_ + 1 < latex_.size() ? latex_[at_ + 1] : ' ';
  if (symbol == '[') mode_ = Mode::display_math;
  if (symbol == '(') mode_ = Mode::inline_math;
  if (symbol == ']' || symbol == ')') mode_ = Mode::text;
  const auto end = std::min(at_ + 2, latex_.size());
  if (symbol == '\\') {
    blank_to(end);
    blank_to(behind_group(at_, '[', ']'));
  } else if (symbol == '%' || symbol == ',' || symbol == ';' || symbol == ':' || symbol == ' ') {
    while (at_ < end) keep();
  } else {
    blank_to(end);
  }
}

void Reader::read_verb() {
  if (at_ < latex_.size() && latex_[at_] == '*') blank_to(at_ + 1);
  if (at_ >= latex_.size()) return;
  const auto end = latex_.find(latex_[at_], at_ + 1);
  blank_to(end == npos ? latex_.size() : end + 1);
}

void Reader::read_environment(bool begins) {
  const auto end = behind_group(at_, '{', '}');
  const auto open = latex_.find('{', at_);
  if (open >= end) return;
  const std::string_view name = latex_.substr(open + 1, end - open - 2);
  blank_to(end);
  if (begins && skipped_environments.contains(name)) {
    blank_to(std::min(latex_.find("\\end{" + std::string(name) + "}", at_), latex_.size()));
  } else {
    if (displays.contains(name)) mode_ = begins ? Mode::display_math : Mode::text;
    if (begins) blank_arguments(formed_environments.contains(name) ? 1 : 0);
  }
}

void Reader::read_command() {
  std::size_t end = at_ + 1;
  while (end < latex_.size() && is_command_letter(latex_[end])) ++end;
  const std::string_view name = latex_.substr(at_ + 1, end - at_ - 1);
  if (name.empty()) return read_symbol();
  const std::size_t first = at_;
  blank_to(end < latex_.size() && latex_[end] == '*' && name != "verb" ? end + 1 : end);
  if (upright_commands.contains(name)) prose_.text[first] = Prose::upright;
  if (quantity_commands.contains(name)) prose_.text[first] = Prose::quantity;
  if (name == "verb") {
    read_verb();
  } else if (name == "begin" || name == "end") {
    read_environment(name == "begin");
  } else if (const auto silent = silent_commands.find(name); silent != silent_commands.end()) {
    if (name == "cite") prose_.text[first] = Prose::citation;
    blank_arguments(silent->second);
  }
}

}  // namespace

Prose prose_of(std::string_view latex) {
  return Reader(latex).read();
}

}  // namespace literate
