// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/changes/changes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace literate {
namespace {

/// «table a, row 2, column 1» in parts, of which the first is «table a».
struct CellName {
  std::string table, row, column;
};

std::optional<CellName> cell_in(const std::string& name) {
  constexpr std::string_view table = "table ", row = ", row ", column = ", column ";
  const auto at_row = name.rfind(row), at_column = name.rfind(column);
  if (!name.starts_with(table) || at_row == name.npos || at_column == name.npos) return {};
  return CellName{.table = name.substr(0, at_row),
                  .row = name.substr(at_row + row.size(), at_column - at_row - row.size()),
                  .column = name.substr(at_column + column.size())};
}

using Rows = std::map<std::string, std::string>;  // names by numbers

/// The names of the rows of each table that has some.
std::map<std::string, Rows> row_names(const Manifest& manifest) {
  std::map<std::string, Rows> names;
  std::set<std::string> unnamed;  // tables
  for (const auto& [key, number] : manifest.numbers) {
    if (const auto cell = cell_in(key); cell && cell->column == "1") unnamed.insert(cell->table);
  }
  std::set<std::pair<std::string, std::string>> taken;
  for (const auto& [key, text] : manifest.texts) {
    const auto cell = cell_in(key);
    if (!cell || cell->column != "1") continue;
    if (!taken.emplace(cell->table, text).second) unnamed.insert(cell->table);
    names[cell->table][cell->row] = text;
  }
  std::erase_if(names, [&](const auto& entry) { return unnamed.contains(entry.first); });
  return names;
}

/// Whether a row stands at another place.
bool has_moved(const Rows& rows, const Rows& others) {
  return std::ranges::any_of(rows, [&](const auto& row) {
    return std::ranges::any_of(others, [&](const auto& other) {
      return row.second == other.second && row.first != other.first;
    });
  });
}

/// Cells by the names of their rows, where the table is among these.
template <class T>
std::map<std::string, T> named(const std::map<std::string, T>& cells,
                               const std::map<std::string, Rows>& tables) {
  std::map<std::string, T> result;
  for (const auto& [key, content] : cells) {
    const auto cell = cell_in(key);
    const auto rows = cell ? tables.find(cell->table) : tables.end();
    const bool is_named = rows != tables.end() && rows->second.contains(cell->row);
    result.emplace(is_named ? fmt::format("{}, row «{}», column {}", cell->table,
                                          rows->second.at(cell->row), cell->column)
                            : key,
                   content);
  }
  return result;
}

}  // namespace

Manifest with_row_names(Manifest manifest, const Manifest& other) {
  std::map<std::string, Rows> tables = row_names(manifest);
  const std::map<std::string, Rows> others = row_names(other);
  std::erase_if(tables, [&](const auto& table) {
    const auto there = others.find(table.first);
    return there == others.end() || !has_moved(table.second, there->second);
  });
  manifest.numbers = named(manifest.numbers, tables);
  manifest.texts = named(manifest.texts, tables);
  return manifest;
}

}  // namespace literate
