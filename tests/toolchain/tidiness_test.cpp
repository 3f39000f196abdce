// SPDX-License-Identifier: GPL-3.0-or-later
// What must not pile up in the tree, and what its documents name.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <regex>
#include <string>

#include "holds.hpp"
#include "toolchain/source_tree.hpp"

BOOST_AUTO_TEST_SUITE(tidiness_test)

namespace {

// Split, so that this file does not hold them.
const std::string leftovers[] = {
    "TO"
    "DO",
    "FIX"
    "ME"};

std::vector<std::filesystem::path> own_files() {
  std::vector<std::filesystem::path> files;
  for (const auto* folder : {"src", "figures", "tests", "report"}) {
    for (auto& file : source_tree::files_below(folder)) files.push_back(std::move(file));
  }
  return files;
}

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_is_left_for_later) {
  for (const auto& file : own_files()) {
    for (const auto& line : source_tree::lines_of(file)) {
      for (const auto& word : leftovers) {
        BOOST_TEST(lacks(line, word), file.string() << " holds: " << line);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(every_file_that_readme_and_design_name_is_there) {
  // A link, or a path between backquotes; x.cpp and name.gp stand for any.
  static const std::regex named(R"(\]\(([^)#:]+)\)|`((?:src|report|figures|tests)/[\w./-]+)`)");
  static const std::regex any(R"((x\.|x[_-]|name\.).*)");
  int n_named = 0;
  for (const std::filesystem::path file : {"README.md", "src/DESIGN.md"}) {
    for (const auto& line : source_tree::lines_of(file)) {
      for (std::sregex_iterator at(line.begin(), line.end(), named), end; at != end; ++at) {
        const auto folder = (*at)[1].matched ? file.parent_path() : std::filesystem::path();
        const auto path = source_tree::root / folder / (at->str(1) + at->str(2));
        if (std::regex_match(path.filename().string(), any)) continue;
        ++n_named;
        BOOST_TEST(std::filesystem::exists(path), file.string() << " names " << at->str());
      }
    }
  }
  BOOST_TEST(n_named > 100);
}

BOOST_AUTO_TEST_SUITE_END()
