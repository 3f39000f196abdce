// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/printed_data.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "config/table.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(printed_data_test)

using paper::PrintedData;
using paper::read_printed;

namespace {

const std::string source_dir = HALFSPACE_SOURCE_DIR;
const std::string papers_text = sys::read_file(source_dir + "/report/ruggiero2001.toml");

std::optional<PrintedData> printed_in(const std::string& case_text) {
  const TemporaryFolder folder;
  return read_printed(parameters::read_case(folder.write("case.toml", case_text)));
}

// The paper's case with one change is refused, in one line that names the key.
void check_refused(const std::string& before, const std::string& after, const std::string& key) {
  std::string text = papers_text;
  const auto at = text.find(before);
  BOOST_TEST_REQUIRE(at != std::string::npos);
  text.replace(at, before.size(), after);
  BOOST_TEST_CONTEXT(after) {
    BOOST_CHECK_EXCEPTION(printed_in(text), config::Error, [&](const config::Error& e) {
      const std::string what = e.what();
      BOOST_TEST_MESSAGE(what);
      return what.find(key) != std::string::npos && what.find('\n') == std::string::npos;
    });
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_papers_numbers_are_read_digit_by_digit) {
  const PrintedData printed = printed_in(papers_text).value();

  BOOST_TEST(printed.figure5.fea_z.size() == 11U);
  BOOST_TEST(printed.tri_dist.displacement[2].text() == "1.3558976e-006");
  BOOST_TEST(printed.appendix2.convergence.at("measure9").text() == "0.1");
  BOOST_TEST(printed.contact_m.zero_node.value() == 9);
}

BOOST_AUTO_TEST_CASE(a_case_without_printed_data_has_none) {
  BOOST_TEST(!printed_in(papers_text.substr(0, papers_text.find("\n[printed]"))).has_value());
}

BOOST_AUTO_TEST_CASE(columns_have_a_number_for_each_point) {
  check_refused("\"0.045\", \"0.050\"]", "\"0.045\"]", "printed.figure5.x: 10 numbers for 11");
  check_refused("\"1.6236048e-006\", ", "", "printed.tri_dist.displacement: 10 numbers for 11");
}

BOOST_AUTO_TEST_CASE(keys_that_are_missing_or_unknown_are_refused) {
  check_refused("strain_energy = \"1.212280e-05\"\n", "",
                "printed.appendix2.measures.strain_energy: missing");
  check_refused("step = \"1e-7\"", "step = \"1e-7\"\nstop = \"1\"",
                "printed.tri_dist.stop: unknown key");
}

BOOST_AUTO_TEST_CASE(every_measure_that_the_report_uses_is_asked_for) {
  for (const std::string name :
       {"max_disp_mag", "max_disp_y", "max_stress_prin", "max_stress_xy", "measure7"}) {
    const std::string key = "\n" + name + " = ";
    const auto begin = papers_text.find(key) + 1;
    const auto end = papers_text.find('\n', begin);
    check_refused(papers_text.substr(begin, end + 1 - begin), "",
                  "printed.appendix2.measures." + name + ": missing");
  }
}

BOOST_AUTO_TEST_CASE(numbers_that_the_report_divides_by_are_not_zero) {
  const std::string measures = "printed.appendix2.measures.";
  check_refused("resultant_load_y = \"-1.600000e+01\"", "resultant_load_y = \"0\"",
                measures + "resultant_load_y: 0: must not be 0");
  check_refused(
      "max_stress_xx = \"-9.787585e+02\"", "max_stress_xx = \"9.927550e+02\"",
      measures + "max_stress_xx: 9.927550e+02: must not be the opposite of max_stress_yy");
  check_refused("\"2.584342E-07\"", "\"0\"", "printed.figure5.error: 0: must be greater than 0");
  check_refused("\"1.023796E-06\"", "\"1.044296E-06\"",
                "printed.figure5.analytical: 1.044296E-06 after 1.044296E-06: ");
}

BOOST_AUTO_TEST_CASE(numbers_in_print_have_a_range) {
  check_refused("strain_energy = \"1.212280e-05\"", "strain_energy = \"1e-60\"",
                "strain_energy: 1e-60: its magnitude must be from 1e-50 to 1e+50");
  check_refused("\"0.050\"]", "\"0.060\"]",
                "printed.figure5.x: 0.060 in: must be 0.05 in, which half_space.points has there");
  check_refused("step = \"1e-7\"", "step = \"0.011\"",
                "must be at most half_space.load.half_width, 0.01 in");
}

BOOST_AUTO_TEST_CASE(counts_of_contact_m_out_of_range_are_refused) {
  check_refused("n_nodes = \"37\"", "n_nodes = \"3\"", "printed.contact_m.n_nodes: 3");
  check_refused("zero_node = \"9\"", "zero_node = \"37\"", "printed.contact_m.zero_node: 37");
  check_refused("spacing = \"0.0005\"", "spacing = \"0\"", "printed.contact_m.spacing");
  for (const char* load : {"2500e-6", "1000", "5000"}) {
    check_refused("value = 2500,", "value = " + std::string(load) + ",",
                  "so that n_nodes nodes just hold the contact under twice contact.load");
  }
}

BOOST_AUTO_TEST_CASE(other_units_than_the_cases_are_refused) {
  check_refused("units = \"in-lbf\"\n\n[printed.figure5]", "units = \"mm-N\"\n\n[printed.figure5]",
                "printed.units");
}

BOOST_AUTO_TEST_SUITE_END()
