// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/printed_data.hpp"

#include "config/table.hpp"
#include "parameters/papers_case.hpp"

BOOST_AUTO_TEST_SUITE(printed_data_test)

namespace {

// A case is rejected in one line with this ending.
void check_refused(const std::string& text, const std::string& end) {
  const parameters::Case c = case_of(text);
  BOOST_CHECK_EXCEPTION(paper::read_printed(c), config::Error, [&](const config::Error& e) {
    BOOST_TEST_MESSAGE(e.what());
    return std::string(e.what()).ends_with(end);
  });
}

std::string difference(const std::string& before, const std::string& after) {
  const parameters::Case c = case_of(with(papers_text(), before, after));
  return paper::difference_from_paper(c, paper::read_printed(c).value());
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_papers_numbers_are_read_digit_by_digit) {
  const paper::PrintedData printed = paper::read_printed(case_of(papers_text())).value();

  BOOST_TEST(printed.figure5.fea_z.size() == 11U);
  BOOST_TEST(printed.tri_dist.displacement[2].text() == "1.3558976e-006");
  BOOST_TEST(printed.appendix2.convergence.at("measure9").text() == "0.1");
  BOOST_TEST(printed.contact_m.zero_node.value() == 9);
}

BOOST_AUTO_TEST_CASE(a_case_without_print_has_none) {
  const std::string text = papers_text();
  BOOST_TEST(!paper::read_printed(case_of(text.substr(0, text.find("\n[printed]")))).has_value());
}

BOOST_AUTO_TEST_CASE(missing_and_unknown_numbers_are_rejected_at_their_keys) {
  const std::string text = papers_text();
  check_refused(with(text, "\"1.6236048e-006\", ", ""),
                "printed.tri_dist.displacement: 10 numbers: must be 11, one per point");
  check_refused(with(text, "strain_energy = \"1.212280e-05\"\n", ""),
                "printed.appendix2.measures.strain_energy: missing");
  check_refused(with(text, "zero_node = \"9\"", "zero_node = \"9\"\nlast = \"1\""),
                "printed.contact_m.last: unknown key");
}

BOOST_AUTO_TEST_CASE(the_papers_own_case_does_not_differ) {
  const parameters::Case c = case_of(papers_text());
  BOOST_TEST(paper::difference_from_paper(c, paper::read_printed(c).value()) == "");
}

BOOST_AUTO_TEST_CASE(any_changed_number_is_the_first_difference) {
  const std::string other[][3] = {
      {"peak_pressure = {value = 1000,", "peak_pressure = {value = 900,",
       "half_space.load.peak_pressure, 900 psi, is not the paper's 1000"},
      {"value = 0.010, unit", "value = 0.012, unit",
       "half_space.load.half_width, 0.012 in, is not the paper's 0.010"},
      {"poisson = 0.30", "poisson = 0.28",
       "half_space.material.poisson, 0.28, is not the paper's 0.30"},
      {"count = 11", "count = 9", "half_space.points are not those of the paper's Fig. 5"},
      {"datum = {value = 10,", "datum = {value = 3,",
       "half_space.datum, 3 in, is not the paper's 10"},
      {"height = {value = 1,", "height = {value = 1.5,",
       "block.height is not that of the paper's run"},
      {"sides = \"clamped\"", "sides = \"free\"", "block.sides are not clamped"},
      {"radius = {value = 3,", "radius = {value = 4,",
       "contact.body2.radius, 4 in, is not the paper's 3"},
      {"radius = {value = 3, unit = \"in\"}", "radius = \"plane\"",
       "contact.body2.radius, inf in, is not the paper's 3"},
      {"load = {value = 2500,", "load = {value = 2000,",
       "contact.load, 2000 lbf/in, is not the paper's 2500"},
      {"units = \"in-lbf\"", "units = \"mm-N\"", "the paper's units are in-lbf, not mm-N"}};
  for (const auto& [before, after, expected] : other) {
    BOOST_TEST(difference(before, after) == expected);
  }
}

BOOST_AUTO_TEST_SUITE_END()
