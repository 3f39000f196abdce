// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/csv_columns.hpp"

#include <fmt/core.h>

#define CSV_IO_NO_THREAD
#include <libfccp/csv.h>

#include <filesystem>

#include "command_line/number_text.hpp"

namespace app {
namespace {

using Reader = io::CSVReader<2, io::trim_chars<' ', '\t'>, io::no_quote_escape<','>,
                             io::throw_on_overflow, io::single_and_empty_line_comment<'#'>>;

// The library's error about a file, in the form of this program's messages.
std::string message_of(const std::string& file, const std::string& heading,
                       const io::error::base& error) {
  const auto* at = dynamic_cast<const io::error::with_file_line*>(&error);
  if (at != nullptr && at->file_line > 0) {
    return fmt::format("{}:{}: wanted are the columns {}", file, at->file_line, heading);
  }
  if (dynamic_cast<const io::error::can_not_open_file*>(&error) != nullptr) {
    return fmt::format("{}: cannot be read", file);
  }
  return fmt::format("{}:1: the heading must be {}", file, heading);
}

}  // namespace

CsvColumns read_columns(const std::string& file, const std::string& first,
                        const std::string& second) {
  if (std::filesystem::is_directory(file)) throw sys::InputError(file + ": is a folder");
  CsvColumns columns;
  try {
    Reader reader(file);
    reader.read_header(io::ignore_no_column, first, second);
    std::string first_text;
    std::string second_text;
    while (reader.read_row(first_text, second_text)) {
      const unsigned line = reader.get_file_line();
      const std::string place = fmt::format("{}:{}: ", file, line);
      columns.first.push_back(command_line::parse_number(place + first, first_text));
      columns.second.push_back(command_line::parse_number(place + second, second_text));
      columns.lines.push_back(line);
    }
  } catch (const io::error::base& error) {
    throw sys::InputError(message_of(file, first + "," + second, error));
  }
  return columns;
}

}  // namespace app
