// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/figure_widths.hpp"

#include <boost/test/unit_test.hpp>

#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(figure_widths_test)

namespace {

std::vector<std::string> errors_of(const std::string& latex) {
  const TemporaryFolder folder;
  sys::write_file_atomically(folder / "paper/a.tex", latex);
  return literate::figure_width_errors(folder / "paper");
}

}  // namespace

BOOST_AUTO_TEST_CASE(lengths_of_latex_and_numbers_with_a_unit_are_widths) {
  for (const std::string width :
       {"\\columnwidth", "0.8\\textwidth", "\\columnwidth - 1em", "8cm", " 72.27 pt", ".5in"}) {
    BOOST_TEST_CONTEXT(width) {
      BOOST_TEST(errors_of("\\fig[width=" + width + "]{f}").empty());
    }
  }
  BOOST_TEST(errors_of("\\fig{f}").empty());
}

BOOST_AUTO_TEST_CASE(what_is_no_width_is_told_with_its_place) {
  for (const std::string width : {"wide", "8", "-3cm", "", "8 furlongs"}) {
    BOOST_TEST_CONTEXT(width) {
      const auto errors = errors_of("One.\nTwo \\fig[width=" + width + "]{f}");
      BOOST_REQUIRE(errors.size() == 1U);
      BOOST_TEST(errors.front().starts_with("paper/a.tex:2:5: figure 'f': width=" + width +
                                            " is no width"));
    }
  }
}

BOOST_AUTO_TEST_CASE(another_option_is_told_with_its_place) {
  const auto errors = errors_of("\\fig[heigth=3cm]{f}");
  BOOST_REQUIRE(errors.size() == 1U);
  BOOST_TEST(errors.front() ==
             "paper/a.tex:1:1: figure 'f': \\fig takes one option, width=…, and not 'heigth=3cm'");
}

BOOST_AUTO_TEST_SUITE_END()
