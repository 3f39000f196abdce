// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/changes/history.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

#include "system/decimal.hpp"
#include "system/error.hpp"
#include "system/process.hpp"
#include "system/text.hpp"

namespace literate {

std::optional<std::string> git(const std::filesystem::path& folder,
                               std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"-c", "safe.directory=*"});
  const sys::ProcessResult result =
      sys::run({.program = "git", .arguments = arguments, .working_directory = folder});
  if (result.exit_status != 0) return std::nullopt;
  return result.output;
}

std::vector<Commit> commits_of_lines(const std::string& blame) {
  std::map<std::string, Commit> commits;
  std::vector<std::string> ids;
  std::istringstream lines(blame);
  std::string line, id;
  const auto time = [&] { return sys::parsed<std::int64_t>(line.substr(line.find(' ') + 1)); };
  while (std::getline(lines, line)) {
    if (line.starts_with('\t')) {
      ids.push_back(std::exchange(id, ""));
    } else if (id.empty()) {
      id = line.substr(0, line.find(' '));
      commits[id].id = id;
    } else if (line.starts_with("author-time ")) {
      commits[id].authored = time().value_or(0);
    } else if (line.starts_with("committer-time ")) {
      commits[id].committed = time().value_or(0);
    } else if (line == "boundary") {
      commits[id].is_first = true;
    }
  }
  std::vector<Commit> of_lines;
  for (const std::string& of_line : ids) of_lines.push_back(commits[of_line]);
  return of_lines;
}

std::optional<std::string> case_at(const std::string& commit, const std::filesystem::path& document,
                                   const std::filesystem::path& case_file) {
  const std::string path = std::filesystem::relative(case_file, document).generic_string();
  return git(document, {"show", commit + ":./" + path});
}

std::vector<RecordedResults> records_in(const std::filesystem::path& document,
                                        const std::string& project) {
  const std::string commits = git(document, {"log", "--diff-filter=AM", "--topo-order", "--reverse",
                                             "--format=%H", "--", "results.json"})
                                  .value_or("");
  std::vector<RecordedResults> records;
  std::vector<std::string> show{"show"};
  for (const std::string_view line : sys::lines_of(commits)) {
    if (line.empty()) continue;
    records.push_back({.commit = std::string(line), .results = {}});
    show.push_back(records.back().commit + ":./results.json");
  }
  if (records.empty()) return {};
  const auto texts = git(document, show);
  if (!texts) return {};
  std::istringstream stream(*texts);
  try {
    for (RecordedResults& record : records) {
      nlohmann::json text;
      stream >> text;
      record.results = manifest_of(text.dump(), record.commit + ":results.json", project);
    }
  } catch (const nlohmann::json::exception&) {
    return {};
  } catch (const sys::OutputError&) {
    return {};
  }
  return records;
}

}  // namespace literate
