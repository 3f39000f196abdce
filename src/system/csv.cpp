// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/csv.hpp"

#include <csv.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <new>
#include <utility>

#include "system/error.hpp"
#include "system/text.hpp"

namespace sys {
namespace {

/// Gives the text to libcsv byte by byte, since the library does not say where a field stands.
class CsvReader {
 public:
  CsvReader(std::string file, CsvComments comments) : file_(std::move(file)), comments_(comments) {
    if (csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI) != 0) throw std::bad_alloc();
  }
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;
  ~CsvReader() { csv_free(&parser_); }

  std::vector<CsvRow> read(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    for (std::size_t at = 0; at < text.size(); ++at) {
      if (begins_comment(text.substr(at))) at = text.find('\n', at);
      if (at == text.npos) break;
      take(text[at]);
    }
    if (!is_in_field_) begin_ = {line_, place()};
    if (csv_fini(&parser_, end_field, end_row, this) != 0) {
      throw SourceError(begin_.place + ": a quote is not closed");
    }
    require_equal_rows();
    return std::move(rows_);
  }

 private:
  static bool is_blank(char byte) { return byte == ' ' || byte == '\t'; }
  static bool ends_line(char byte) { return byte == '\n' || byte == '\r'; }

  std::string place() const { return fmt::format("{}:{}:{}", file_, line_, column_); }

  // «#1» is a field.
  bool begins_comment(std::string_view rest) const {
    return comments_ == CsvComments::number_sign && rest.starts_with('#') &&
           (rest.size() == 1 || is_blank(rest[1]) || ends_line(rest[1])) && column_ == 1 &&
           !is_in_field_;
  }

  void take(char byte) {
    if (byte == '\0') throw SourceError(place() + ": there is a zero byte");
    const bool is_passed = is_blank(byte) || (row_.empty() && ends_line(byte));
    if (!is_in_field_ && !is_passed) {
      begin_ = {line_, place()};
      is_in_field_ = true;
      is_quoted_ = byte == '"';
    }
    if (csv_parse(&parser_, &byte, 1, end_field, end_row, this) != 1) refuse();
    require_equal_rows();
    ++column_;
    if (byte != '\n') return;
    ++line_;
    column_ = 1;
  }

  void require_equal_rows() const {
    if (rows_.empty() || rows_.back().size() == rows_.front().size()) return;
    const std::size_t n = rows_.back().size();
    throw SourceError(fmt::format("{}: the line has {} field{}, the first one has {}",
                                  rows_.back()[0].place, n, n == 1 ? "" : "s",
                                  rows_.front().size()));
  }

  [[noreturn]] void refuse() {
    if (csv_error(&parser_) != CSV_EPARSE) throw std::bad_alloc();
    throw SourceError(place() + (is_quoted_ ? ": there is text behind a quote that is closed"
                                            : ": a quote stands within a field that has none"));
  }

  static void end_field(void* bytes, std::size_t n_bytes, void* self) {
    auto& reader = *static_cast<CsvReader*>(self);
    reader.row_.push_back({.text = {static_cast<const char*>(bytes), n_bytes},
                           .line = reader.begin_.line,
                           .place = reader.begin_.place});
    reader.is_in_field_ = false;
  }

  static void end_row(int /*last byte*/, void* self) {
    auto& reader = *static_cast<CsvReader*>(self);
    reader.rows_.push_back(std::exchange(reader.row_, {}));
  }

  struct Begin {
    unsigned line = 1;
    std::string place;
  };

  csv_parser parser_{};
  std::string file_;
  CsvComments comments_;
  unsigned line_ = 1;
  std::size_t column_ = 1;
  Begin begin_;
  bool is_in_field_ = false;
  bool is_quoted_ = false;
  CsvRow row_;
  std::vector<CsvRow> rows_;
};

}  // namespace

std::vector<CsvRow> parse_csv(std::string_view text, const std::string& file,
                              CsvComments comments) {
  return CsvReader(file, comments).read(text);
}

std::string csv_field(std::string_view text) {
  const bool is_plain = text.find_first_of(",\"\r\n") == text.npos && !text.starts_with('#') &&
                        stripped(text).size() == text.size();
  if (is_plain) return std::string(text);
  std::string field(2 * text.size() + 2, '\0');  // every byte may be a quote, which is doubled
  field.resize(csv_write(field.data(), field.size(), text.data(), text.size()));
  return field;
}

std::string spreadsheet_field(std::string_view text) {
  constexpr std::string_view formula = "=+-@\t\r";
  const bool is_formula = !text.empty() && formula.find(text.front()) != formula.npos;
  return csv_field((is_formula ? "'" : "") + std::string(text));
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::vector<std::string> written;
  std::ranges::transform(fields, std::back_inserter(written), csv_field);
  return fmt::format("{}\n", fmt::join(written, ","));
}

}  // namespace sys
