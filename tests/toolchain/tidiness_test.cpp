// SPDX-License-Identifier: GPL-3.0-or-later
// What must not pile up in the tree.
#include <boost/test/unit_test.hpp>
#include <string>

#include "toolchain/source_tree.hpp"

namespace {

// Beyond this a file has more than one subject (the 95th percentile of the libraries we learnt
// from).
constexpr std::size_t most_lines = 400;

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

BOOST_AUTO_TEST_CASE(no_source_file_is_longer_than_one_subject) {
  for (const auto& file : own_files()) {
    if (!source_tree::is_cpp(file)) continue;
    const auto n_lines = source_tree::lines_of(file).size();

    BOOST_TEST(n_lines <= most_lines, file.string() << " has " << n_lines << " lines");
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_left_for_later) {
  for (const auto& file : own_files()) {
    for (const auto& line : source_tree::lines_of(file)) {
      for (const auto& word : leftovers) {
        BOOST_TEST(line.find(word) == std::string::npos, file.string() << " holds: " << line);
      }
    }
  }
}
