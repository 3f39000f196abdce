// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/record.hpp"

#include <fmt/core.h>

#include "system/files.hpp"

namespace sys {
namespace fs = std::filesystem;
namespace {

// sha256sum writes these characters of a name by two, and a backslash before such a line.
constexpr std::string_view escaped_characters = "\\\n\r";
constexpr std::string_view escape_letters = "\\nr";

std::string escaped(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const auto at = escaped_characters.find(c);
    if (at == std::string_view::npos) {
      text += c;
    } else {
      text += {'\\', escape_letters[at]};
    }
  }
  return text;
}

std::string unescaped(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_escape = text[i] == '\\' && i + 1 < text.size();
    const auto letter = is_escape ? escape_letters.find(text[++i]) : std::string_view::npos;
    name += letter == std::string_view::npos ? text[i] : escaped_characters[letter];
  }
  return name;
}

}  // namespace

RecordEntry record_entry(const fs::path& folder, const std::string& file) {
  const bool is_there = fs::is_regular_file(folder / file);
  return {is_there ? sha256_of_file(folder / file) : "-", file};
}

Record record_entries(const fs::path& folder, const std::vector<std::string>& files) {
  Record record;
  for (const std::string& file : files) record.push_back(record_entry(folder, file));
  return record;
}

bool is_as_recorded(const fs::path& folder, const RecordEntry& entry) {
  const fs::path file = folder / entry.name;
  return fs::is_regular_file(file) && sha256_of_file(file) == entry.digest;
}

std::string record_text(const Record& record) {
  std::string text;
  for (const auto& [digest, name] : record) {
    const std::string written = escaped(name);
    text += fmt::format("{}{}  {}\n", written == name ? "" : "\\", digest, written);
  }
  return text;
}

std::optional<Record> parse_record(std::string_view text) {
  Record record;
  while (!text.empty()) {
    const auto end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.starts_with('#')) continue;
    const bool is_escaped = line.starts_with('\\');
    if (is_escaped) line.remove_prefix(1);
    const auto blank = line.find("  ");
    if (blank == std::string_view::npos) return std::nullopt;
    const std::string_view name = line.substr(blank + 2);
    record.push_back(
        {std::string(line.substr(0, blank)), is_escaped ? unescaped(name) : std::string(name)});
  }
  return record;
}

}  // namespace sys
