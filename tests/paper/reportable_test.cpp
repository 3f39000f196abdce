// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands can compute and the report cannot say is refused at its key.
#include <boost/test/unit_test.hpp>
#include <string>

#include "config/table.hpp"
#include "paper/paper.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(reportable_test)

namespace {

const std::string source_dir = HALFSPACE_SOURCE_DIR;
const std::string papers_text = sys::read_file(source_dir + "/report/ruggiero2001.toml");

// The complaint about a case under this name; empty if there is none.
std::string complaint(const std::string& text, const std::string& name = "case.toml") {
  const TemporaryFolder folder;
  const parameters::Case c = parameters::read_case(folder.write(name, text));
  try {
    paper::require_reportable(c);
    return "";
  } catch (const config::Error& e) {
    return e.what();
  }
}

std::string with(std::string text, const std::string& before, const std::string& after) {
  const auto at = text.find(before);
  BOOST_TEST_REQUIRE((at != std::string::npos), before);
  return text.replace(at, before.size(), after);
}

std::string titled(const std::string& title) {
  return with(papers_text, "title = \"Ruggiero (2001)\"", "title = \"" + title + "\"");
}

// The paper's case with one change is refused, in one line that ends so.
void check_refused(const std::string& before, const std::string& after, const std::string& end) {
  const std::string found = complaint(with(papers_text, before, after));
  BOOST_TEST(found.ends_with(end), found);
  BOOST_TEST(found.find(".toml:") != std::string::npos, found);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_papers_case_is_reportable) {
  BOOST_TEST(complaint(papers_text) == "");
  BOOST_TEST(complaint(sys::read_file(source_dir + "/tests/end_to_end/steel_mm.toml")) == "");
}

BOOST_AUTO_TEST_CASE(a_title_that_latex_cannot_set_is_refused_at_its_key) {
  const std::string place = ":5:9: title: ";

  BOOST_TEST(complaint(titled("Žluťoučký")).find(place + "holds 'ť', which LaTeX") !=
             std::string::npos);
  BOOST_TEST(complaint(titled("Wheel 😀")).find(place + "holds '😀'") != std::string::npos);
  BOOST_TEST(complaint(titled("a\\nb")).find(place + "holds '\\n'") != std::string::npos);
  BOOST_TEST(complaint(titled(std::string(400, 'a'))).find(place + "400 characters: must be at") !=
             std::string::npos);
  BOOST_TEST(complaint(titled(std::string(41, 'a'))).find(place + "a word of 41 characters") !=
             std::string::npos);
  BOOST_TEST(complaint(titled("Größe ≤ 5 µm, 50% #1 & ~x^2 $y$ {z}")) == "");
}

BOOST_AUTO_TEST_CASE(a_file_name_that_latex_cannot_print_is_refused) {
  const auto found = [](const std::string& name) { return complaint(papers_text, name); };

  BOOST_TEST(found("rad 😀.toml").find("LaTeX cannot print the '😀' in it") != std::string::npos);
  BOOST_TEST(found("a\nb.toml").find("a\\nb.toml: the report prints the name") !=
             std::string::npos);
  const std::string stem(60, 'n');
  BOOST_TEST(found(stem + ".toml").find("which has 65 characters: must be at") !=
             std::string::npos);
  BOOST_TEST(found("my_case % #1 $x$.toml") == "");
}

BOOST_AUTO_TEST_CASE(grids_and_blocks_that_the_report_cannot_judge_are_refused) {
  check_refused("nodes = 91", "nodes = 6",
                "contact.nodes: 6: must be from 7 to 401 for the report");
  check_refused("nodes = 91", "nodes = 402",
                "contact.nodes: 402: must be from 7 to 401 for the report");
  check_refused("order = 7", "order = 5", "block.order: 5: must be from 6 to 10 for the report");
  check_refused("refine = 1", "refine = 4", "block.refine: 4: must be from 0 to 3 for the report");
  check_refused("poisson = 0.30", "poisson = 0.49999",
                "half_space.material.poisson: 0.49999: must be at most 0.4999 in a case with a "
                "[block]");
}

BOOST_AUTO_TEST_CASE(what_depends_on_the_loads_half_width_names_it) {
  const std::string of_load = " half_space.load.half_width, for the report";

  check_refused("datum = {value = 10,", "datum = {value = 0.009,",
                "half_space.datum: 0.009 in: must be at least half_space.load.half_width, 0.01 in, "
                "for the report");
  check_refused("height = {value = 1,", "height = {value = 0.03,",
                "block.height: 0.03 in: must be at least 0.04 in, 4 times" + of_load);
  check_refused("half_width = {value = 0.010", "half_width = {value = 0.3",
                "block.width: 2 in: must be at least 2.4 in, 8 times" + of_load);
}

BOOST_AUTO_TEST_SUITE_END()
