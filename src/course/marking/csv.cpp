// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/csv.hpp"

namespace course {
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

}  // namespace course
