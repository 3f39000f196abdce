// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/imports/json_file.hpp"

#include <fmt/ranges.h>
#include <json/reader.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <memory>

#include "literate/imports/import_error.hpp"
#include "literate/imports/source_files.hpp"
#include "system/lines.hpp"

namespace literate {
namespace {

struct Position {
  unsigned line = 1;
  unsigned column = 1;
};

Position position_in(const std::string& text, std::ptrdiff_t offset) {
  const auto end = text.begin() + offset;
  const auto n_before = std::count(text.begin(), end, '\n');
  const auto line_begin = std::find(std::reverse_iterator(end), text.rend(), '\n').base();
  return {static_cast<unsigned>(n_before + 1), static_cast<unsigned>(end - line_begin + 1)};
}

/// What the library says of the first error, «* Line 3, Column 7» and a line with the message.
ImportError syntax_error(const std::filesystem::path& file, const std::string& said) {
  const auto lines = sys::lines_of(said);
  Position at;
  if (lines.size() < 2 ||
      std::sscanf(said.c_str(), "* Line %u, Column %u", &at.line, &at.column) != 2) {
    return ImportError(fmt::format("{}: is not JSON: {}", file.string(), said));
  }
  return ImportError(fmt::format("{}:{}:{}: is not JSON: {}", file.string(), at.line, at.column,
                                 sys::stripped(lines[1])));
}

}  // namespace

JsonFile::JsonFile(const std::filesystem::path& file) : file_(file), text_(read_numbers(file)) {
  Json::CharReaderBuilder strict;
  Json::CharReaderBuilder::strictMode(&strict.settings_);
  const std::unique_ptr<Json::CharReader> reader(strict.newCharReader());
  std::string said;
  try {
    if (reader->parse(text_.data(), text_.data() + text_.size(), &root_, &said)) return;
  } catch (const Json::Exception& error) {  // what is nested too deeply
    said = error.what();
  }
  throw syntax_error(file, said);
}

unsigned JsonFile::line(const Json::Value& value) const {
  return position_in(text_, value.getOffsetStart()).line;
}

std::string JsonFile::at(const Json::Value& value) const {
  const Position position = position_in(text_, value.getOffsetStart());
  return fmt::format("{}:{}:{}", file_.string(), position.line, position.column);
}

std::string_view JsonFile::written(const Json::Value& value) const {
  const auto start = static_cast<std::size_t>(value.getOffsetStart());
  const auto limit = static_cast<std::size_t>(value.getOffsetLimit());
  return std::string_view(text_).substr(start, limit - start);
}

void JsonFile::fail(const Json::Value& value, const std::string& message) const {
  throw ImportError(fmt::format("{}: {}", at(value), message));
}

void JsonFile::require_fields(const Json::Value& value, const std::string& what,
                              const std::vector<std::string>& allowed) const {
  if (!value.isObject()) fail(value, what + " must be an object");
  for (const std::string& field : value.getMemberNames()) {
    if (std::ranges::find(allowed, field) != allowed.end()) continue;
    fail(value[field], fmt::format("{} has an unknown field '{}'; known are {}", what, field,
                                   fmt::join(allowed, ", ")));
  }
}

}  // namespace literate
