// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/csv.hpp"

#include "system/error.hpp"

namespace course {
namespace {

/// Takes a field in quotes off the front of a line.
std::string take_quoted(std::string_view& line) {
  std::string field;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] != '"') {
      field += line[i];
    } else if (i + 1 < line.size() && line[i + 1] == '"') {
      field += line[i++];
    } else {
      line.remove_prefix(i + 1);
      if (!line.empty() && line.front() != ',') break;
      return field;
    }
  }
  throw sys::SourceError("a quote is not closed, or something follows it");
}

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

std::vector<std::string> csv_fields(std::string_view line) {
  std::vector<std::string> fields;
  for (;;) {
    if (line.starts_with('"')) {
      fields.push_back(take_quoted(line));
    } else {
      const std::string_view field = line.substr(0, line.find(','));
      if (field.find('"') != field.npos) throw sys::SourceError("a quote inside a field");
      fields.emplace_back(field);
      line.remove_prefix(field.size());
    }
    if (line.empty()) return fields;
    line.remove_prefix(1);
  }
}

}  // namespace course
