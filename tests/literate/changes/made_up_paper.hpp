// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "literate/provenance/manifest.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

namespace literate {

// A paper in a repository of its own, whose first commit has no words yet.
class MadeUpPaper {
 public:
  MadeUpPaper() {
    git({"init", "-q", "-b", "main"});
    write("a.tex", "\\documentclass{article}\n");
    commit();
  }

  void write(const std::string& file, const std::string& text) const {
    sys::write_file_atomically(folder() / file, text);
  }
  void record(const Manifest& now) const { write("results.json", manifest_json(now)); }

  // Each commit is a minute later than the one before.
  void commit() {
    minutes_ += 1;
    git({"add", "-A"});
    git({"commit", "--allow-empty", "-qm", "more"});
  }
  void commit(const Manifest& now) {
    record(now);
    commit();
  }
  std::string git(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"-c", "user.name=t", "-c", "user.email=t@example.org",
                                         "-c", "commit.gpgsign=false"});
    const std::string date = "2026-11-01T10:" + std::to_string(10 + minutes_) + ":00Z";
    const auto said =
        sys::run({.program = "git",
                  .arguments = arguments,
                  .working_directory = scratch_.path(),
                  .environment = {{"GIT_AUTHOR_DATE", date}, {"GIT_COMMITTER_DATE", date}}});
    BOOST_TEST_REQUIRE(said.exit_status == 0, said.output);
    return said.output;
  }
  void wait() { minutes_ += 1; }

  std::string head() const { return git({"rev-parse", "HEAD"}).substr(0, 12); }
  std::filesystem::path folder() const { return scratch_.path(); }

 private:
  TemporaryFolder scratch_;
  int minutes_ = 0;
};

}  // namespace literate
