// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace literate {

/// A value in a JSON file that is read strictly: a missing, unknown or repeated key, or one of the
/// wrong type, is an Error «FILE: values.period.bound: …». A copy is a view of the same file.
class StrictJson {
 public:
  /// Parses a file. Throws Error, with line and column, for invalid JSON or a repeated key.
  static StrictJson parse_file(const std::filesystem::path& file);

  /// Throws Error unless this is an object with no other keys. The message suggests the nearest
  /// key.
  void require_keys(std::initializer_list<std::string_view> allowed) const;

  bool has(const std::string& key) const;
  StrictJson operator[](const std::string& key) const;
  std::optional<StrictJson> find(const std::string& key) const;

  /// The entries of an object, in their order, and the elements of an array.
  std::vector<std::pair<std::string, StrictJson>> entries() const;
  std::vector<StrictJson> elements() const;

  bool is_null() const { return json_->is_null(); }
  bool is_text() const { return json_->is_string(); }
  bool is_number() const { return json_->is_number(); }
  bool is_integer() const { return json_->is_number_integer(); }

  std::string text() const;
  double number() const;
  int integer() const;
  bool boolean() const;

  const std::string& file() const { return file_; }
  /// Throws Error with the file, the path of keys to this value, and the message.
  [[noreturn]] void fail(std::string_view message) const;

  /// Runs `make`, and turns its std::invalid_argument into an Error at this value.
  template <typename Make>
  auto at_this(Make&& make) const {
    try {
      return std::forward<Make>(make)();
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
  }

 private:
  using Json = nlohmann::ordered_json;
  StrictJson(std::shared_ptr<const Json> json, std::string file, std::string path)
      : json_(std::move(json)), file_(std::move(file)), path_(std::move(path)) {}
  StrictJson child(const Json& json, const std::string& name) const;
  void require(bool is_of_type, std::string_view what) const;

  std::shared_ptr<const Json> json_;
  std::string file_;
  std::string path_;
};

}  // namespace literate
