// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "config/units.hpp"
#include "system/require.hpp"

namespace config {

/// A mistake in a case file. what() is one line: «file:line:column: key: message».
class Error : public sys::InputError {
 public:
  using InputError::InputError;
};

/// A table of a TOML file, read strictly: a missing or unknown key or a value of the wrong type or
/// unit is an error with its place in the file. A misspelt key is an error with a suggestion.
///
/// A quantity is written {value = 30e6, unit = "psi"}. It may have any unit of the right dimension;
/// config::converted() converts it. A copy is a view of the same file.
class Table {
 public:
  /// Parses a file. Throws Error if the file cannot be read or is not valid TOML.
  static Table parse_file(const std::filesystem::path& path);

  bool has(const std::string& key) const;
  /// All keys of the table, sorted.
  std::vector<std::string> keys() const;

  Table table(const std::string& key) const;
  std::string text(const std::string& key) const;
  std::vector<std::string> texts(const std::string& key) const;
  double number(const std::string& key) const;
  long integer(const std::string& key) const;
  double quantity(const std::string& key, Dimension dimension, const UnitSystem& units) const;
  /// Reads a quantity in any unit that UDUNITS-2 knows, such as "m/s2".
  double quantity(const std::string& key, const std::string& unit) const;

  /// Whether the key exists and its value is this text.
  bool is_text(const std::string& key, const std::string& text) const;

  /// Returns make(). If that throws InvalidQuantity or UnitError, throws Error with the same
  /// message and the place of `key`.
  template <class Make>
  auto at(const std::string& key, Make&& make) const {
    try {
      return make();
    } catch (const sys::InvalidQuantity& e) {
      fail(key, e.what());
    } catch (const UnitError& e) {
      fail(key, e.what());
    }
  }

  /// Throws Error for the first key in this table or below that was never read. Skips the tables in
  /// `left_to_others`, which have separate readers.
  void reject_unknown_keys(const std::set<std::string>& left_to_others = {}) const;

  /// Returns «file:line:column» of the value of `key`, or of the table if it has no such key.
  std::string place(const std::string& key) const;

  /// Throws Error with place(key), the key and the message.
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;

 private:
  struct Node;
  explicit Table(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;
};

}  // namespace config
