// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/csv.hpp"

#include <fmt/core.h>

#include "system/error.hpp"

namespace course {
namespace {

/// A text that is read from its beginning to its end.
class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& file) : text_(text), file_(file) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
  }

  std::vector<CsvRow> read() {
    std::vector<CsvRow> rows;
    while (at_ < text_.size()) {
      CsvRow row = read_row();
      if (row.size() == 1 && row[0].text.empty()) continue;
      if (!rows.empty() && row.size() != rows[0].size()) {
        throw sys::SourceError(fmt::format("{}: the line has {} fields, the first one has {}",
                                           row[0].place, row.size(), rows[0].size()));
      }
      rows.push_back(std::move(row));
    }
    return rows;
  }

 private:
  bool is_over() const { return at_ == text_.size(); }
  bool is_at_line_end() const {
    return is_over() || text_[at_] == '\n' || text_.substr(at_, 2) == "\r\n";
  }
  std::string place() const {
    return fmt::format("{}:{}:{}", file_, line_, at_ - begin_of_line_ + 1);
  }

  char take() {
    const char character = text_[at_++];
    if (character == '\n') {
      ++line_;
      begin_of_line_ = at_;
    }
    return character;
  }

  void skip_blanks() {
    while (!is_over() && (text_[at_] == ' ' || text_[at_] == '\t')) take();
  }

  CsvRow read_row() {
    CsvRow row = {read_field()};
    while (!is_over() && text_[at_] == ',') {
      take();
      row.push_back(read_field());
    }
    if (!is_over() && text_[at_] == '\r') take();
    if (!is_over()) take();
    return row;
  }

  CsvField read_field() {
    skip_blanks();
    CsvField field{.text = {}, .place = place()};
    if (!is_over() && text_[at_] == '"') {
      field.text = read_quoted(field.place);
      skip_blanks();
      if (!is_at_line_end() && text_[at_] != ',') {
        throw sys::SourceError(place() + ": there is text behind a quote that is closed");
      }
      return field;
    }
    while (!is_at_line_end() && text_[at_] != ',') field.text += take();
    field.text.erase(field.text.find_last_not_of(" \t") + 1);
    return field;
  }

  std::string read_quoted(const std::string& begin) {
    std::string text;
    take();
    while (!is_over()) {
      const char character = take();
      if (character != '"') {
        text += character;
      } else if (!is_over() && text_[at_] == '"') {
        text += take();
      } else {
        return text;
      }
    }
    throw sys::SourceError(begin + ": a quote is not closed");
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::size_t begin_of_line_ = 0;
  int line_ = 1;
};

}  // namespace

std::string csv_field(std::string_view text) {
  constexpr std::string_view formula = "=+-@\t\r";
  std::string field;
  if (!text.empty() && formula.find(text.front()) != formula.npos) field = "'";
  field += text;
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char character : field) {
    if (character == '"') quoted += '"';
    quoted += character;
  }
  return quoted + '"';
}

std::vector<CsvRow> parse_csv(std::string_view text, const std::string& file) {
  return CsvReader(text, file).read();
}

}  // namespace course
