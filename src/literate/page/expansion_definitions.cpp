// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions and conditions of the document and of known.tex.
#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>

#include "literate/page/expansion.hpp"
#include "system/decimal.hpp"
#include "system/files.hpp"
#include "system/pattern.hpp"
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

// {name}[2][default]{body}, and of an environment {end}
Expander::Macro Expander::macro_of(const Call& call) {
  const std::string_view n_arguments = call.option(0);
  return {.n_arguments = n_arguments.empty() ? 0U : static_cast<std::size_t>(n_arguments[0] - '0'),
          .has_default = call.options[1].has_value(),
          .first_default = std::string(call.option(1)),
          .body = call[1],
          .end = call.arguments.size() > 2 ? call[2] : ""};
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
  const sys::Pattern comparison(number + unit + R"(\s*([<=>]))" + number + unit + R"(\s?)");
  const auto found = comparison.find_at_begin_of(in.rest());
  if (!found) return {};
  in.skip(found->parts[0].size());
  const auto measured = [&](std::size_t i) -> std::optional<double> {
    const auto value = sys::parsed<double>(expanded(found->str(i)));
    if (!value || kind == "ifnum") return value;
    const auto point = points.find(found->str(i + 1));
    if (point == points.end()) return std::nullopt;
    return *value * point->second;
  };
  const auto left = measured(1), right = measured(4);
  if (!left || !right) return std::nullopt;
  const char sign = found->parts[3].front();
  return sign == '<'   ? *left < *right
         : sign == '>' ? *left > *right
                       : std::abs(*left - *right) < 1e-6;
}

