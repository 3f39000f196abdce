// SPDX-License-Identifier: GPL-3.0-or-later
// The output of `point-contact`.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "program.hpp"

BOOST_AUTO_TEST_SUITE(point_contact_command_test)

namespace {

const Words ball = words_of("point-contact --radius1 10 --load 100");

double of(const json& result, const char* key) {
  return result.at(key).get<double>();
}

double half_width(const json& result, std::size_t i) {
  return result.at("half_widths").at(i).get<double>();
}

// Steel on steel: a³ = 3PR/(4E*), p0 = 3P/(2πa²), δ = a²/R (Johnson 4.22–4.24).
const double a = std::cbrt(3 * 100 * 10 / (4 * 210000 / 1.82));
const double p0 = 3 * 100 / (2 * std::numbers::pi * a * a);

}  // namespace

BOOST_AUTO_TEST_CASE(a_ball_on_a_plane_needs_a_radius_and_a_load_and_agrees_with_hertz) {
  const json result = json_of(ball);
  const json& hertz = result.at("hertz");

  BOOST_TEST(relative_difference(half_width(hertz, 0), a) < 1e-13);
  BOOST_TEST(relative_difference(of(hertz, "peak_pressure"), p0) < 1e-13);
  BOOST_TEST(relative_difference(of(hertz, "approach"), a * a / 10) < 1e-13);
  for (const std::size_t i : {0U, 1U}) {
    BOOST_TEST(relative_difference(half_width(result, i), a) < 1e-4);
  }
  BOOST_TEST(relative_difference(of(result, "peak_pressure"), p0) < 1e-4);
  BOOST_TEST(relative_difference(of(result, "approach"), a * a / 10) < 1e-4);
  BOOST_TEST(relative_difference(of(result, "load"), 100) < 1e-12);
  BOOST_TEST(relative_difference(of(result, "contact_area"), std::numbers::pi * a * a) < 0.01);
  BOOST_TEST(result.at("nodes") == 256);
  BOOST_TEST(result.at("units").at("contact_area") == "mm^2");
  const std::string text = output_of(ball);
  BOOST_TEST(text.find("assumed: E1 = 210000 MPa") != std::string::npos);
  BOOST_TEST(text.find("half-width, greatest (mm)") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(every_method_and_element_agrees_with_hertz) {
  for (const char* choice : {"--element uniform", "--element pyramid --tolerance 1e-10",
                             "--method variational --tolerance 1e-7"}) {
    const json result = json_of(ball + words_of("--nodes 64") + words_of(choice));
    BOOST_TEST_CONTEXT(choice) {
      BOOST_TEST(relative_difference(of(result, "peak_pressure"), p0) < 1e-3);
      BOOST_TEST(relative_difference(half_width(result, 0), a) < 2e-3);
      BOOST_TEST(of(result.at("residuals"), "pressure") < 1e-6 * p0);
      BOOST_TEST(result.at("contact_regions").size() == 1U);
      BOOST_TEST(result.at("work").at("products").get<int>() > 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(an_ellipse_of_one_to_five_has_the_axes_of_its_closed_form) {
  const json result =
      json_of(words_of("point-contact --radius1x 400 --radius1y 33 --load 100 --nodes 128"));
  const json& hertz = result.at("hertz");

  BOOST_TEST(half_width(hertz, 0) > 4.5 * half_width(hertz, 1));
  for (const std::size_t i : {0U, 1U}) {
    BOOST_TEST(relative_difference(half_width(result, i), half_width(hertz, i)) < 3e-3);
  }
  BOOST_TEST(relative_difference(of(result, "peak_pressure"), of(hertz, "peak_pressure")) < 1e-3);
  // Crossed cylinders of equal radius touch like a sphere on a plane.
  const json crossed = json_of(words_of(
      "point-contact --radius1x 10 --radius1y plane --radius2x plane --radius2y 10 --load 100"));
  BOOST_TEST(relative_difference(half_width(crossed.at("hertz"), 1), a) < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_field_equals_the_csv_and_carries_the_load) {
  const TemporaryFolder folder;
  const std::string field = (folder.path() / "field.csv").string();
  const Words contact = ball + words_of("--nodes 40 --domain 0.5");
  const Columns columns = csv_of(contact);
  const std::string csv = output_of(contact + Words{"--format", "csv", "--field", field});

  BOOST_TEST(csv.starts_with("x,y,pressure,gap\n"));
  BOOST_TEST(csv == sys::read_file(field));
  BOOST_TEST_REQUIRE(columns.at("x").size() == 1600U);
  double sum = 0;
  for (std::size_t i = 0; i < 1600; ++i) {
    const double pressure = number(columns.at("pressure")[i]);
    sum += pressure;
    BOOST_TEST(std::abs(number(columns.at("y")[i])) < 0.25);
    BOOST_TEST((pressure == 0 || std::abs(number(columns.at("gap")[i])) < 1e-8));
  }
  BOOST_TEST(relative_difference(sum * 0.5 * 0.5 / 1600, 100) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_measured_surface_touches_in_several_regions) {
  const TemporaryFolder folder;
  std::string heights;
  for (int j = -20; j <= 20; ++j) {
    for (int i = -20; i <= 20; ++i) {
      const double x = i / 20.0, y = j / 20.0;
      double height = -(x * x + y * y);  // three bumps on a bowl
      for (const auto& [cx, cy] : {std::pair{-0.3, -0.2}, {0.3, -0.25}, {0.05, 0.35}}) {
        height += std::exp(-30 * ((x - cx) * (x - cx) + (y - cy) * (y - cy)));
      }
      heights += (i > -20 ? "," : "") + std::to_string(0.01 * height);
    }
    heights += '\n';
  }
  folder.write("heights.csv", heights);
  const Surroundings there{.folder = folder.path()};
  const Words contact =
      words_of("point-contact --load 100 --spacing 50um --nodes 256 --format json --profile");
  const json result = json::parse(output_of(contact + Words{"heights:heights.csv"}, there));

  BOOST_TEST(result.at("contact_regions").size() == 3U);
  double sum = 0;
  for (const json& region : result.at("contact_regions")) sum += of(region, "load");
  BOOST_TEST(relative_difference(sum, 100) < 1e-12);
  BOOST_TEST(!result.contains("hertz"));
}

BOOST_AUTO_TEST_CASE(a_load_too_large_for_half_spaces_is_computed_with_a_warning) {
  const Outcome heavy = run_program(words_of("point-contact --radius1 10 --load 1e6 --nodes 64"));

  BOOST_TEST(heavy.status == 0);
  BOOST_TEST(heavy.errors.starts_with("halfspace: warning: the contact's half-width is 0."));
  BOOST_TEST(heavy.output.find("Hertz") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
