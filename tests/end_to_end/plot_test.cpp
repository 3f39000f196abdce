// SPDX-License-Identifier: GPL-3.0-or-later
// --plot on every command, in files and in the terminal.
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "program.hpp"

BOOST_AUTO_TEST_SUITE(plot_test)

namespace {

struct Drawing {
  const char* command;
  std::vector<std::string> texts;  // labels with units, and titles of curves
};

const std::vector<Drawing> drawings = {
    {"displacement --shape uniform --peak-pressure 100 --half-width 1",
     {"u_z (mm)", "x (mm)", "closed form"}},
    {"displacement --shape concentrated --line-load 9 --x 0,1 --datum 2",
     {"u_z (mm)", "quadrature at the points"}},
    {"displacement --shape expression:p0*(1-(x/a)^2) --peak-pressure 1 --half-width 1 --component "
     "tangential",
     {"u_x (mm)", "quadrature"}},
    {"contact --radius1 0.01 --load 1e5 --units m-N",
     {"pressure (Pa)", "x (m)", "Hertz", "elements"}},
    {"point-contact --radius1 10 --load 100 --nodes 32",
     {"pressure (MPa)", "x, y (mm)", "Hertz, along x"}},
    {"stress --radius1 10 --load 100",
     {"stress (MPa)", "depth z (mm)", "largest shear", "von Mises"}},
    {"stress --radius1 10 --load 100 --x -0.1:0.1:0.01 --z 0.05", {"x (mm)"}},
    {"block --order 4 --refine 1 --width 2 --height 1 --peak-pressure 9 --half-width 0.1 --units "
     "in-lbf",
     {"u_z (in)", "x (in)"}}};

}  // namespace

BOOST_AUTO_TEST_CASE(the_terminal_shows_curves_labels_and_units_below_the_table) {
  for (const auto& [command, texts] : drawings) {
    const std::string output = output_of(words_of(command) + words_of("--plot -"));
    BOOST_TEST_CONTEXT(command) {
      for (const std::string& text : texts) {
        BOOST_TEST(output.find(text) != std::string::npos, text << " is not in " << output);
      }
      BOOST_TEST(output.ends_with("\n"));
      BOOST_TEST(output.find('\f') == std::string::npos);
    }
  }
}

BOOST_AUTO_TEST_CASE(every_command_draws_every_kind_of_file_and_prints_the_same_table) {
  const TemporaryFolder folder;
  for (const auto& [command, texts] : drawings) {
    for (const auto& [ending, beginning] : std::map<std::string, std::string>{
             {".svg", "<?xml"}, {".png", "\x89PNG"}, {".pdf", "%PDF"}}) {
      const std::string file = (folder.path() / ("it's a picture" + ending)).string();
      output_of(words_of(command) + Words{"--plot", file});
      BOOST_TEST(sys::read_file(file).starts_with(beginning), command << ending);
      if (ending != ".svg") continue;
      for (const std::string& text : texts) {
        BOOST_TEST(sys::read_file(file).find(text) != std::string::npos, command << ": " << text);
      }
    }
  }
  // No incomplete file remains.
  BOOST_TEST(std::distance(std::filesystem::recursive_directory_iterator(folder.path()), {}) == 3);
}

BOOST_AUTO_TEST_CASE(without_gnuplot_the_result_is_printed_and_the_plot_is_an_error) {
  const Outcome outcome = run_program(words_of("contact --radius1 10 --load 100 --plot -"),
                                      {.environment = {{"PATH", "/nowhere"}}});

  BOOST_TEST(outcome.status == 3);
  BOOST_TEST(outcome.errors.find("gnuplot") != std::string::npos);
  BOOST_TEST(outcome.output.find("half-width") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
