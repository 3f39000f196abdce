// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/assignment/student_text.hpp"

#include <fstream>

namespace course {
namespace {

/// Bytes of the UTF-8 character that a text begins with; 0 if it begins with none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  // Overlong forms, surrogates, and what is beyond the last code point.
  const bool is_wrong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) > 0x9F) ||
                        (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) > 0x8F);
  // C1 control characters, and U+FFFE, U+FFFF, which XML does not take.
  const bool is_control =
      (first == 0xC2 && byte(1) < 0xA0) || (first == 0xEF && byte(1) == 0xBF && byte(2) >= 0xBE);
  return is_wrong || is_control ? 0 : length;
}

bool is_control(char character) {
  const auto code = static_cast<unsigned char>(character);
  return (code < 0x20 && character != '\n' && character != '\t') || code == 0x7F;
}

}  // namespace

std::string shown(std::string_view text, std::size_t max_bytes) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const bool is_bad = length == 0 || is_control(text.front());
    if (result.size() + (is_bad ? 1 : length) > max_bytes) return result + "\n[… cut]";
    if (is_bad) {
      result += '?';
    } else {
      result += text.substr(0, length);
    }
    text.remove_prefix(is_bad ? 1 : length);
  }
  return result;
}

std::string shown_name(std::string_view name) {
  std::string result = shown(name.substr(0, 200), 200);
  for (char& character : result) {
    if (character == '\n' || character == '\t') character = '?';
  }
  return name.size() > 200 ? result + "…" : result;
}

std::string beginning_of(const std::filesystem::path& file, std::size_t max_bytes) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(max_bytes, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(max_bytes));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace course
