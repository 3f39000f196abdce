// SPDX-License-Identifier: GPL-3.0-or-later
// Starts a built program as a shell would, with its output and its errors apart.
#pragma once

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "system/files.hpp"
#include "system/process.hpp"
#include "system/text.hpp"
#include "temporary_folder.hpp"

inline const std::filesystem::path source_dir = HALFSPACE_SOURCE_DIR;
inline const std::filesystem::path papers_case = source_dir / "report/ruggiero2001.toml";
inline const std::filesystem::path steel_case = source_dir / "tests/end_to_end/steel_mm.toml";

using Words = std::vector<std::string>;

/// What surrounds a run of the program.
struct Surroundings {
  std::map<std::string, std::string> environment = {};
  std::string input = {};
  std::filesystem::path folder = ".";
  std::string umask = "022";
};

struct Outcome {
  int status = 0;
  std::string output;
  std::string errors;
};

/// The program that knows the command: one makes the report, the other is the mechanics' own.
inline std::string program_of(const Words& words) {
  static const std::set<std::string> stages = {"compute", "draw",  "typeset", "check",
                                               "page",    "embed", "describe"};
  return !words.empty() && stages.contains(words.front()) ? REPORT_PROGRAM : HALFSPACE_PROGRAM;
}

inline Outcome run_program(const Words& words, const Surroundings& surroundings = {}) {
  const TemporaryFolder scratch;
  const std::string input = scratch.write("input", surroundings.input).string();
  const std::string output = (scratch.path() / "output").string();
  const std::string errors = (scratch.path() / "errors").string();
  Words arguments{"-c",   R"(umask "$1"; i=$2 o=$3 e=$4; shift 4; exec "$@" <"$i" >"$o" 2>"$e")",
                  "sh",   surroundings.umask,
                  input,  output,
                  errors, program_of(words)};
  arguments.insert(arguments.end(), words.begin(), words.end());
  const auto result = sys::run({.program = "sh",
                                .arguments = arguments,
                                .working_directory = surroundings.folder,
                                .environment = surroundings.environment});
  return {result.exit_status, sys::read_file(output), sys::read_file(errors)};
}

/// The output of a run that must succeed without a word on standard error.
inline std::string output_of(const Words& words, const Surroundings& surroundings = {}) {
  const Outcome outcome = run_program(words, surroundings);
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(outcome.errors == "");
  return outcome.output;
}

/// What a stage is told of a report: the settings that the build would write.
struct ReportSettings {
  std::filesystem::path case_file;
  std::filesystem::path output;
  std::filesystem::path document = source_dir / "report";
  std::filesystem::path root = source_dir;

  std::filesystem::path generated() const { return output / "generated"; }
  std::filesystem::path pdf() const { return output / "report.pdf"; }

  /// The words that run the stage. The settings are kept apart from what it makes.
  Words stage(const std::string& name) const {
    static const TemporaryFolder folder;
    static int n_files = 0;
    const auto file =
        folder.write(std::to_string(++n_files) + ".settings",
                     "name=report\nroot=" + root.string() + "\ndocument=" + document.string() +
                         "\nmain=report.tex\ncase=" + case_file.string() + "\nfigures=" +
                         (source_dir / "figures").string() + "\noutput=" + output.string() + "\n");
    return {name, file.string()};
  }
};

/// The run ends with `status`, nothing on standard output, and errors that hold every one of
/// `parts`; of bad input there is exactly one line.
inline void check_refused(int status, const Words& words, const Words& parts,
                          const Surroundings& surroundings = {}) {
  std::string command = program_of(words);
  for (const std::string& word : words) command += " '" + word + "'";
  BOOST_TEST_CONTEXT(command) {
    const Outcome outcome = run_program(words, surroundings);
    BOOST_TEST(outcome.status == status);
    BOOST_TEST(outcome.output == "");
    BOOST_TEST(outcome.errors.starts_with("halfspace: "));
    if (status == 2) BOOST_TEST(sys::lines_of(outcome.errors).size() == 1U);
    for (const std::string& part : parts) {
      BOOST_TEST(outcome.errors.find(part) != std::string::npos,
                 "\"" << part << "\" is not in: " << outcome.errors);
    }
  }
}

/// A text with the first of what stands there replaced.
inline std::string with(std::string text, const std::string& before, const std::string& after) {
  const auto at = text.find(before);
  BOOST_TEST_REQUIRE((at != std::string::npos), before << " is not in the text");
  return text.replace(at, before.size(), after);
}

inline Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}
