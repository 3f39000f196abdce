// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "config/table.hpp"
#include "literate/program/commands.hpp"
#include "system/csv.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

struct CasesOptions {
  std::vector<std::string> folders;
  std::string keys, output;
};

/// What one case came to: its exit code, its names.json where the computation got so far, and what
/// its file says.
struct Case {
  std::string name;
  std::string exit_code;
  json names;
  std::map<std::string, std::string> parameters;
};

Case read_case(const fs::path& folder) {
  Case result{.name = folder.filename().string(),
              .exit_code = std::string(sys::lines_of(sys::read_file(folder / "exit_code")).front()),
              .names = json::object(),
              .parameters = {}};
  // A case that could not be computed may have left the names of a run before.
  if (fs::exists(folder / "computed")) {
    result.names = json::parse(sys::read_file(folder / "generated/names.json"));
  }
  if (fs::exists(folder / "case.toml")) {
    try {
      result.parameters = config::entries_of(folder / "case.toml");
    } catch (const sys::InputError&) {
      // A program may read a case of another form, or refuse this one: its exit code tells.
    }
  }
  return result;
}

/// The parameters that are not the same in all cases.
std::vector<std::string> varied_parameters(const std::vector<Case>& cases) {
  std::set<std::string> all;
  for (const Case& one : cases) {
    for (const auto& [key, text] : one.parameters) all.insert(key);
  }
  std::erase_if(all, [&](const std::string& key) {
    return std::ranges::all_of(cases, [&](const Case& one) {
      const auto entry = one.parameters.find(key);
      return entry != one.parameters.end() && entry->second == cases.front().parameters.at(key);
    });
  });
  return {all.begin(), all.end()};
}

/// The keys asked for, or those of all values that have a number in any case.
std::vector<std::string> keys_for(const CasesOptions& options, const std::vector<Case>& cases) {
  std::vector<std::string> keys;
  std::istringstream asked(options.keys);
  for (std::string key; asked >> key;) keys.push_back(key);
  if (!keys.empty()) return keys;
  std::set<std::string> all;
  for (const Case& one : cases) {
    const json values = one.names.value("values", json::object());
    for (const auto& [key, value] : values.items()) {
      if (value.contains("number")) all.insert(key);
    }
  }
  return {all.begin(), all.end()};
}

/// What a case says of an entry of one part of names.json; empty if it says nothing.
std::string entry_of(const Case& one, const char* part, const std::string& key,
                     const char* property) {
  const json entries = one.names.value(part, json::object());
  if (!entries.contains(key) || !entries.at(key).contains(property)) return "";
  const json& entry = entries.at(key).at(property);
  return entry.is_string() ? entry.get<std::string>() : entry.dump();
}

command_line::ExitCode run(const CasesOptions& options) {
  std::vector<Case> cases;
  for (const std::string& folder : options.folders) cases.push_back(read_case(folder));

  std::vector<std::vector<std::string>> rows(cases.size() + 1);
  const auto add_column = [&](const std::string& heading, auto&& cell_of) {
    rows.front().push_back(heading);
    for (std::size_t i = 0; i < cases.size(); ++i) rows[i + 1].push_back(cell_of(cases[i]));
  };
  const auto is_empty = [](const std::vector<std::string>& row) { return row.back().empty(); };
  const auto remove_empty = [&] {
    if (!std::all_of(rows.begin() + 1, rows.end(), is_empty)) return;
    for (auto& row : rows) row.pop_back();
  };
  add_column("case", [](const Case& one) { return one.name; });
  add_column("exit code", [](const Case& one) { return one.exit_code; });
  for (const std::string& key : varied_parameters(cases)) {
    add_column("parameter " + key, [&](const Case& one) {
      const auto entry = one.parameters.find(key);
      return entry == one.parameters.end() ? "" : entry->second;
    });
  }
  for (const std::string& key : keys_for(options, cases)) {
    add_column(key, [&](const Case& one) { return entry_of(one, "values", key, "printed"); });
    if (std::all_of(rows.begin() + 1, rows.end(), is_empty)) {
      throw sys::InputError(fmt::format("--keys: no case has a value '{}'", key));
    }
    add_column(key + ", unrounded",
               [&](const Case& one) { return entry_of(one, "values", key, "number"); });
    remove_empty();  // a text has no number
    for (const char* part : {"abs_error", "below", "above", "standard"}) {
      add_column(fmt::format("{}, {}", key, part),
                 [&](const Case& one) { return entry_of(one, "values", key, part); });
      remove_empty();
    }
  }
  std::set<std::string> claims;
  for (const Case& one : cases) {
    const json of_case = one.names.value("claims", json::object());
    for (const auto& claim : of_case.items()) claims.insert(claim.key());
  }
  for (const std::string& id : claims) {
    add_column("claim " + id,
               [&](const Case& one) { return entry_of(one, "claims", id, "found"); });
  }
  std::string table;
  for (const std::vector<std::string>& row : rows) table += sys::csv_line(row);
  sys::write_file_atomically(options.output, table);
  return command_line::ExitCode::success;
}

}  // namespace

void add_cases_command(CLI::App& program, sys::ExitCode& exit_code) {
  using namespace command_line;
  add_command(program, "cases",
              "Set the papers of several cases side by side: values, verdicts, exit codes",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<CasesOptions>();
                add_texts(command, "folders", options->folders, "DIR…",
                          "Folders that `make reports` made, one a case");
                add_text(command, "--keys", options->keys, "KEYS",
                         "Values to compare, with blanks between; else all that have a number");
                add_required_text(command, "--output", options->output, "FILE", "The table, CSV");
                return [options] { return run(*options); };
              });
}

}  // namespace literate
