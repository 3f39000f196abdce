// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/html_text.hpp"

namespace literate {
namespace {

// The name in a tag, with the slash of a closing one.
std::string_view tag_name(std::string_view tag) {
  const std::size_t end = tag.find_first_of(" >\n", 1);
  return tag.substr(1, end - 1);
}

std::string without_ids(std::string_view tag) {
  std::string kept(tag);
  for (const std::string_view attribute : {" id=\"", " href=\""}) {
    const std::size_t begin = kept.find(attribute);
    if (begin == std::string::npos) continue;
    kept.erase(begin, kept.find('"', begin + attribute.size()) + 1 - begin);
  }
  return kept;
}

}  // namespace

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
  std::string text;
  bool is_in_tag = false;
  for (const char c : html) {
    if (c == '<') is_in_tag = true;
    const bool is_blank = c == ' ' || c == '\n' || c == '\t';
    if (!is_in_tag && !(is_blank && (text.empty() || text.back() == ' '))) {
      text += is_blank ? ' ' : c;
    }
    if (c == '>') is_in_tag = false;
  }
  if (text.ends_with(' ')) text.pop_back();
  return text;
}

std::string without_links(std::string_view html) {
  std::string kept;
  int footnote_depth = 0;
  while (!html.empty()) {
    const std::size_t begin = html.find('<');
    if (footnote_depth == 0) kept += html.substr(0, begin);
    if (begin == std::string_view::npos) break;
    const std::size_t end = html.find('>', begin);
    const std::string_view tag = html.substr(begin, end + 1 - begin);
    html.remove_prefix(end + 1);
    const std::string_view name = tag_name(tag);
    const bool is_footnote = tag.find("class=\"lit-note") != std::string_view::npos;
    if (footnote_depth > 0 || is_footnote) {
      if (name == "span" || name == "sup") ++footnote_depth;
      if (name == "/span" || name == "/sup") --footnote_depth;
      continue;
    }
    if (name != "a" && name != "/a") kept += without_ids(tag);
  }
  return kept;
}

std::string without_paragraph(std::string html) {
  static constexpr std::string_view begin = "<p>";
  static constexpr std::string_view end = "</p>\n";
  const bool is_single = html.starts_with(begin) && html.ends_with(end) && html.rfind("<p") == 0;
  return is_single ? html.substr(begin.size(), html.size() - begin.size() - end.size()) : html;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace literate
