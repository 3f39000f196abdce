// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/entries.hpp"

#include <fmt/core.h>
#include <toml++/toml.h>

#include <sstream>

#include "config/table.hpp"
#include "system/lines.hpp"

namespace config {
namespace {

using Entries = std::map<std::string, std::string>;

std::string text_of(const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (const auto number = node.value_exact<double>()) return fmt::format("{}", *number);
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return sys::one_line(text.str());
}

void collect(const toml::table& table, const std::string& prefix, Entries& entries) {
  const toml::node* const value = table.get("value");
  const toml::node* const unit = table.get("unit");
  if (value != nullptr && unit != nullptr && table.size() == 2 && !prefix.empty()) {
    entries[prefix.substr(0, prefix.size() - 1)] = text_of(*value) + " " + text_of(*unit);
    return;
  }
  for (const auto& [key, node] : table) {
    const std::string path = prefix + std::string(key.str());
    if (const toml::table* const below = node.as_table()) {
      collect(*below, path + ".", entries);
    } else if (node.is_array_of_tables()) {
      std::size_t i = 0;
      for (const toml::node& element : *node.as_array()) {
        collect(*element.as_table(), fmt::format("{}.{}.", path, ++i), entries);
      }
    } else {
      entries[path] = text_of(node);
    }
  }
}

}  // namespace

Entries entries_of(const std::filesystem::path& file) {
  Entries entries;
  try {
    collect(toml::parse_file(file.string()), "", entries);
  } catch (const toml::parse_error& error) {
    throw Error(fmt::format("{}: {}", file.string(), std::string(error.description())));
  }
  return entries;
}

}  // namespace config