void Expander::know_definitions() {
  // \PageMark{<b>}{</b>}{LaTeX}
  know({"PageMark"}, "mmm", [this](const Call& call) {
    const std::string open = expanded(call[0]), close = expanded(call[1]);
    emit(marked(open, expanded(call.arguments[2]), close));
  });
  // \begin{PageBlock}{<div>}{</div>}
  know_environments({"PageBlock", "PageBlock*"}, "mm", [this](const Call& call) {
    const std::string open = expanded(call[0]), close = expanded(call[1]);
    begin_block(open, close, !call.is_starred);
    ends_.emplace_back(call.name, [this] { end_block(); });
  });
  know({"PageIf"}, "mm", [this](const Call& call) {
    if (!sys::stripped(call.arguments[0]).empty()) read_all(call.arguments[1]);
  });
  know({"PageNumber"}, "m", [this](const Call& call) { read_all(numbers_.take(call[0]).number); });
  know_in_preamble({"newcommand", "renewcommand", "providecommand", "DeclareRobustCommand"}, "moom",
                   [this](const Call& call) {
                     const std::string name = command_in(call.arguments[0]);
                     const bool is_known = macros_.contains(name) || commands_.contains(name);
                     if (call.name == "providecommand" && is_known) return;
                     define(name, macro_of(call));
                   });
  // \def\name#1#2{…}
  know_in_preamble({"def", "gdef"}, "m", [this](const Call& call) {
    const std::string name = command_in(call.arguments[0]);
    const auto open = call.in.rest().find('{');
    if (open == std::string_view::npos) return;
    const std::string_view pattern = call.in.skip(open);
    Macro macro{.n_arguments = static_cast<std::size_t>(std::ranges::count(pattern, '#')),
                .body = std::string(argument(call.in))};
    if (pattern.size() != 2 * macro.n_arguments) return;
    if (call.name == "def") return define(name, std::move(macro));
    for (auto& group : groups_) group.erase(name);
    macros_[name] = std::move(macro);
  });
  // \let\name=\other
  know_in_preamble({"let"}, "m", [this](const Call& call) {
    call.in.skip_blanks();
    if (call.in.rest().starts_with('=')) call.in.skip(1);
    const auto other = call.in.next();
    if (!other || !call.arguments[0].starts_with('\\')) return;
    const std::string alias = command_in(call.arguments[0]), known(other->name);
    const bool is_command = other->kind == TexKind::command;
    if (const auto macro = macros_.find(known); is_command && macro != macros_.end()) {
      define(alias, Macro(macro->second));
    } else if (const auto construct = commands_.find(known);
               is_command && construct != commands_.end()) {
      commands_[alias] = {construct->second.form,
                          [read = construct->second.handler, known](Call aliased) {
                            aliased.name = known;
                            read(aliased);
                          }};
    } else {
      define(alias, {.body = known == "relax" ? "" : std::string(other->text)});
    }
  });
  know({"begingroup", "bgroup", "endgroup", "egroup"}, "", [this](const Call& call) {
    const bool begins = call.name.starts_with('b');
    begins ? begin_group() : end_group();
    emit(begins ? "{" : "}");
  });
  // pandoc would set the units of a number in capitals too.
  know({"MakeUppercase", "MakeTextUppercase", "uppercase"}, "m", [this](const Call& call) {
    const std::string text = call[0];
    if (text.find_first_of("\\$") != text.npos) {
      fail(fmt::format("the page cannot set '{}' in capitals, but plain letters alone", text));
    }
    emit(fmt::format("\\MakeUppercase{{{}}}", text));
  });
  know_in_preamble({"newenvironment", "renewenvironment"}, "moomm",
                   [this](const Call& call) { own_environments_[call[0]] = macro_of(call); });
  // \PageDefine{name}{LaTeX}
  know_in_preamble({"PageDefine"}, "mm",
                   [this](const Call& call) { macros_[call[0]] = {.body = call[1]}; });
  // \PageNames{1}{LaTeX}{\some\names}: commands of that many arguments
  know_in_preamble({"PageNames"}, "mmm", [this](const Call& call) {
    TexScanner names(call.arguments[2]);
    while (const auto token = names.next()) {
      if (token->kind != TexKind::command) continue;
      macros_[std::string(token->name)] = {
          .n_arguments = static_cast<std::size_t>(call[0].front() - '0'), .body = call[1]};
    }
  });
  know_in_preamble({"newtheorem"}, "momo", [this](const Call& call) {
    own_environments_[call[0]] = {
        .n_arguments = 1,
        .has_default = true,
        .body =
            fmt::format("\\{}{{{}}}{{#1}}{{{}}}", call.is_starred ? "PageRemark" : "PageTheorem",
                        call[1], call.options[0].value_or(call.arguments[0])),
        .end = "\\end{PageBlock*}"};
  });
  know_in_preamble({"DeclareMathOperator"}, "mm", [this](const Call& call) {
    const char* star = call.is_starred ? "*" : "";
    macros_[command_in(call.arguments[0])] = {
        .body = fmt::format("\\operatorname{}{{{}}}", star, call[1])};
  });
  // \PageUse[otherwise]{name}
  know({"PageUse"}, "om", [this](const Call& call) {
    const std::string name = expanded(call[0]);
    const auto macro = macros_.find(name);
    if (macro != macros_.end()) return read_all(filled(call.in, macro->second));
    if (call.options[0]) return read_all(call.option());
    fail("unknown " + boost::replace_first_copy(name, ":", " '") + "'");
  });
  know_in_preamble({"LiteratePicture"}, "m",
                   [this](const Call& call) { picture_environments_.insert(call[0]); });
  // A class is named without its version: revtex4-2.
  know_in_preamble({"documentclass"}, "om", [this](const Call& call) {
    class_ = call[0];
    class_.erase(class_.find_last_not_of("-0123456789") + 1);
    sorts_citations_ = compresses_citations_ = is_revtex();
    if (const auto own = macros_.find("class:" + class_); own != macros_.end()) {
      read_preamble(std::string(own->second.body));
    }
  });
  // A package of the document's own folder is part of the document.
  know_in_preamble({"usepackage", "RequirePackage"}, "om", [this](const Call& call) {
    const std::string_view given = call.option();
    const auto has = [&](const char* wanted) { return given.find(wanted) != given.npos; };
    for (const std::string& one : names_in(call.arguments[0])) {
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
    const fs::path file = sources_.document / (call[0] + ".sty");
    if (fs::is_regular_file(file)) read_preamble(sys::read_file(file));
  });
  // What is between \makeatletter and \makeatother concerns LaTeX.
  know_in_preamble({"makeatletter"}, "", [](const Call& call) {
    while (const auto token = call.in.next()) {
      if (token->name == "makeatother") return;
    }
  });
  // \ifdim1cm>10pt … \else … \fi and the like; \ifmmode, \iftrue and \iffalse.
  know({"ifdim", "ifnum", "ifmmode", "iftrue", "iffalse"}, "", [this](const Call& call) {
    const bool is_comparison = call.name == "ifdim" || call.name == "ifnum";
    const std::optional<bool> is_true =
        is_comparison ? compared(call.in, call.name)
                      : call.name == "iftrue" || (call.name == "ifmmode" && is_math_);
    if (!is_true) return fail(fmt::format("the page cannot decide \\{}", call.name));
    std::string yes, no;
    bool in_else = false;
    for (int depth = 1; auto part = call.in.next();) {
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
  know_environments({"document", "subequations", "flushleft", "flushright", "titlepage",
                     "frontmatter", "acknowledgments", "small", "footnotesize", "raggedright",
                     "sloppypar", "multicols", "minipage"},
                    "ooo", [this](const Call& call) {
                      const bool is_minipage = call.name == "minipage";
                      if (is_minipage || call.name == "multicols") argument(call.in);
                      emit("\n\n");
                      ends_.emplace_back(call.name, [this, is_minipage] {
                        if (is_minipage && !floats_.empty() && !floats_.back().outer.empty()) {
                          floats_.back().counter = std::exchange(floats_.back().outer, "");
                        }
                        emit("\n\n");
                      });
                    });
  know({"LiterateFiles"}, "m", [this](const Call& call) {
    read_all(sys::read_file(sources_.generated / expanded(call[0])));
  });
  know({"input", "include"}, "m", [this](const Call& call) {
    const std::string name = expanded(call[0]);
    const fs::path file = file_of(name);
    if (!fs::is_regular_file(file)) return fail(fmt::format("'{}' is not there", name));
    read_file(file);
    if (call.name == "include") emit("\n\n");
  });
  // \hskip1em plus .5em minus .4em, \penalty0
  know({"hskip", "vskip", "kern", "penalty"}, "", [this](const Call& call) {
    static const sys::Pattern length(
        R"(\s*-?[\d.]+\s*((em|ex|pt|pc|mm|cm|in)(\s*(plus|minus)\s*[\d.]+\s*[a-z]+)*)?)");
    const auto found = length.find_at_begin_of(call.in.rest());
    if (found) call.in.skip(found->parts[0].size());
    emit(call.name == "penalty" ? "" : " ");
  });
  know({"unskip"}, "", [this](const Call&) {
    while (out_->ends_with(' ') || out_->ends_with('\n')) out_->pop_back();
  });
}

}  // namespace literate
