// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/csv.hpp"

#include "system/text.hpp"

namespace sys {

std::string csv_field(std::string_view text) {
  const bool is_plain = text.find_first_of(",\"\r\n") == text.npos && !text.starts_with('#') &&
                        stripped(text).size() == text.size();
  if (is_plain) return std::string(text);
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + "\"";
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields)
    line += (&field == &fields.front() ? "" : ",") + csv_field(field);
  return line + "\n";
}

}  // namespace sys
