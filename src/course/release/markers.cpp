// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/markers.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <optional>

#include "system/error.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace course {
namespace {

enum class Kind { begin_solution, end_solution, begin_hidden, end_hidden, stub };

struct Marker {
  Kind kind;
  std::string text;  // the stub, or the name of hidden tests
};

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
    if (const auto marker = marker_in(line.text)) {
      act(*marker, line);
      return;
    }
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
  static std::string_view name_of(Kind begin) {
    return begin == Kind::begin_solution ? "BEGIN SOLUTION" : "BEGIN HIDDEN TESTS";
  }

  std::optional<Marker> marker_in(std::string_view line) const;
  void act(const Marker& marker, const LineWithEnd& line);
  void begin(const Marker& marker, const LineWithEnd& line);
  void end(Kind begin, const LineWithEnd& line);
  void stub(const std::string& text);
  void add(const LineWithEnd& line);

  std::string file_;
  CommentSigns comment_;
  int number_ = 0;
  std::optional<Kind> region_;
  int begin_line_ = 0;
  bool takes_stubs_ = false;
  std::string indentation_, line_end_;
  MarkedText result_;
};

std::optional<Marker> Divider::marker_in(std::string_view line) const {
  const auto words = words_of_comment(line, comment_);
  if (!words) return {};
  if (*words == "BEGIN SOLUTION") return Marker{Kind::begin_solution, ""};
  if (*words == "END SOLUTION") return Marker{Kind::end_solution, ""};
  if (*words == "END HIDDEN TESTS") return Marker{Kind::end_hidden, ""};
  if (*words == "BEGIN HIDDEN TESTS") return Marker{Kind::begin_hidden, ""};
  if (words->starts_with("BEGIN HIDDEN TESTS:")) {
    return Marker{Kind::begin_hidden, std::string(sys::stripped(words->substr(19)))};
  }
  if (words->starts_with("STUB:")) {
    const std::string_view text = words->substr(5);
    return Marker{Kind::stub, std::string(text.substr(text.starts_with(' ') ? 1 : 0))};
  }
  return {};
}

void Divider::act(const Marker& marker, const LineWithEnd& line) {
  switch (marker.kind) {
    case Kind::begin_solution:
    case Kind::begin_hidden:
      return begin(marker, line);
    case Kind::end_solution:
      return end(Kind::begin_solution, line);
    case Kind::end_hidden:
      return end(Kind::begin_hidden, line);
    case Kind::stub:
      return stub(marker.text);
  }
}

void Divider::begin(const Marker& marker, const LineWithEnd& line) {
  if (region_) {
    fail(number_, fmt::format("{} inside the {} of line {}", name_of(marker.kind),
                              name_of(*region_), begin_line_));
  }
  region_ = marker.kind;
  begin_line_ = number_;
  if (!marker.text.empty()) result_.hidden_regions.push_back(marker.text);
  if (marker.kind == Kind::begin_hidden) return;
  takes_stubs_ = true;
  indentation_ = line.text.substr(0, line.text.find_first_not_of(" \t"));
  line_end_ = line.end;
  const std::string_view space = comment_.end.empty() ? "" : " ";
  result_.handout += fmt::format("{}{} YOUR SOLUTION HERE{}{}{}", indentation_, comment_.begin,
                                 space, comment_.end, line_end_);
}

void Divider::end(Kind begin, const LineWithEnd& line) {
  if (region_ != begin) {
    fail(number_, fmt::format("this END has no {} before it", name_of(begin)));
  }
  region_.reset();
  takes_stubs_ = false;
  // If the file ends without a newline, so does the handout.
  const bool was_solution = begin == Kind::begin_solution;
  if (was_solution && line.end.empty() && result_.handout.ends_with(line_end_)) {
    result_.handout.resize(result_.handout.size() - line_end_.size());
  }
}

void Divider::stub(const std::string& text) {
  if (!takes_stubs_) fail(number_, "STUB may only stand below BEGIN SOLUTION");
  result_.handout += (text.empty() ? "" : indentation_) + text + line_end_;
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
