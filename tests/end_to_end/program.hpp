// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the built program as a shell would, and reads its output.
#pragma once

#include <sys/wait.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "csv_rows.hpp"
#include "system/files.hpp"
#include "system/text.hpp"
#include "temporary_folder.hpp"

using nlohmann::json;

inline const std::filesystem::path source_dir = HALFSPACE_SOURCE_DIR;
inline const std::filesystem::path papers_case = source_dir / "report/ruggiero2001.toml";

using Words = std::vector<std::string>;

/// The words of a command line without quotes.
inline Words words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

inline Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

struct ShellResult {
  int exit_status = 0;
  std::string output;  ///< standard output and standard error
};

/// Runs a shell script with the arguments $1, $2, … and no input. The variables are added to this
/// program's environment.
inline ShellResult run_shell(const std::string& script, const std::vector<std::string>& arguments,
                             const std::filesystem::path& folder = ".",
                             const std::map<std::string, std::string>& variables = {}) {
  const auto quoted = [](const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
    return result + "'";
  };
  std::string command = "cd " + quoted(folder.string()) + " && exec </dev/null 2>&1 env";
  for (const auto& [name, value] : variables) command += " " + quoted(name + "=" + value);
  command += " /bin/sh -c " + quoted(script) + " sh";
  for (const std::string& argument : arguments) command += " " + quoted(argument);

  std::FILE* const pipe = ::popen(command.c_str(), "r");
  ShellResult result;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
    result.output += static_cast<char>(c);
  }
  const int status = ::pclose(pipe);
  result.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

/// The environment of a run of the program.
struct Surroundings {
  std::map<std::string, std::string> environment = {};
  std::filesystem::path folder = ".";
};

struct Outcome {
  int status = 0;
  std::string output;
  std::string errors;
};

inline Outcome run_program(const Words& words, const Surroundings& surroundings = {}) {
  const TemporaryFolder scratch;
  const std::string output = (scratch.path() / "output").string();
  const std::string errors = (scratch.path() / "errors").string();
  const Words arguments = {output, errors, HALFSPACE_PROGRAM};
  const auto result = run_shell(R"(o=$1 e=$2; shift 2; exec "$@" >"$o" 2>"$e")", arguments + words,
                                surroundings.folder, surroundings.environment);
  return {result.exit_status, sys::read_file(output), sys::read_file(errors)};
}

/// The output of a run that must succeed with nothing on standard error.
inline std::string output_of(const Words& words, const Surroundings& surroundings = {}) {
  const Outcome outcome = run_program(words, surroundings);
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(outcome.errors == "");
  return outcome.output;
}

inline json json_of(const Words& command) {
  return json::parse(output_of(command + Words{"--format", "json"}));
}

/// The columns of a CSV by heading, as texts.
using Columns = std::map<std::string, std::vector<std::string>>;

inline Columns csv_of(const Words& command) {
  const auto rows = csv_rows_of(output_of(command + Words{"--format", "csv"}));
  BOOST_TEST_REQUIRE(!rows.empty());
  const Words& names = rows.front();
  Columns columns;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    BOOST_TEST_REQUIRE(rows[row].size() == names.size());
    for (std::size_t i = 0; i < names.size(); ++i) columns[names[i]].push_back(rows[row][i]);
  }
  return columns;
}

inline double number(const std::string& cell) {
  return std::stod(cell);
}

inline double relative_difference(double a, double b) {
  return std::abs(a / b - 1);
}

/// The run exits with 2, prints nothing on standard output and one line of errors with all `parts`.
inline void check_refused(const Words& words, const Words& parts) {
  const Outcome outcome = run_program(words);
  BOOST_TEST_CONTEXT(outcome.errors) {
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(outcome.output == "");
    BOOST_TEST(outcome.errors.starts_with("halfspace: "));
    BOOST_TEST(sys::lines_of(outcome.errors).size() == 1U);
    for (const std::string& part : parts) {
      BOOST_TEST(outcome.errors.find(part) != std::string::npos, part << " is not in it");
    }
  }
}

/// A text with the first occurrence of a part replaced.
inline std::string with(std::string text, const std::string& before, const std::string& after) {
  const auto at = text.find(before);
  BOOST_TEST_REQUIRE((at != std::string::npos), before << " is not in the text");
  return text.replace(at, before.size(), after);
}
