// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/tex_tokens.hpp"

#include <algorithm>
#include <array>

#include "literate/text/characters.hpp"

namespace literate {
namespace {

using Kind = PageToken::Kind;

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

// The bytes of the UTF-8 character that begins with this one.
std::size_t n_bytes(char first) {
  const auto byte = static_cast<unsigned char>(first);
  if (byte >= 0xF0) return 4;
  if (byte >= 0xE0) return 3;
  return byte >= 0xC0 ? 2 : 1;
}

class Tokenizer {
 public:
  Tokenizer(std::string_view latex, int file, bool at_is_letter)
      : latex_(latex), file_(file), at_is_letter_(at_is_letter) {}

  PageTokens run() {
    while (at_ < latex_.size()) step();
    return std::move(tokens_);
  }

 private:
  bool more() const { return at_ < latex_.size(); }

  void advance(std::size_t n) {
    for (const std::size_t end = std::min(at_ + n, latex_.size()); at_ < end; ++at_) {
      if (latex_[at_] == '\n') {
        ++line_;
        line_begin_ = at_ + 1;
      }
    }
  }

  void add(Kind kind, std::size_t length, std::string_view text) {
    tokens_.push_back({.kind = kind,
                       .text = std::string(text),
                       .file = file_,
                       .line = line_,
                       .column = static_cast<int>(at_ - line_begin_) + 1});
    advance(length);
  }

  void step() {
    const char c = latex_[at_];
    switch (c) {
      case '\\':
        return take_command();
      case '%':
        return skip_comment();
      case '{':
        return add(Kind::open, 1, "{");
      case '}':
        return add(Kind::close, 1, "}");
      case '&':
        return add(Kind::align, 1, "&");
      case '^':
        return add(Kind::superscript, 1, "^");
      case '_':
        return add(Kind::subscript, 1, "_");
      case '~':
        return add(Kind::character, 1, "\u00A0");
      case '$': {
        const bool is_display = latex_.substr(at_).starts_with("$$");
        return add(Kind::dollar, is_display ? 2 : 1, is_display ? "$$" : "$");
      }
      case '#':
        return take_parameter();
      default:
        break;
    }
    if (is_blank(c) || c == '\n') return take_blanks();
    const std::size_t length = n_bytes(c);
    add(Kind::character, length, latex_.substr(at_, length));
  }

  // Blanks are one, however many; with an empty line among them they end the paragraph.
  void take_blanks() {
    const std::size_t begin = at_;
    std::size_t end = at_;
    int n_lines = 0;
    while (end < latex_.size() && (is_blank(latex_[end]) || latex_[end] == '\n')) {
      n_lines += latex_[end++] == '\n' ? 1 : 0;
    }
    const bool is_paragraph = n_lines > (starts_line_ ? 0 : 1);
    starts_line_ = false;
    if (is_paragraph) {
      add(Kind::paragraph, end - begin, "\n\n");
    } else if (after_comment_) {
      advance(end - begin);
    } else {
      add(Kind::space, end - begin, " ");
    }
    after_comment_ = false;
  }

  // A comment takes the end of its line with it, and the blanks that begin the next.
  void skip_comment() {
    const std::size_t end = latex_.find('\n', at_);
    advance(end == std::string_view::npos ? latex_.size() - at_ : end - at_ + 1);
    if (more() && (is_blank(latex_[at_]) || latex_[at_] == '\n')) {
      starts_line_ = after_comment_ = true;
      take_blanks();
    }
  }

  void skip_blanks_after_name() {
    std::size_t end = at_;
    while (end < latex_.size() && is_blank(latex_[end])) ++end;
    if (end < latex_.size() && latex_[end] == '\n') {
      std::size_t next = end + 1;
      while (next < latex_.size() && is_blank(latex_[next])) ++next;
      end = next < latex_.size() && latex_[next] == '\n' ? end : next;
    }
    advance(end - at_);
  }

  void take_parameter() {
    const std::size_t digit = latex_.find_first_not_of('#', at_);
    if (digit == std::string_view::npos || !is_digit(latex_[digit])) {
      return add(Kind::character, 1, "#");
    }
    add(Kind::parameter, digit + 1 - at_, latex_.substr(digit, 1));
  }

  void take_command() {
    std::size_t end = at_ + 1;
    while (end < latex_.size() &&
           (is_letter(latex_[end]) || (at_is_letter_ && latex_[end] == '@'))) {
      ++end;
    }
    if (end == at_ + 1) {
      const std::size_t length = end < latex_.size() ? n_bytes(latex_[end]) : 0;
      const std::string_view name = latex_.substr(end, length);
      add(Kind::command, 1 + length, name == "\n" ? " " : name);
      return;
    }
    const std::string_view name = latex_.substr(at_ + 1, end - at_ - 1);
    if (name == "verb") return take_verb(end);
    if (name == "begin" && take_verbatim_environment()) return;
    if (name == "makeatletter") at_is_letter_ = true;
    if (name == "makeatother") at_is_letter_ = false;
    add(Kind::command, end - at_, name);
    skip_blanks_after_name();
  }

  void take_verb(std::size_t end) {
    if (end < latex_.size() && latex_[end] == '*') ++end;
    const char delimiter = end < latex_.size() ? latex_[end] : '\n';
    const std::size_t close = latex_.find(delimiter, end + 1);
    const std::size_t stop = close == std::string_view::npos ? latex_.size() : close;
    const std::string body(latex_.substr(end + 1, stop - end - 1));
    add(Kind::verbatim, stop + 1 - at_, "verb");
    tokens_.back().body = body;
  }

  bool take_verbatim_environment() {
    static constexpr std::array<std::string_view, 4> names{"verbatim", "verbatim*", "lstlisting",
                                                           "comment"};
    for (const std::string_view name : names) {
      const std::string begin = "\\begin{" + std::string(name) + "}";
      const std::string end = "\\end{" + std::string(name) + "}";
      if (!latex_.substr(at_).starts_with(begin)) continue;
      const std::size_t from = at_ + begin.size();
      const std::size_t stop = std::min(latex_.find(end, from), latex_.size());
      const std::string body(latex_.substr(from, stop - from));
      add(Kind::verbatim, stop + end.size() - at_, name);
      tokens_.back().body = body;
      return true;
    }
    return false;
  }

  std::string_view latex_;
  int file_;
  bool at_is_letter_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::size_t line_begin_ = 0;
  bool starts_line_ = false;
  bool after_comment_ = false;
  PageTokens tokens_;
};

}  // namespace

PageTokens page_tokens(std::string_view latex, int file, bool at_is_letter) {
  return Tokenizer(latex, file, at_is_letter).run();
}

bool is_blank(const PageTokens& tokens) {
  return std::ranges::all_of(tokens, [](const PageToken& token) {
    return token.is(Kind::space) || token.is(Kind::paragraph);
  });
}

std::string latex_of_tokens(const PageTokens& tokens) {
  std::string latex;
  bool after_name = false;
  for (const PageToken& token : tokens) {
    if (after_name && (token.is(Kind::character) && is_letter(token.text.front()))) latex += ' ';
    after_name = token.is(Kind::command) && is_letter(token.text.front());
    if (token.is(Kind::command)) {
      latex += '\\' + token.text;
    } else if (token.is(Kind::parameter)) {
      latex += '#' + token.text;
    } else {
      latex += token.text;
    }
  }
  return latex;
}

}  // namespace literate
