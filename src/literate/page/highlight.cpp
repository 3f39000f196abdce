// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/highlight.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "literate/page/html_text.hpp"
#include "literate/text/characters.hpp"

namespace literate {
namespace {

struct Language {
  std::string_view name;
  std::string_view line_comment;
  std::string_view block_begin, block_end;
  std::string_view quotes;
  std::string_view keywords;
};

constexpr std::string_view c_keywords =
    " auto bool break case char const continue default do double else enum extern float for goto "
    "if "
    "inline int long return short signed sizeof static struct switch typedef union unsigned void "
    "volatile while ";
constexpr std::string_view cpp_keywords =
    " auto bool break case catch char class concept const constexpr const_cast continue decltype "
    "default delete do double else enum explicit export extern false final float for friend goto "
    "if "
    "inline int long mutable namespace new noexcept nullptr operator override private protected "
    "public requires return short signed sizeof static static_assert static_cast struct switch "
    "template this thread_local throw true try typedef typename union unsigned using virtual void "
    "volatile while ";
constexpr std::string_view octave_keywords =
    " break case catch continue do else elseif end endfor endfunction endif endwhile for function "
    "global if otherwise persistent return switch try until while ";
constexpr std::string_view python_keywords =
    " and as assert async await break class continue def del elif else except False finally for "
    "from "
    "global if import in is lambda None nonlocal not or pass raise return True try while with "
    "yield ";
constexpr std::string_view julia_keywords =
    " begin const do else elseif end false for function if import in let module return struct true "
    "using while ";
constexpr std::string_view fortran_keywords =
    " call case contains do else elseif end enddo endif function if implicit integer intent "
    "logical "
    "module none parameter print program real return select subroutine then type use while ";
constexpr std::string_view shell_keywords =
    " case do done elif else esac fi for function if in local return then until while ";
constexpr std::string_view cmake_keywords =
    " add_executable add_library add_subdirectory else elseif endforeach endfunction endif "
    "find_package foreach function if include literate_add_paper project set "
    "target_link_libraries ";
constexpr std::string_view truth_keywords = " true false null ";

constexpr std::array<Language, 15> languages{{
    {"C++", "//", "/*", "*/", "\"'", cpp_keywords},
    {"C", "//", "/*", "*/", "\"'", c_keywords},
    {"Java", "//", "/*", "*/", "\"'", cpp_keywords},
    {"Octave", "%", "", "", "\"", octave_keywords},
    {"Matlab", "%", "", "", "\"", octave_keywords},
    {"Python", "#", "", "", "\"'", python_keywords},
    {"Julia", "#", "", "", "\"", julia_keywords},
    {"Fortran", "!", "", "", "\"'", fortran_keywords},
    {"bash", "#", "", "", "\"'", shell_keywords},
    {"make", "#", "", "", "\"", ""},
    {"Gnuplot", "#", "", "", "\"'", " plot set splot unset using with "},
    {"TOML", "#", "", "", "\"'", truth_keywords},
    {"CMake", "#", "", "", "\"", cmake_keywords},
    {"R", "#", "", "", "\"'", " else for function if in next repeat return while "},
    {"JSON", "", "", "", "\"", truth_keywords},
}};

bool is_word(char c) {
  return is_letter(c) || is_digit(c) || c == '_';
}

class Highlighter {
 public:
  Highlighter(std::string_view code, const Language& language, int line)
      : code_(code), language_(language), line_(line) {}

  std::string run() {
    begin_line();
    while (at_ < code_.size()) step();
    end_line();
    return std::move(html_);
  }

 private:
  void begin_line() {
    html_ += fmt::format("<span class=\"lit-line\" data-line=\"{}\">", line_++);
    if (!open_.empty()) html_ += "<span class=\"" + std::string(open_) + "\">";
  }
  void end_line() {
    if (!open_.empty()) html_ += "</span>";
    html_ += "</span>\n";
  }
  void open(std::string_view css) {
    html_ += "<span class=\"" + std::string(css) + "\">";
    open_ = css;
  }
  void close() {
    html_ += "</span>";
    open_ = {};
  }
  void put(std::size_t n) {
    for (const std::size_t end = std::min(at_ + n, code_.size()); at_ < end; ++at_) {
      if (code_[at_] == '\n') {
        end_line();
        begin_line();
      } else {
        html_ += escape_html(code_.substr(at_, 1));
      }
    }
  }
  bool sees(std::string_view text) const {
    return !text.empty() && code_.substr(at_).starts_with(text);
  }
  std::size_t until(std::string_view end, std::size_t from) const {
    const std::size_t found = code_.find(end, from);
    return (found == std::string_view::npos ? code_.size() : found + end.size()) - at_;
  }

  void span(std::string_view css, std::size_t n) {
    open(css);
    put(n);
    close();
  }

  void step() {
    const char c = code_[at_];
    if (sees(language_.line_comment)) {
      const std::size_t end = std::min(code_.find('\n', at_), code_.size());
      return span("lit-comment", end - at_);
    }
    if (sees(language_.block_begin)) {
      return span("lit-comment", until(language_.block_end, at_ + language_.block_begin.size()));
    }
    if (language_.quotes.find(c) != std::string_view::npos) return string(c);
    if (!is_word(c)) return put(1);
    std::size_t end = at_;
    while (end < code_.size() && is_word(code_[end])) ++end;
    const std::string word(code_.substr(at_, end - at_));
    // 1'000'000 is a number and no character.
    while (is_digit(c) && end + 1 < code_.size() && code_[end] == '\'' && is_word(code_[end + 1])) {
      ++end;
      while (end < code_.size() && is_word(code_[end])) ++end;
    }
    if (language_.keywords.find(" " + word + " ") != std::string_view::npos) {
      span("lit-keyword", end - at_);
    } else {
      put(end - at_);
    }
  }

  void string(char quote) {
    std::size_t end = at_ + 1;
    while (end < code_.size() && code_[end] != quote && code_[end] != '\n') {
      end += code_[end] == '\\' ? 2U : 1U;
    }
    if (end < code_.size() && code_[end] == '\n') return put(1);  // a quotation mark by itself
    span("lit-string", std::min(end + 1, code_.size()) - at_);
  }

  std::string_view code_;
  const Language& language_;
  int line_;
  std::size_t at_ = 0;
  std::string_view open_;
  std::string html_;
};

}  // namespace

std::string_view language_name(std::string_view language) {
  const std::size_t bracket = language.find(']');
  return bracket == std::string_view::npos ? language : language.substr(bracket + 1);
}

std::string highlighted(std::string_view code, std::string_view language, int first_line) {
  static constexpr Language plain{"", "", "", "", "", ""};
  while (code.ends_with('\n')) code.remove_suffix(1);
  const auto* const found = std::ranges::find(languages, language_name(language), &Language::name);
  const Language& known = found == languages.end() ? plain : *found;
  return Highlighter(code, known, first_line).run();
}

}  // namespace literate
