// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/html_text.hpp"

namespace literate {

std::string escape_html(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string text_of_html(std::string_view html) {
  constexpr std::string_view annotation = "<annotation", annotation_end = "</annotation>";
  std::string text;
  while (!html.empty()) {
    const char c = html.front();
    if (c == '<') {
      const bool is_annotation = html.starts_with(annotation);
      const auto end = is_annotation ? html.find(annotation_end) : html.find('>');
      if (end == html.npos) break;
      html.remove_prefix(end + (is_annotation ? annotation_end.size() : 1));
      continue;
    }
    const bool is_blank = c == ' ' || c == '\n' || c == '\t';
    if (!is_blank) text += c;
    if (is_blank && !text.empty() && text.back() != ' ') text += ' ';
    html.remove_prefix(1);
  }
  if (text.ends_with(' ')) text.pop_back();
  return text;
}

std::string one_word(const std::string& verdict) {
  return verdict.substr(0, verdict.find(' '));
}

std::string without_blanks(std::string_view text) {
  std::string kept;
  for (const char c : text) {
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') kept += c;
  }
  return kept;
}

}  // namespace literate
