// SPDX-License-Identifier: GPL-3.0-or-later
// halfspace point-contact as its users start it, and the input that it refuses.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "program.hpp"

BOOST_AUTO_TEST_SUITE(point_contact_command_test)

namespace {

using nlohmann::json;

const Words materials = {"point-contact", "--young1", "210000",     "--poisson1", "0.3",
                         "--young2",      "70000",    "--poisson2", "0.33"};
const Words loaded = materials + Words{"--load", "100"};
const Words spheres = loaded + Words{"--radius1", "10", "--radius2", "7"};

json result_of(const Words& words) {
  return json::parse(output_of(words + Words{"--format", "json"}));
}

double number(const json& result, const char* key) {
  return result.at(key).get<double>();
}

double relative_difference(double a, double b) {
  return std::abs(a / b - 1);
}

// Without the seconds, which no two runs have in common.
std::string untimed(const Words& words) {
  json result = result_of(words);
  result.erase("seconds");
  return result.dump();
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_spheres_come_out_as_hertz_says_on_every_grid_and_element) {
  for (const Words& choice : {Words{},
                              {"--element", "uniform"},
                              {"--element", "point"},
                              {"--grid", "square"},
                              {"--grid", "square", "--element", "bilinear"},
                              {"--grid", "square", "--element", "uniform"},
                              {"--method", "variational", "--tolerance", "1e-7"}}) {
    const json result = result_of(spheres + choice + Words{"--nodes", "64"});
    const json& hertz = result.at("hertz");
    BOOST_TEST_CONTEXT(result.dump()) {
      BOOST_TEST(relative_difference(number(result, "peak_pressure"),
                                     number(hertz, "peak_pressure")) < 1e-3);
      for (const std::size_t i : {0U, 1U}) {
        BOOST_TEST(relative_difference(result.at("half_widths").at(i).get<double>(),
                                       hertz.at("half_widths").at(i).get<double>()) < 2e-3);
      }
      BOOST_TEST(relative_difference(number(result, "approach"), number(hertz, "approach")) < 1e-3);
      BOOST_TEST(relative_difference(number(result, "load"), 100) < 1e-12);
      BOOST_TEST(result.at("work").at("products").get<int>() > 0);
      BOOST_TEST(number(result, "seconds") > 0);
      BOOST_TEST(number(result.at("residuals"), "pressure") <
                 1e-6 * number(result, "peak_pressure"));
      BOOST_TEST(number(result.at("residuals"), "gap") < 1e-6 * number(result, "approach"));
      BOOST_TEST(result.at("contact_regions").size() == 1U);
    }
  }
}

BOOST_AUTO_TEST_CASE(nodes_fill_the_domain_and_nine_tenths_of_it_may_touch) {
  // a³ = 3P/(4E*κ), Johnson (4.22); N = 256 a side and W = 2a/0.9
  const double modulus = 1 / (0.91 / 210000 + (1 - 0.33 * 0.33) / 70000);
  const double a = std::cbrt(3 * 100 / (4 * modulus * (1 / 10.0 + 1 / 7.0)));
  const std::string width = std::to_string(2 * a / 0.9);
  for (const char* grid : {"hexagonal", "square"}) {
    const json result = result_of(spheres + Words{"--nodes", "256", "--domain", width, "--grid",
                                                  grid, "--tolerance", "1e-8"});
    BOOST_TEST(result.at("nodes") == 256);
    BOOST_TEST(relative_difference(number(result, "peak_pressure"),
                                   3 * 100 / (2 * std::numbers::pi * a * a)) < 16 * 2e-6);
    BOOST_TEST(result.at("work").at("products").get<int>() <= 25);
  }
}

BOOST_AUTO_TEST_CASE(an_ellipse_of_one_to_five_has_the_axes_of_its_closed_form) {
  const json result = result_of(loaded + Words{"--radius1x", "400", "--radius1y", "33", "--radius2",
                                               "plane", "--nodes", "128"});
  const json& hertz = result.at("hertz").at("half_widths");

  BOOST_TEST(hertz.at(0).get<double>() > 4.5 * hertz.at(1).get<double>());
  for (const std::size_t i : {0U, 1U}) {
    BOOST_TEST(relative_difference(result.at("half_widths").at(i).get<double>(),
                                   hertz.at(i).get<double>()) < 1e-4);
  }
  BOOST_TEST(relative_difference(number(result, "peak_pressure"),
                                 number(result.at("hertz"), "peak_pressure")) < 1e-4);
}

BOOST_AUTO_TEST_CASE(other_bodies_have_the_approach_of_their_closed_forms) {
  struct Body {
    const char* key;
    Words flags;
  };
  for (const Body& body :
       {Body{"cone", {"--profile", "cone", "--slope", "0.02"}},
        {"flat-punch", {"--profile", "flat-punch", "--flat", "0.3"}},
        {"power", {"--profile", "power", "--power", "2", "--coefficient", "3"}}}) {
    const json result = result_of(loaded + body.flags + Words{"--nodes", "128"});
    BOOST_TEST_CONTEXT(body.key) {
      BOOST_TEST(relative_difference(number(result, "approach"),
                                     number(result.at(body.key), "approach")) < 0.01);
      BOOST_TEST(relative_difference(result.at("half_widths").at(0).get<double>(),
                                     result.at(body.key).at("half_widths").at(0).get<double>()) <
                 0.01);
    }
  }
  const json rounded =
      result_of(loaded + Words{"--profile", "rounded-punch", "--flat", "0.3", "--edge-radius", "30",
                               "--domain", "1.5", "--nodes", "128"});
  BOOST_TEST(rounded.at("half_widths").at(0).get<double>() > 0.3);
}

BOOST_AUTO_TEST_CASE(the_approach_of_a_load_leads_back_to_the_load) {
  const Words bodies = {"--radius1", "10", "--radius2", "7", "--nodes", "64", "--domain", "0.5"};
  const json under_load = result_of(loaded + bodies);
  const json back =
      result_of(materials + bodies + Words{"--approach", under_load.at("approach").dump()});

  BOOST_TEST(relative_difference(number(back, "load"), 100) < 1e-7);
}

BOOST_AUTO_TEST_CASE(the_field_is_the_csv_and_carries_the_load) {
  const TemporaryFolder folder;
  const std::string field = (folder.path() / "field.csv").string();
  const Words contact = spheres + Words{"--nodes", "40", "--grid", "square", "--domain", "0.5"};
  const std::string csv = output_of(contact + Words{"--format", "csv", "--field", field});

  BOOST_TEST(csv == sys::read_file(field));
  const auto lines = sys::lines_of(csv);
  BOOST_TEST_REQUIRE(lines.size() == 1601U);
  BOOST_TEST(lines[0] == "x,y,pressure,gap");
  double sum = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    double x, y, pressure, gap;
    const std::string line(lines[i]);
    BOOST_TEST_REQUIRE(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &x, &y, &pressure, &gap) == 4);
    BOOST_TEST(std::abs(x) < 0.25);
    BOOST_TEST((pressure == 0 || std::abs(gap) < 1e-8));
    sum += pressure;
  }
  BOOST_TEST(relative_difference(sum * 0.5 * 0.5 / 1600, 100) < 1e-12);
}

