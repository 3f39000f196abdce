// SPDX-License-Identifier: GPL-3.0-or-later
// What must not pile up in the tree.
#include <boost/test/unit_test.hpp>
#include <string>

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
        BOOST_TEST(line.find(word) == std::string::npos, file.string() << " holds: " << line);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
