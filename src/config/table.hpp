// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "config/printed_number.hpp"
#include "config/units.hpp"
#include "system/require.hpp"

namespace config {

/// A case file that is not right. what() is one line: «file:line:column: key: what and what not».
class Error : public sys::InputError {
 public:
  using InputError::InputError;
};

/// A table of a TOML file, read strictly: a key that is missing, of the wrong type or unit, or that
/// nobody asked for is an error with its place in the file.
///
/// A quantity is written {value = 30e6, unit = "psi"}; any unit of the right dimension is converted
/// to the given system's. Copies are views of the same file.
class Table {
 public:
  /// Parses a file; throws Error if it cannot be read or is not TOML (doubled keys included).
  static Table parse_file(const std::filesystem::path& path);

  bool has(const std::string& key) const;
  Table table(const std::string& key) const;

  /// The tables of an array of tables, [[key]], which has at least one; none without the key.
  std::vector<Table> tables(const std::string& key) const;

  std::string text(const std::string& key) const;
  double number(const std::string& key) const;
  long integer(const std::string& key) const;
  double quantity(const std::string& key, Dimension dimension, const UnitSystem& units) const;
  std::vector<PrintedNumber> printed_numbers(const std::string& key) const;
  PrintedNumber printed_number(const std::string& key) const;
  std::vector<std::string> texts(const std::string& key) const;

  /// A date and time with its offset from UTC, such as 2027-01-15T23:59:00Z.
  std::chrono::sys_seconds instant(const std::string& key) const;

  /// All keys of the table, sorted.
  std::vector<std::string> keys() const;

  /// Whether the value of the key is the given text.
  bool is_text(const std::string& key, const std::string& text) const;

  /// Calls make() and gives an InvalidQuantity or UnitError that it throws the place of `key`.
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

  /// Throws Error for the first key, here or below, that nobody has asked for. Tables of this one
  /// that are named in `left_to_others` are not looked into: their own readers do so.
  void reject_unknown_keys(const std::set<std::string>& left_to_others = {}) const;

  /// Where the value of `key` stands (or the table, where it has no such key): «file:line:column».
  std::string place(const std::string& key) const;

  /// Throws Error at place(key).
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;

 private:
  struct Node;
  explicit Table(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;
};

}  // namespace config
