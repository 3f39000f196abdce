// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/assignment/student.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/predicate.hpp>
#include <fstream>
#include <locale>
#include <string_view>

#include "system/error.hpp"
#include "system/text.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::string_view, 9> endings = {
    ".zip", ".7z", ".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tbz2", ".tar.xz", ".tar.zst"};

// Some systems write the ending in capitals.
std::string_view ending_of(std::string_view name) {
  const auto* ending = std::ranges::find_if(endings, [&](std::string_view end) {
    return boost::algorithm::iends_with(name, end, std::locale::classic());
  });
  return ending == endings.end() ? std::string_view{} : *ending;
}

bool is_id_character(char c) {
  return sys::is_alphanumeric(c) || c == '.' || c == '_' || c == '-' || c == '@';
}

}  // namespace

void require_student_id(const std::string& student) {
  const bool is_plain = std::ranges::all_of(student, is_id_character);
  const bool begins_ill = student.find_first_of(".-@") == 0;
  const bool ends_ill = student.ends_with(".part") || names_archive(student);
  if (!student.empty() && student.size() <= 64 && is_plain && !begins_ill && !ends_ill) return;
  throw sys::SourceError(fmt::format(
      "student \"{}\": an id consists of 1 to 64 letters, digits, '.', '_', '-' and '@', does not "
      "begin with '.', '-' or '@' and does not end with .part, .zip or another archive's ending",
      shown_name(student)));
}

std::string archive_endings() {
  return fmt::format("{}", fmt::join(endings, ", "));
}

bool names_archive(const fs::path& path) {
  return !ending_of(path.filename().string()).empty();
}

std::string student_of(const fs::path& path) {
  fs::path clean = fs::absolute(path).lexically_normal();
  if (!clean.has_filename()) clean = clean.parent_path();
  const std::string name = clean.filename().string();
  if (fs::is_directory(fs::symlink_status(path))) return name;
  return name.substr(0, name.size() - ending_of(name).size());
}

namespace {

/// Whether a character changes the direction in which the characters after it are shown, so that a
/// text would look like another one.
bool turns_text(char32_t code) {
  return code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

/// Whether a character may be shown: it is no control character but tab and line end, ends no line
/// but by these, does not turn the text, and is neither U+FFFE nor U+FFFF, which XML does not take.
bool is_shown(char32_t code) {
  if (code == '\n' || code == '\t') return true;
  const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  const bool ends_line = code == 0x2028 || code == 0x2029;
  return !is_control && !ends_line && !turns_text(code) && code != 0xFFFE && code != 0xFFFF;
}

}  // namespace

std::string shown(std::string_view text, std::size_t max_bytes) {
  std::string result;
  while (!text.empty()) {
    const auto [bytes, code_point] = sys::first_character(text);
    const std::string_view good = code_point && is_shown(*code_point) ? bytes : "?";
    if (result.size() + good.size() > max_bytes) return result + "\n[… cut]";
    result += good;
    text.remove_prefix(bytes.size());
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
  std::string text;
  std::array<char, 65536> chunk{};  // most files are small
  while (text.size() < max_bytes && stream) {
    const std::size_t most = std::min(chunk.size(), max_bytes - text.size());
    stream.read(chunk.data(), static_cast<std::streamsize>(most));
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
  }
  return text;
}

}  // namespace course
