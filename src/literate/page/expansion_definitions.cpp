// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions and conditions of the document and of known.tex.
#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <regex>

#include "literate/page/expansion.hpp"
#include "system/decimal.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
using namespace page_reading;
namespace {

std::string command_in(std::string_view argument) {
  argument = sys::stripped(argument);
  return std::string(argument.substr(argument.starts_with('\\') ? 1 : 0));
}

}  // namespace

// [2][default]{body}
Expander::Macro Expander::macro_at(TexScanner& in) const {
  Macro macro;
  if (const auto n = option(in)) macro.n_arguments = static_cast<std::size_t>(n->front() - '0');
  const auto first = option(in);
  macro.has_default = first.has_value();
  macro.first_default = first.value_or("");
  macro.body = argument(in);
  return macro;
}

void Expander::define(const std::string& name, Macro macro) {
  if (!groups_.empty()) {
    const auto known = macros_.find(name);
    groups_.back().try_emplace(
        name, known == macros_.end() ? std::nullopt : std::optional(known->second));
  }
  macros_[name] = std::move(macro);
}

void Expander::end_group() {
  if (groups_.empty()) return;
  for (auto& [name, former] : groups_.back()) {
    if (former) {
      macros_[name] = std::move(*former);
    } else {
      macros_.erase(name);
    }
  }
  groups_.pop_back();
}

// Two numbers or two lengths, each of which may be a command; none if only TeX can compare them.
std::optional<bool> Expander::compared(TexScanner& in, std::string_view kind) {
  static const std::map<std::string, double> points{
      {"pt", 1}, {"in", 72.27}, {"cm", 72.27 / 2.54}, {"mm", 7.227 / 2.54}, {"bp", 72.27 / 72}};
  const std::string number = R"(\s*(-?[\d.]+|\\[A-Za-z]+(?:\[[^\]]*\])?(?:\{[^{}]*\})*))";
  const std::string unit = kind == "ifdim" ? R"(\s*([a-z]{2}))" : "()";
  const std::regex comparison(number + unit + R"(\s*([<=>]))" + number + unit + R"(\s?)");
  const std::string text(in.rest());
  std::smatch found;
  if (!std::regex_search(text, found, comparison, std::regex_constants::match_continuous))
    return {};
  in.skip(static_cast<std::size_t>(found.length()));
  const auto measured = [&](std::size_t i) -> std::optional<double> {
    const auto value = sys::parsed<double>(expanded(found.str(i)));
    if (!value || kind == "ifnum") return value;
    const auto point = points.find(found.str(i + 1));
    if (point == points.end()) return std::nullopt;
    return *value * point->second;
  };
  const auto left = measured(1), right = measured(4);
  if (!left || !right) return std::nullopt;
  const char sign = found.str(3).front();
  return sign == '<'   ? *left < *right
         : sign == '>' ? *left > *right
                       : std::abs(*left - *right) < 1e-6;
}

