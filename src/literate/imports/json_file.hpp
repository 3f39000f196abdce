// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <json/value.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace literate {

/// A JSON file whose values know where they stand. Columns count bytes.
class JsonFile {
 public:
  /// Reads JSON without NaN and without a key twice in an object. Throws ImportError
  /// «file:line:column: message».
  explicit JsonFile(const std::filesystem::path& file);

  const std::string& text() const { return text_; }
  const Json::Value& root() const { return root_; }

  /// The line of a value, counted from 1.
  unsigned line(const Json::Value& value) const;

  /// «file:line:column» of a value.
  std::string at(const Json::Value& value) const;

  /// A number as it is written in the file.
  std::string_view written(const Json::Value& value) const;

  /// Throws ImportError at a value.
  [[noreturn]] void fail(const Json::Value& value, const std::string& message) const;

  /// Throws ImportError unless `value` is an object with no other fields than these; `what` says
  /// what it describes.
  void require_fields(const Json::Value& value, const std::string& what,
                      const std::vector<std::string>& allowed) const;

 private:
  std::filesystem::path file_;
  std::string text_;
  Json::Value root_;
};

}  // namespace literate
