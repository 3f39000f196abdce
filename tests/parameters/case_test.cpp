// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/case.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "config/table.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(case_test)

using config::Error;
using parameters::Case;
using parameters::read_case;

namespace {

std::string papers_text() {
  std::ostringstream text;
  text << std::ifstream(PAPERS_CASE).rdbuf();
  return text.str();
}

std::string with(const std::string& before, const std::string& after) {
  std::string text = papers_text();
  const auto at = text.find(before);
  BOOST_REQUIRE(at != std::string::npos);
  return text.replace(at, before.size(), after);
}

// The paper's case with one change is refused, in one line that names the key.
void check_refused(const std::string& before, const std::string& after, const std::string& key) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.toml", with(before, after));
  BOOST_TEST_CONTEXT(after) {
    BOOST_CHECK_EXCEPTION(read_case(file), config::Error, [&](const config::Error& e) {
      const std::string what = e.what();
      BOOST_TEST_MESSAGE(what);
      return what.find(key) != std::string::npos && what.find('\n') == std::string::npos;
    });
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_papers_case_is_what_the_paper_says) {
  const Case c = read_case(PAPERS_CASE);

  BOOST_TEST(c.units.name == "in-lbf");
  BOOST_TEST(c.half_space.material.young() == 30e6);
  BOOST_TEST(c.half_space.material.poisson() == 0.3);
  BOOST_TEST(c.half_space.load.line_load() == 10);
  BOOST_TEST(c.half_space.datum == 10);
  BOOST_TEST(c.half_space.points.size() == 11U);
  BOOST_TEST(c.half_space.points[2] == 0.01);
  BOOST_TEST(c.contact.line_load == 2500);
  BOOST_TEST_REQUIRE(c.point_contact.has_value());
  BOOST_TEST(c.point_contact->load == 100);
}

BOOST_AUTO_TEST_CASE(what_the_paper_prints_is_left_to_who_reads_it) {
  const TemporaryFolder folder;
  const Case c =
      read_case(folder.write("case.toml", with("[printed.tri_dist]", "[printed.other]")));

  BOOST_TEST(c.printed.value().has("other"));
  std::string text = papers_text();
  text.erase(text.find("\n[printed]"));
  BOOST_TEST(!read_case(folder.write("case.toml", text)).printed.has_value());
}

BOOST_AUTO_TEST_CASE(a_plane_and_a_hollow_are_radii) {
  const TemporaryFolder folder;
  const std::string three = "{value = 3, unit = \"in\"}";

  const Case plane = read_case(folder.write("plane.toml", with(three, "\"plane\"")));
  const Case hollow =
      read_case(folder.write("hollow.toml", with(three, "{value = -2, unit = \"in\"}")));

  BOOST_TEST(plane.contact.cylinders.relative_curvature() == 1);
  BOOST_TEST(hollow.contact.cylinders.relative_curvature() == 0.5);
}

BOOST_AUTO_TEST_CASE(points_on_the_left_end_as_far_away_as_points_on_the_right) {
  const TemporaryFolder folder;
  const Case left =
      read_case(folder.write("case.toml", with("first = {value = 0,", "first = {value = -0.05,")));

  BOOST_TEST(left.half_space.farthest_point() == 0.05);
  BOOST_TEST(read_case(PAPERS_CASE).half_space.farthest_point() == 0.05);
}

BOOST_AUTO_TEST_CASE(other_units_are_converted) {
  const TemporaryFolder folder;
  const Case c = read_case(folder.write(
      "case.toml", with("{value = 30e6, unit = \"psi\"}", "{value = 30e3, unit = \"ksi\"}")));

  BOOST_TEST(c.half_space.material.young() == 30e6);
}

BOOST_AUTO_TEST_CASE(every_quantity_out_of_range_is_refused_by_its_key) {
  check_refused("value = 30e6", "value = -30e6", "half_space.material.young");
  check_refused("value = 30e6", "value = 0", "half_space.material.young");
  check_refused("poisson = 0.30", "poisson = 0.5", "half_space.material.poisson");
  check_refused("poisson = 0.30", "poisson = -1", "half_space.material.poisson");
  check_refused("peak_pressure = {value = 1000", "peak_pressure = {value = 0",
                "load.peak_pressure");
  check_refused("half_width = {value = 0.010", "half_width = {value = -0.01", "load.half_width");
  check_refused("datum = {value = 10", "datum = {value = -10", "half_space.datum");
  check_refused("step = {value = 0.005", "step = {value = 0", "points.step");
  check_refused("count = 11", "count = 1", "points.count");
  check_refused("count = 11", "count = 1001", "points.count");
  check_refused("value = 2500", "value = -2500", "contact.load");
  check_refused("datum = {value = 1,", "datum = {value = 0.01,", "contact.datum");
  check_refused("nodes = 91", "nodes = 2", "contact.nodes");
  check_refused("radius = {value = 1,", "radius = {value = 0,", "contact.body1.radius");
  check_refused("radius = {value = 3,", "radius = {value = 1e60,", "contact.body2.radius");
  check_refused("value = 10, unit", "value = nan, unit", "half_space.datum.value");
  check_refused("nodes = 91", "nodes = 99999999",
                "contact.nodes: 99999999: must be from 5 to 16777216");
  check_refused("order = 7", "order = 11", "block.order");
  check_refused("order = 7", "order = 4294967303", "block.order");  // 2³² + 7
  check_refused("refine = 1", "refine = 7", "block.refine: 7: must be from 0 to 6");
  check_refused("value = 2500", "value = 1e-300", "contact.load");
  check_refused("peak_pressure = {value = 1000", "peak_pressure = {value = 1e51",
                "load.peak_pressure");
  check_refused("first = {value = 0,", "first = {value = -1e60,", "points.first");
  check_refused("value = 10, unit", "value = inf, unit", "half_space.datum.value");
}

BOOST_AUTO_TEST_CASE(a_point_contact_has_ranges_too) {
  check_refused("load = {value = 100, unit = \"lbf\"}", "load = {value = -100, unit = \"lbf\"}",
                "point_contact.load: -100 lbf: must be greater than 0");
  check_refused("load = {value = 100, unit = \"lbf\"}", "load = {value = 100, unit = \"psi\"}",
                "point_contact.load");
}

BOOST_AUTO_TEST_CASE(a_case_may_do_without_a_point_contact) {
  const std::string text = papers_text();
  const auto begin = text.find("[point_contact]");
  const auto end = text.find("[block]");
  BOOST_REQUIRE(begin < end);
  const TemporaryFolder folder;
  const auto file = folder.write("case.toml", text.substr(0, begin) + text.substr(end));
  BOOST_TEST(!read_case(file).point_contact.has_value());
}

BOOST_AUTO_TEST_CASE(a_range_that_depends_on_another_key_names_both) {
  const std::string half_width = "half_space.load.half_width";
  check_refused("datum = {value = 10,", "datum = {value = 1000001,", half_width);
  check_refused("step = {value = 0.005", "step = {value = 200000", half_width);
  check_refused("width = {value = 2,", "width = {value = 20.1,", half_width);
  check_refused("height = {value = 1,", "height = {value = 20.1,", half_width);
  check_refused("width = {value = 2,", "width = {value = 0.02,",
                "block.width: 0.02 in: must be greater than 0.02 in, twice " + half_width);
  check_refused("width = {value = 2,", "width = {value = 0.09,",
                "0.09 in: must be at least 0.1 in, twice the farthest of half_space.points");
  check_refused("datum = {value = 1,", "datum = {value = 0.01,", "contact.load, nodes, body1");
  for (const char* radius : {"-1", "-0.5", "-1.0000000001"}) {
    check_refused(
        "radius = {value = 3,", "radius = {value = " + std::string(radius) + ",",
        "contact.body2.radius: " + std::string(radius) + " in with contact.body1.radius 1 in: ");
  }
}

BOOST_AUTO_TEST_CASE(a_title_that_says_nothing_is_refused) {
  check_refused("title = \"Ruggiero (2001)\"", "title = \"\"", ":5:9: title: must name the case");
  check_refused("title = \"Ruggiero (2001)\"", "title = \"  \"", "title: must name the case");
}

BOOST_AUTO_TEST_CASE(units_and_keys_are_checked) {
  check_refused("units = \"in-lbf\"  #", "units = \"ft-lbf\"  #", "units: unknown unit system");
  check_refused("unit = \"psi\"", "unit = \"in\"", "half_space.material.young.unit");
  check_refused("poisson = 0.30", "poisson = 0.30\npoison = 1",
                "half_space.material.poison: unknown");
  check_refused("poisson = 0.30", "", "half_space.material.poisson: missing");
  check_refused("poisson = 0.30", "poisson = \"0.30\"", "must be a number");
}

BOOST_AUTO_TEST_SUITE_END()
