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

BOOST_AUTO_TEST_CASE(counts_of_contact_m_out_of_range_are_refused) {
  check_refused("n_nodes = \"37\"", "n_nodes = \"3\"", "printed.contact_m.n_nodes: 3");
  check_refused("zero_node = \"9\"", "zero_node = \"37\"", "printed.contact_m.zero_node: 37");
  check_refused("spacing = \"0.0005\"", "spacing = \"0\"", "printed.contact_m.spacing");
}

BOOST_AUTO_TEST_CASE(other_units_than_the_cases_are_refused) {
  check_refused("units = \"in-lbf\"\n\n[printed.figure5]", "units = \"mm-N\"\n\n[printed.figure5]",
                "printed.units");
}

BOOST_AUTO_TEST_SUITE_END()