void Expander::know_definitions() {
  // \PageMark{<b>}{</b>}{LaTeX}
  know({"PageMark"}, [this](TexScanner& in, const TexToken&) {
    const std::string open = expanded(argument(in)), close = expanded(argument(in));
    emit(marked(open, expanded(argument(in)), close));
  });
  // \begin{PageBlock}{<div>}{</div>}
  know_environments({"PageBlock", "PageBlock*"}, [this](TexScanner& in, const TexToken& token) {
    const std::string open = expanded(argument(in)), close = expanded(argument(in));
    begin_block(open, close, !token.name.ends_with('*'));
    ends_.emplace_back(token.name, "block");
  });
  know({"PageIf"}, [this](TexScanner& in, const TexToken&) {
    const bool is_empty = sys::stripped(argument(in)).empty();
    const std::string_view latex = argument(in);
    if (!is_empty) read_all(latex);
  });
  know({"PageNumber"}, [this](TexScanner& in, const TexToken&) {
    read_all(numbers_.take(std::string(argument(in))).number);
  });
  know_in_preamble({"newcommand", "renewcommand", "providecommand", "DeclareRobustCommand"},
                   [this](TexScanner& in, const TexToken& token) {
                     const std::string name = command_in(argument(in));
                     Macro macro = macro_at(in);
                     const bool is_known = macros_.contains(name) || commands_.contains(name);
                     if (token.name == "providecommand" && is_known) return;
                     define(name, std::move(macro));
                   });
  // \def\name#1#2{…}
  know_in_preamble({"def", "gdef"}, [this](TexScanner& in, const TexToken& token) {
    const std::string name = command_in(argument(in));
    const auto open = in.rest().find('{');
    if (open == in.rest().npos) return;
    const std::string_view pattern = in.skip(open);
    Macro macro;
    macro.n_arguments = static_cast<std::size_t>(std::ranges::count(pattern, '#'));
    macro.body = argument(in);
    if (pattern.size() != 2 * macro.n_arguments) return;
    if (token.name == "gdef") {
      for (auto& group : groups_) group.erase(name);
      macros_[name] = std::move(macro);
    } else {
      define(name, std::move(macro));
    }
  });
  // \let\name=\other
  know_in_preamble({"let"}, [this](TexScanner& in, const TexToken&) {
    const auto name = in.next();
    in.skip_blanks();
    if (in.rest().starts_with('=')) in.skip(1);
    in.skip_blanks();
    const auto other = in.next();
    if (!name || !other || name->kind != TexKind::command) return;
    const std::string alias(name->name), known(other->name);
    const bool is_command = other->kind == TexKind::command;
    if (const auto macro = macros_.find(known); is_command && macro != macros_.end()) {
      define(alias, Macro(macro->second));
    } else if (const auto handler = commands_.find(known);
               is_command && handler != commands_.end()) {
      commands_[alias] = [read = handler->second, known](TexScanner& from, TexToken token) {
        token.name = known;
        read(from, token);
      };
    } else {
      define(alias, {.body = known == "relax" ? "" : std::string(other->text)});
    }
  });
  know({"begingroup", "bgroup"}, [this](TexScanner&, const TexToken&) {
    begin_group();
    emit("{");
  });
  know({"endgroup", "egroup"}, [this](TexScanner&, const TexToken&) {
    end_group();
    emit("}");
  });
  // pandoc would set the units of a number in capitals too.
  know({"MakeUppercase", "MakeTextUppercase", "uppercase"},
       [this](TexScanner& in, const TexToken&) {
         const std::string_view text = argument(in);
         if (text.find_first_of("\\$") != text.npos) {
           fail(fmt::format("the page cannot set '{}' in capitals, but plain letters alone", text));
         }
         emit(fmt::format("\\MakeUppercase{{{}}}", text));
       });
  know_in_preamble({"newenvironment", "renewenvironment"}, [this](TexScanner& in, const TexToken&) {
    const std::string name(argument(in));
    Macro macro = macro_at(in);
    macro.end = argument(in);
    own_environments_[name] = std::move(macro);
  });
  // \PageDefine{name}{LaTeX}
  know_in_preamble({"PageDefine"}, [this](TexScanner& in, const TexToken&) {
    const std::string name(argument(in));
    macros_[name] = {.body = std::string(argument(in))};
  });
  know_in_preamble({"newtheorem"}, [this](TexScanner& in, const TexToken& token) {
    const std::string name(argument(in));
    const std::string counter(option(in).value_or(name));
    const std::string title(argument(in));
    option(in);
    const bool is_numbered = !token.text.ends_with('*');
    const char* macro = is_numbered ? "PageTheorem" : "PageRemark";
    own_environments_[name] = {.n_arguments = 1,
                               .has_default = true,
                               .body = fmt::format("\\{}{{{}}}{{#1}}{{{}}}", macro, title, counter),
                               .end = "\\end{PageBlock*}"};
  });
  know_in_preamble({"DeclareMathOperator"}, [this](TexScanner& in, const TexToken& token) {
    const std::string name = command_in(argument(in));
    const char* star = token.text.ends_with('*') ? "*" : "";
    macros_[name] = {.body = fmt::format("\\operatorname{}{{{}}}", star, argument(in))};
  });
  // \PageUse[otherwise]{name}
  know({"PageUse"}, [this](TexScanner& in, const TexToken&) {
    const auto otherwise = option(in);
    const std::string name = expanded(argument(in));
    const auto macro = macros_.find(name);
    if (macro != macros_.end()) return read_all(filled(in, macro->second));
    if (otherwise) return read_all(*otherwise);
    fail("unknown " + boost::replace_first_copy(name, ":", " '") + "'");
  });
  know_in_preamble({"LiteratePicture"}, [this](TexScanner& in, const TexToken&) {
    picture_environments_.emplace(argument(in));
  });
  // A class is named without its version: revtex4-2.
  know_in_preamble({"documentclass"}, [this](TexScanner& in, const TexToken&) {
    option(in);
    class_ = argument(in);
    class_.erase(class_.find_last_not_of("-0123456789") + 1);
    sorts_citations_ = compresses_citations_ = is_revtex();
    if (const auto own = macros_.find("class:" + class_); own != macros_.end()) {
      read_preamble(std::string(own->second.body));
    }
  });
  // A package of the document's own folder is part of the document.
  know_in_preamble({"usepackage", "RequirePackage"}, [this](TexScanner& in, const TexToken&) {
    const std::string_view options = option(in).value_or("");
    const std::string name(argument(in));
    const auto has = [&](const char* wanted) { return options.find(wanted) != options.npos; };
    for (const std::string& one : names_in(name)) {
      if (one == "natbib") {
        is_author_year_ = !has("numbers") && !has("super");
        if (has("round") || (is_author_year_ && !has("square"))) {
          macros_["PageCiteOpen"].body = "(";
          macros_["PageCiteClose"].body = ")";
        }
        if (is_author_year_) macros_["PageCiteNext"].body = "; ";
        sorts_citations_ = has("sort");
        compresses_citations_ = has("compress") && !is_author_year_;
      }
      if (one == "cite") {
        sorts_citations_ = !has("nosort");
        compresses_citations_ = !has("nocompress");
      }
    }
    const fs::path file = sources_.document / (name + ".sty");
    if (fs::is_regular_file(file)) read_preamble(sys::read_file(file));
  });
  // What is between \makeatletter and \makeatother concerns LaTeX.
  know_in_preamble({"makeatletter"}, [this](TexScanner& in, const TexToken&) {
    while (const auto token = in.next()) {
      if (token->name == "makeatother") return;
    }
  });
  // \ifdim1cm>10pt … \else … \fi and the like; \ifmmode, \iftrue and \iffalse.
  know({"ifdim", "ifnum", "ifmmode", "iftrue", "iffalse"}, [this](TexScanner& in,
                                                                  const TexToken& token) {
    const std::string kind(token.name);
    const bool is_comparison = kind == "ifdim" || kind == "ifnum";
    const std::optional<bool> is_true =
        is_comparison ? compared(in, kind) : kind == "iftrue" || (kind == "ifmmode" && is_math_);
    if (!is_true) return fail(fmt::format("the page cannot decide \\{}", kind));
    std::string yes, no;
    bool in_else = false;
    for (int depth = 1; auto part = in.next();) {
      const bool opens = part->kind == TexKind::command && part->name.starts_with("if") &&
                         part->name != "ifflag" && part->name != "ifpapermodified";
      if (opens) ++depth;
      if (part->name == "fi" && --depth == 0) break;
      if (part->name == "else" && depth == 1) {
        in_else = true;
        continue;
      }
      (in_else ? no : yes) += part->text;
    }
    read_all(*is_true ? yes : no);
  });
  // An environment that is nothing but its content here, with the arguments that it takes.
  know_environments(
      {"document", "subequations", "multicols", "minipage", "flushleft", "flushright", "titlepage",
       "frontmatter", "acknowledgments", "small", "footnotesize", "raggedright", "sloppypar"},
      [this](TexScanner& in, const TexToken& token) {
        while (option(in)) {
        }
        if (token.name == "multicols" || token.name == "minipage") argument(in);
        emit("\n\n");
        ends_.emplace_back(token.name, token.name == "minipage" ? "minipage" : "\n\n");
      });
  know({"input", "include", "LiterateFiles"}, [this](TexScanner& in, const TexToken& token) {
    const std::string name = expanded(argument(in));
    if (token.name == "LiterateFiles") return read_all(sys::read_file(sources_.generated / name));
    const fs::path file = file_of(name);
    if (!fs::is_regular_file(file)) return fail(fmt::format("'{}' is not there", name));
    read_file(file);
    emit("\n");
  });
  // \hskip1em plus .5em minus .4em, \penalty0
  know({"hskip", "vskip", "kern", "penalty"}, [this](TexScanner& in, const TexToken& token) {
    static const std::regex length(
        R"(^\s*-?[\d.]+\s*((em|ex|pt|pc|mm|cm|in)(\s*(plus|minus)\s*[\d.]+\s*[a-z]+)*)?)");
    std::match_results<std::string_view::const_iterator> found;
    const std::string_view rest = in.rest();
    if (std::regex_search(rest.begin(), rest.end(), found, length)) {
      in.skip(static_cast<std::size_t>(found.length()));
    }
    emit(token.name == "penalty" ? "" : " ");
  });
  know({"unskip"}, [this](TexScanner&, const TexToken&) {
    while (out_->ends_with(' ') || out_->ends_with('\n')) out_->pop_back();
  });
}

}  // namespace literate
