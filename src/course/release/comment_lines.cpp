// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/comment_lines.hpp"

#include <filesystem>

#include "system/lines.hpp"

namespace course {

CommentSigns comment_signs(const std::string& file) {
  const std::string kind = std::filesystem::path(file).extension().string();
  if (kind == ".cpp" || kind == ".hpp" || kind == ".h" || kind == ".cc") return {"//", ""};
  if (kind == ".tex" || kind == ".sty" || kind == ".bib") return {"%", ""};
  if (kind == ".md" || kind == ".html" || kind == ".xml") return {"<!--", "-->"};
  return {"#", ""};
}

std::optional<std::string_view> words_of_comment(std::string_view line, const CommentSigns& signs) {
  std::string_view rest = sys::stripped(line);
  if (!rest.starts_with(signs.begin)) return {};
  rest.remove_prefix(signs.begin.size());
  // A comment may begin with several signs, as nbgrader writes ### BEGIN SOLUTION.
  while (signs.end.empty() && rest.starts_with(signs.begin.front())) rest.remove_prefix(1);
  if (!signs.end.empty() && !rest.ends_with(signs.end)) return {};
  rest.remove_suffix(signs.end.size());
  return sys::stripped(rest);
}

std::vector<LineWithEnd> lines_with_ends(std::string_view text) {
  std::vector<LineWithEnd> lines;
  while (!text.empty()) {
    const auto newline = text.find('\n');
    const auto size = newline == std::string_view::npos ? text.size() : newline + 1;
    std::string_view body = text.substr(0, newline);
    if (newline != std::string_view::npos && body.ends_with('\r')) body.remove_suffix(1);
    lines.push_back({body, text.substr(body.size(), size - body.size())});
    text.remove_prefix(size);
  }
  return lines;
}

}  // namespace course
