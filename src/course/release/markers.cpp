// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/markers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "system/error.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace course {
namespace {

enum class Region { solution, hidden_tests };

// Whether a line has the words of a marker, however they are spelt. A misspelt marker would give a
// solution away.
bool looks_like_marker(std::string_view line) {
  static const sys::Pattern words(
      R"re((^|[^a-z])(begin|end)[ \t_-]+(solutions?|hidden[ \t_-]+tests?)\b)re", true);
  return words.is_in(line);
}

/// Reads the lines of one file and divides them.
class Divider {
 public:
  explicit Divider(const std::string& file) : file_(file), comment_(comment_signs(file)) {}

  void read(const LineWithEnd& line) {
    ++number_;
    const auto words = words_of_comment(line.text, comment_);
    if (words && acts_on(*words, line)) return;
    if (looks_like_marker(line.text)) {
      fail(number_,
           fmt::format("a marker is a line «{} BEGIN SOLUTION», «… END SOLUTION», «… BEGIN "
                       "HIDDEN TESTS: name» or «… END HIDDEN TESTS»",
                       comment_.begin));
    }
    add(line);
  }

  MarkedText finish() {
    if (region_) fail(begin_line_, fmt::format("{} has no END", name_of(*region_)));
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(int line, std::string_view message) const {
    throw sys::SourceError(fmt::format("{}:{}: {}", file_, line, message));
  }
  static std::string_view name_of(Region region) {
    return region == Region::solution ? "BEGIN SOLUTION" : "BEGIN HIDDEN TESTS";
  }

  bool acts_on(std::string_view words, const LineWithEnd& line);
  void begin(Region region, const LineWithEnd& line);
  void end(Region region, const LineWithEnd& line);
  void stub(std::string_view text);
  void add(const LineWithEnd& line);

  std::string file_;
  CommentSigns comment_;
  int number_ = 0;
  std::optional<Region> region_;
  int begin_line_ = 0;
  bool takes_stubs_ = false;
  std::string indentation_, line_end_;
  MarkedText result_;
};

/// Does what a marker says; false if the words are none.
bool Divider::acts_on(std::string_view words, const LineWithEnd& line) {
  constexpr std::string_view begin_hidden = "BEGIN HIDDEN TESTS";
  if (words == "BEGIN SOLUTION") {
    begin(Region::solution, line);
  } else if (words == "END SOLUTION") {
    end(Region::solution, line);
  } else if (words == begin_hidden || words.starts_with(std::string(begin_hidden) + ":")) {
    begin(Region::hidden_tests, line);
    words.remove_prefix(std::min(begin_hidden.size() + 1, words.size()));
    const std::string_view name = sys::stripped(words);
    if (!name.empty()) result_.hidden_regions.emplace_back(name);
  } else if (words == "END HIDDEN TESTS") {
    end(Region::hidden_tests, line);
  } else if (words.starts_with("STUB:")) {
    stub(words.substr(words.starts_with("STUB: ") ? 6 : 5));
  } else {
    return false;
  }
  return true;
}

void Divider::begin(Region region, const LineWithEnd& line) {
  if (region_) {
    fail(number_, fmt::format("{} inside the {} of line {}", name_of(region), name_of(*region_),
                              begin_line_));
  }
  region_ = region;
  begin_line_ = number_;
  if (region == Region::hidden_tests) return;
  takes_stubs_ = true;
  indentation_ = line.text.substr(0, line.text.find_first_not_of(" \t"));
  line_end_ = line.end;
  const std::string_view space = comment_.end.empty() ? "" : " ";
  result_.handout += fmt::format("{}{} YOUR SOLUTION HERE{}{}{}", indentation_, comment_.begin,
                                 space, comment_.end, line_end_);
}

void Divider::end(Region region, const LineWithEnd& line) {
  if (region_ != region) {
    fail(number_, fmt::format("this END has no {} before it", name_of(region)));
  }
  region_.reset();
  takes_stubs_ = false;
  // If the file ends without a newline, so does the handout.
  if (region == Region::solution && line.end.empty() && result_.handout.ends_with(line_end_)) {
    result_.handout.resize(result_.handout.size() - line_end_.size());
  }
}

void Divider::stub(std::string_view text) {
  if (!takes_stubs_) fail(number_, "STUB may only stand below BEGIN SOLUTION");
  if (!text.empty()) result_.handout += indentation_;
  result_.handout.append(text).append(line_end_);
}

void Divider::add(const LineWithEnd& line) {
  takes_stubs_ = false;
  result_.solution.append(line.text).append(line.end);
  if (!region_) {
    result_.handout.append(line.text).append(line.end);
  } else if (!sys::stripped(line.text).empty()) {
    result_.secrets.push_back({number_, begin_line_, std::string(line.text)});
  }
}

}  // namespace

MarkedText apply_markers(std::string_view text, const std::string& file) {
  Divider divider(file);
  for (const LineWithEnd& line : lines_with_ends(text)) divider.read(line);
  return divider.finish();
}

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
