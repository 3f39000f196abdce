// SPDX-License-Identifier: GPL-3.0-or-later
// One section, one name: its prose report/sections/x-y.tex, its file src/paper/x_y_section.cpp and
// its line in the table of sections.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "paper/paper.hpp"
#include "system/files.hpp"

BOOST_AUTO_TEST_SUITE(sections_test)

namespace {

const std::string source_dir = HALFSPACE_SOURCE_DIR;

// Prose that computes nothing of its own, and why it does not.
const std::map<std::string, std::string> prose_only = {
    {"abstract", "repeats what the sections find"},
    {"introduction", "says what the sections are about"},
    {"findings", "repeats what the claims found"},
    {"nomenclature", "explains the letters"},
    {"discussion", "weighs what the sections found"},
    {"references", "lists sources"},
    {"transcription", "says how the copy of the paper was restored"},
    {"ledger", "is made of all sections' claims by the engine"}};

// The files of a folder with this ending, without it and with _ for -.
std::set<std::string> names_in(const std::string& folder, const std::string& ending) {
  std::set<std::string> names;
  for (std::string file : sys::files_below(source_dir + "/" + folder)) {
    if (!file.ends_with(ending)) continue;
    file.erase(file.size() - ending.size());
    std::ranges::replace(file, '-', '_');
    names.insert(file);
  }
  return names;
}

std::set<std::string> names_in_table() {
  std::set<std::string> names;
  for (const paper::Section& section : paper::sections()) names.insert(section.name);
  return names;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_file_of_a_section_is_in_the_table_and_the_table_has_no_others) {
  BOOST_TEST(names_in("src/paper", "_section.cpp") == names_in_table(),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(every_section_has_its_prose_and_all_other_prose_a_reason) {
  std::set<std::string> expected = names_in_table();
  for (const auto& [name, reason] : prose_only) {
    BOOST_TEST(expected.insert(name).second,
               name << " computes something: it no longer " << reason);
  }

  BOOST_TEST(names_in("report/sections", ".tex") == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(each_numbered_equation_of_the_paper_is_found_by_one_grep) {
  std::string sources;
  for (const std::string& file : sys::files_below(source_dir + "/src")) {
    if (file.ends_with(".hpp")) sources += sys::read_file(source_dir + "/src/" + file);
  }
  for (const std::string number : {"1a", "1b", "2", "3", "4"}) {
    const std::string sentence = "This is eq. (" + number + ") of the paper";
    const std::size_t at = sources.find(sentence);
    BOOST_TEST(at != std::string::npos, sentence);
    BOOST_TEST(sources.find(sentence, at + 1) == std::string::npos, sentence << ", again");
  }
}

BOOST_AUTO_TEST_CASE(sections_are_computed_in_the_order_in_which_the_report_has_them) {
  const std::string report = sys::read_file(source_dir + "/report/report.tex");
  std::size_t last = 0;
  for (const paper::Section& section : paper::sections()) {
    std::string name = section.name;
    std::ranges::replace(name, '_', '-');
    const std::size_t at = report.find("\\input{sections/" + name + "}");
    BOOST_TEST((at != std::string::npos && at > last), name);
    last = at;
  }
}

BOOST_AUTO_TEST_SUITE_END()