BOOST_AUTO_TEST_CASE(two_threads_give_the_same_bytes) {
  const Words contact = spheres + Words{"--nodes", "200"};
  const Words two = {"--threads", "2"};

  BOOST_TEST(output_of(contact + Words{"--format", "csv"}) ==
             output_of(contact + two + Words{"--format", "csv"}));
  BOOST_TEST(untimed(contact) == untimed(contact + two));
}

BOOST_AUTO_TEST_CASE(paraview_gets_a_file) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "contact.vtu").string();
  output_of(spheres + Words{"--nodes", "32", "--vtu", file, "--friction", "0.3"});
  const std::string text = sys::read_file(file);

  BOOST_TEST(text.starts_with("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\""));
  for (const char* name : {"pressure", "gap", "shear"}) {
    BOOST_TEST(text.find(std::string("Name=\"") + name + "\"") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(partial_slip_of_spheres_is_that_of_cattaneo_and_mindlin) {
  const json result =
      result_of(spheres + Words{"--nodes", "128", "--friction", "0.3", "--tangential-load", "-12"});
  const json& friction = result.at("friction");
  const json& exact = friction.at("cattaneo_mindlin");

  BOOST_TEST(friction.at("state") == "partial slip");
  BOOST_TEST(relative_difference(number(friction, "displacement"), number(exact, "displacement")) <
             1e-4);
  const double c = number(exact, "stick_radius");
  BOOST_TEST(relative_difference(number(friction, "stick_area"), std::numbers::pi * c * c) < 0.02);
  const json sliding = result_of(spheres + Words{"--nodes", "32", "--friction", "0.3"});
  BOOST_TEST(sliding.at("friction").at("state") == "sliding");
  BOOST_TEST(relative_difference(number(sliding.at("friction"), "tangential_load"), 30) < 1e-12);
  BOOST_TEST(output_of(spheres + Words{"--nodes", "32", "--friction", "0.3", "--format", "csv"})
                 .starts_with("x,y,pressure,gap,shear\n"));
}

BOOST_AUTO_TEST_CASE(stresses_beneath_spheres_are_those_of_huber) {
  for (const char* body : {"1", "2"}) {
    const json result =
        result_of(spheres + Words{"--nodes", "64", "--depths", "0.05,0.1,0.4", "--body", body});
    BOOST_TEST_REQUIRE(result.at("stresses").size() == 3U);
    for (const json& at : result.at("stresses")) {
      BOOST_TEST(relative_difference(number(at, "max_shear"), number(at, "huber_max_shear")) <
                 1e-3);
      BOOST_TEST(relative_difference(number(at, "stress_xx"), number(at, "stress_yy")) < 1e-3);
      // on the axis both measures hang on one difference
      BOOST_TEST(relative_difference(number(at, "von_mises"), 2 * number(at, "max_shear")) < 1e-3);
    }
  }
  check_refused(2, spheres + Words{"--depths", "0"}, {"depth = 0", "greater than 0"});
  check_refused(2, spheres + Words{"--depths", "1", "--friction", "0.1"},
                {"--depths", "--friction"});
  check_refused(2, spheres + Words{"--body", "2"}, {"--body needs --depths"});
}

BOOST_AUTO_TEST_CASE(a_measured_surface_touches_in_several_regions) {
  const TemporaryFolder folder;
  std::string map;
  for (int j = 0; j < 41; ++j) {
    for (int i = 0; i < 41; ++i) {
      const double x = (i - 20) / 20.0;
      const double y = (j - 20) / 20.0;
      // three bumps on a bowl
      double height = -(x * x + y * y);
      for (const auto& [cx, cy] : {std::pair{-0.3, -0.2}, {0.3, -0.25}, {0.05, 0.35}}) {
        height += std::exp(-30 * ((x - cx) * (x - cx) + (y - cy) * (y - cy)));
      }
      map += (i > 0 ? "," : "") + std::to_string(0.01 * height);
    }
    map += '\n';
  }
  const std::string file = folder.write("three bumps.csv", map).string();
  const json result = result_of(
      loaded + Words{"--profile", "heights:" + file, "--spacing", "0.05", "--nodes", "128"});
  const json& regions = result.at("contact_regions");

  BOOST_TEST(regions.size() == 3U);
  double sum = 0;
  for (const json& region : regions) sum += number(region, "load");
  BOOST_TEST(relative_difference(sum, 100) < 1e-12);
  BOOST_TEST(output_of(loaded + Words{"--profile", "heights:" + file, "--spacing", "0.05"})
                 .find("3 regions in contact") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(maps_with_gaps_or_ragged_rows_are_refused_by_file_line_and_column) {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& text, const Words& parts) {
    const std::string file = folder.write("map.csv", text).string();
    check_refused(2, loaded + Words{"--profile", "file:" + file, "--spacing", "1"},
                  Words{file} + parts);
  };
  check("1,2,3,4\n1,,3,4\n1,2,3,4\n1,2,3,4\n", {":2:3: ", "gap", "missing"});
  check("1,2,3,4\n1,2,3\n1,2,3,4\n1,2,3,4\n", {":2: ", "3 numbers", "line 1 holds 4"});
  check("1,2,3,4\n1,2,high,4\n1,2,3,4\n1,2,3,4\n", {":2:5", "high"});
  check("1,2,3\n", {"1 lines of 3 numbers"});
  check_refused(2, loaded + Words{"--profile", "file:/none.csv", "--spacing", "1"}, {"/none.csv"});
}

BOOST_AUTO_TEST_CASE(a_contact_that_reaches_the_end_is_refused_with_the_domain_it_needs) {
  check_refused(2, spheres + Words{"--domain", "0.2", "--nodes", "64"},
                {"domain", "0.2", "reaches the end", "holds it"});
}

BOOST_AUTO_TEST_CASE(nodes_that_do_not_fit_the_memory_are_refused_with_their_need) {
  for (const char* n : {"200000", "99999999999"}) {
    check_refused(2, spheres + Words{"--nodes", n}, {"nodes", "GB of memory"});
  }
}

BOOST_AUTO_TEST_CASE(bodies_that_do_not_touch_at_a_point_are_refused) {
  check_refused(2, loaded + Words{"--radius1", "10", "--radius2", "-10"}, {"curvatures", "0"});
  check_refused(2, loaded + Words{"--radius1", "10", "--radius2", "-9"},
                {"curvatures", "= -0.0222"});
  check_refused(2, spheres + Words{"--domain", "1000", "--nodes", "64"}, {"cannot resolve it"});
  check_refused(2, spheres + Words{"--friction", "0.1", "--tangential-load", "10.1"},
                {"tangential_load", "10.1", "slide"});
  check_refused(2, spheres + Words{"--tolerance", "1e-15"}, {"tolerance", "1e-15", "rounding"});
  check_refused(2, spheres + Words{"--field", "/none/field.csv"}, {"--field", "folder"});
}

BOOST_AUTO_TEST_CASE(a_load_beyond_half_spaces_is_warned_of_and_computed) {
  const Outcome heavy = run_program(
      materials + Words{"--radius1", "10", "--radius2", "7", "--load", "1e6", "--nodes", "64"});
  BOOST_TEST(heavy.status == 0);
  BOOST_TEST(heavy.errors.find("halfspace: warning: the contact's half-width is") !=
             std::string::npos);
  BOOST_TEST(heavy.output.find("Hertz") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
