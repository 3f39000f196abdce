// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/settings.hpp"

#include <fmt/core.h>

#include <map>

#include "system/error.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace {

std::map<std::string, std::string> read_lines(const std::filesystem::path& file) {
  const std::string text = sys::read_file(file);
  std::map<std::string, std::string> values;
  int line_number = 0;
  for (const std::string_view line : sys::lines_of(text)) {
    ++line_number;
    const auto equals = line.find('=');
    if (equals == line.npos) {
      throw sys::InputError(
          fmt::format("{}:{}: '{}' is no setting name=value", file.string(), line_number, line));
    }
    values[std::string(line.substr(0, equals))] = line.substr(equals + 1);
  }
  return values;
}

}  // namespace

Settings read_settings(const std::filesystem::path& file) {
  std::map<std::string, std::string> values = read_lines(file);
  for (const char* const name : {"name", "root", "document", "main", "figures", "output"}) {
    if (values[name].empty()) {
      throw sys::InputError(fmt::format("{}: the setting '{}' is missing", file.string(), name));
    }
  }
  Settings settings{.name = values["name"],
                    .root = values["root"],
                    .document = values["document"],
                    .main_file = values["main"],
                    .case_file = values["case"],
                    .figures = values["figures"],
                    .output = values["output"],
                    .repository = values["repository"],
                    .engine = values["engine"]};
  for (const std::string& path : sys::split(values["reads"], ':')) {
    settings.reads.emplace_back(path);
  }
  for (const std::string& path : sys::split(values["records"], ':')) {
    settings.records.emplace_back(path);
  }
  settings.tools = sys::split(values["tools"], ':');
  if (!values["latex"].empty()) settings.latex = values["latex"];
  if (settings.latex != "pdflatex" && settings.latex != "lualatex") {
    throw sys::InputError(fmt::format("{}: the setting 'latex' is '{}', not pdflatex or lualatex",
                                      file.string(), settings.latex));
  }
  return settings;
}

}  // namespace literate
