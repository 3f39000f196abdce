// SPDX-License-Identifier: GPL-3.0-or-later
// --plot on every command that has something to draw.
#include <boost/test/unit_test.hpp>
#include <string>

#include "program.hpp"

BOOST_AUTO_TEST_SUITE(plot_test)

namespace {

const Words from_case = {"--case", papers_case.string()};
const std::vector<Words> commands = {
    Words{"displacement"} + from_case,
    Words{"displacement"} + from_case + Words{"--shape", "expression:p0*(1-(x/a)^2)"},
    Words{"contact"} + from_case,
    Words{"contact"} + from_case + Words{"--friction", "0.3", "--tangential-load", "200"},
    Words{"contact"} + from_case + Words{"--profile", "wedge", "--slope", "0.01"},
    Words{"point-contact"} + from_case + Words{"--load", "1", "--nodes", "32"},
    Words{"point-contact"} + from_case +
        Words{"--load", "1", "--nodes", "32", "--profile", "cone", "--slope", "0.01"},
    Words{"point-contact"} + from_case +
        Words{"--load", "1", "--nodes", "32", "--profile", "rounded-punch", "--flat", "0.01",
              "--edge-radius", "1", "--domain", "0.06"},
    Words{"stress"} + from_case + Words{"--x", "0,0.01", "--z", "0.002,0.01,0.02"},
    Words{"stress"} + from_case + Words{"--x", "0", "--z", "0.002,0.01", "--friction", "0.1"},
    Words{"block"} + from_case + Words{"--order", "2", "--refine", "0"}};

}  // namespace

BOOST_AUTO_TEST_CASE(every_command_draws_to_every_kind_of_file_and_prints_what_it_would_without) {
  const TemporaryFolder folder;
  struct Kind {
    const char* ending;
    const char* beginning;
  };
  for (const Words& command : commands) {
    for (const Kind& kind : {Kind{".svg", "<?xml"}, {".png", "\x89PNG"}, {".pdf", "%PDF"}}) {
      const std::string file = (folder.path() / (std::string("picture") + kind.ending)).string();
      const Words csv = {"--format", "csv"};
      BOOST_TEST_CONTEXT(command[0] << kind.ending) {
        BOOST_TEST(output_of(command + csv + Words{"--plot", file}) == output_of(command + csv));
        BOOST_TEST(sys::read_file(file).starts_with(kind.beginning));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_same_command_draws_the_same_bytes) {
  const TemporaryFolder folder;
  for (const char* ending : {".svg", ".png", ".pdf"}) {
    const std::string first = (folder.path() / (std::string("first") + ending)).string();
    const std::string second = (folder.path() / (std::string("second") + ending)).string();
    output_of(commands[5] + Words{"--plot", first});
    output_of(commands[5] + Words{"--plot", second},
              {.environment = {{"TZ", "Asia/Tokyo"}, {"LC_ALL", "C"}}});
    BOOST_TEST((sys::read_file(first) == sys::read_file(second)), ending);
  }
}

BOOST_AUTO_TEST_CASE(a_terminal_gets_the_picture_below_the_table) {
  for (const Words& command : commands) {
    const std::string text = output_of(command + Words{"--plot", "-"});
    const auto lines = sys::lines_of(text);
    BOOST_TEST_REQUIRE(lines.size() > 24U);
    // an axis of 79 characters at most, with its corner
    BOOST_TEST(text.find("+---------") != std::string::npos, text);
    for (std::size_t i = lines.size() - 24; i < lines.size(); ++i)
      BOOST_TEST(lines[i].size() <= 79U);
  }
}

BOOST_AUTO_TEST_CASE(stresses_at_one_depth_are_drawn_along_x) {
  const Words stress = Words{"stress"} + from_case;
  const Words terminal = {"--plot", "-"};

  const std::string one = output_of(stress + Words{"--x", "0,0.01", "--z", "0.005"} + terminal);
  const std::string two = output_of(stress + Words{"--x", "0", "--z", "0.002,0.005"} + terminal);

  BOOST_TEST(one.find(" x (in) ") != std::string::npos, one);
  BOOST_TEST(two.find(" z (in) ") != std::string::npos, two);
}

BOOST_AUTO_TEST_CASE(files_that_are_no_picture_are_refused_before_anything_is_computed) {
  for (const Words& command : commands) {
    check_refused(2, command + Words{"--plot", "picture.gif"}, {"--plot picture.gif", ".svg"});
    check_refused(2, command + Words{"--plot", "/none/picture.svg"}, {"--plot", "folder"});
    check_refused(2, command + Words{"--plot", "-", "--format", "json"}, {"--plot -", "table"});
  }
}

BOOST_AUTO_TEST_CASE(without_gnuplot_its_name_is_told) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "picture.svg").string();
  const Outcome outcome = run_program(Words{"contact"} + from_case + Words{"--plot", file},
                                      {.environment = {{"PATH", folder.path().string()}}});

  BOOST_TEST(outcome.status == 3);
  BOOST_TEST(outcome.errors.find("gnuplot") != std::string::npos, outcome.errors);
}

BOOST_AUTO_TEST_SUITE_END()
