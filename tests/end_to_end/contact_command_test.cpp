// SPDX-License-Identifier: GPL-3.0-or-later
// The output of `contact` and `stress`.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "program.hpp"

BOOST_AUTO_TEST_SUITE(contact_command_test)

namespace {

const Words paper = {"contact", "--case", papers_case.string()};
const Words roller = words_of("contact --radius1 10 --load 100");

double of(const json& result, const char* key) {
  return result.at(key).get<double>();
}

// Steel on steel: E* = 210000/(2·0.91) MPa; a = √(4PR/(πE*)) and p0 = 2P/(πa) (Johnson 4.43, 4.45).
const double a = std::sqrt(4 * 100 * 10 / (std::numbers::pi * 210000 / 1.82));
const double p0 = 2 * 100 / (std::numbers::pi * a);

}  // namespace

BOOST_AUTO_TEST_CASE(a_roller_on_a_plane_needs_a_radius_and_a_load_and_agrees_with_hertz) {
  const json result = json_of(roller);

  BOOST_TEST(relative_difference(of(result, "half_width"), a) < 2e-5);
  BOOST_TEST(relative_difference(of(result, "peak_pressure"), p0) < 2e-5);
  BOOST_TEST(relative_difference(of(result, "load"), 100) < 1e-12);
  BOOST_TEST(relative_difference(of(result.at("hertz"), "half_width"), a) < 1e-14);
  BOOST_TEST(relative_difference(of(result.at("hertz"), "peak_pressure"), p0) < 1e-14);
  BOOST_TEST(result.at("x").size() == 401U);
  BOOST_TEST(result.at("contact_regions").size() == 1U);
  const std::string text = output_of(roller);
  BOOST_TEST(text.find("assumed: E1 = 210000 MPa, nu1 = 0.3, E2 =") != std::string::npos);
  BOOST_TEST(text.find("0.1050464") != std::string::npos);
  BOOST_TEST(text.find("0.1050464    0.0004 %") != std::string::npos, text);
}

BOOST_AUTO_TEST_CASE(every_method_and_element_finds_the_load_and_leaves_no_residual) {
  for (const char* method : {"matrix-inversion", "variational", "fft"}) {
    for (const char* element : {"triangular", "uniform", "point"}) {
      const json result = json_of(paper + Words{"--method", method, "--element", element});
      BOOST_TEST_CONTEXT(method << ", " << element) {
        BOOST_TEST(relative_difference(of(result, "load"), 2500) < 1e-12);
        BOOST_TEST(relative_difference(of(result, "half_width"),
                                       of(result.at("hertz"), "half_width")) < 0.01);
        BOOST_TEST(of(result.at("residuals"), "gap") < 1e-9 * of(result, "half_width"));
        BOOST_TEST(of(result.at("residuals"), "pressure") < 1e-9 * of(result, "peak_pressure"));
        BOOST_TEST(result.at("method") == method);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_million_nodes_give_the_peak_to_ten_digits_and_are_all_printed) {
  const json result = json_of(roller + words_of("--nodes 1048576"));

  BOOST_TEST(relative_difference(of(result, "peak_pressure"), p0) < 1e-10);
  BOOST_TEST(result.at("products").get<int>() <= 30);
  for (const char* column : {"x", "pressure", "gap"})
    BOOST_TEST(result.at(column).size() == 1048576U);
}

BOOST_AUTO_TEST_CASE(csv_and_json_have_the_same_pressures) {
  const Columns columns = csv_of(paper);
  const json result = json_of(paper);

  BOOST_TEST(columns.at("hertz_pressure").size() == 91U);
  for (const char* column : {"x", "pressure", "gap"}) {
    for (std::size_t i = 0; i < 91; ++i) {
      BOOST_TEST(result.at(column).at(i).get<double>() == number(columns.at(column)[i]));
    }
  }
}

BOOST_AUTO_TEST_CASE(radii_materials_and_loads_have_the_effect_of_hertz) {
  const auto hertz = [](const char* more) {
    return of(json_of(roller + words_of(more)).at("hertz"), "half_width");
  };

  BOOST_TEST(relative_difference(hertz("--radius2 plane"), a) < 1e-14);
  BOOST_TEST(relative_difference(hertz("--radius2 10"), a / std::sqrt(2)) < 1e-14);
  BOOST_TEST(relative_difference(hertz("--radius2=-20"), a * std::sqrt(2)) < 1e-14);
  BOOST_TEST(relative_difference(hertz("--young 52.5GPa --poisson 0.3"), 2 * a) < 1e-14);
  // One rigid body: E* is twice that of two.
  BOOST_TEST(relative_difference(hertz("--young2 1e30 --poisson2 0"), a / std::sqrt(2)) < 1e-14);
  BOOST_TEST(relative_difference(
                 of(json_of(words_of("contact --radius1 10 --load 400")).at("hertz"), "half_width"),
                 2 * a) < 1e-14);
}

BOOST_AUTO_TEST_CASE(the_approach_at_a_datum_is_printed_beside_that_of_hertz) {
  const json result = json_of(paper);

  // R = 3/4 in, E* = 30e6/1.82 psi: a = 0.0120346 in, p0 = 132248 psi (Johnson 4.43, 4.45).
  BOOST_TEST(relative_difference(of(result.at("hertz"), "half_width"), 0.01203458) < 1e-6);
  BOOST_TEST(relative_difference(of(result.at("hertz"), "peak_pressure"), 132248.08) < 1e-7);
  BOOST_TEST(relative_difference(of(result, "approach"), of(result.at("hertz"), "approach")) <
             1e-4);
  BOOST_TEST(!json_of(roller).contains("approach"));
  BOOST_TEST(output_of(paper).find("approach of points at x = 1 in") != std::string::npos);
  check_refused(roller + words_of("--datum 0.01"), {"datum", "0.01", "outside the contact"});
}

BOOST_AUTO_TEST_CASE(a_profile_from_a_file_touches_where_it_is_highest) {
  const TemporaryFolder folder;
  std::string text = "# two bumps\nx,gap\n";
  for (int i = -50; i <= 50; ++i) {
    const double x = i / 1000.0;
    text += std::to_string(x) + "," + std::to_string(1e-3 * std::cos(200 * x) + 1e-3) + "\n";
  }
  folder.write("two bumps.csv", text);
  const Words bumps = {"contact", "--profile", "file:" + (folder.path() / "two bumps.csv").string(),
                       "--load",  "2N/mm",     "--nodes",
                       "800"};
  const json result = json_of(bumps);

  BOOST_TEST(result.at("contact_regions").size() > 1U);
  double sum = 0;
  for (const json& region : result.at("contact_regions")) sum += of(region, "load");
  BOOST_TEST(relative_difference(sum, 2) < 1e-12);
  BOOST_TEST(!result.contains("hertz"));
  BOOST_TEST(output_of(bumps).find("regions in contact") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(stresses_beneath_a_roller_match_mcewen) {
  // The greatest in-plane shear is 0.300283 p0 at 0.786151 a (Johnson, section 4.2).
  const Words deepest = {"stress", "--radius1", "10",
                         "--load", "100",       "--nodes",
                         "2000",   "--z",       std::to_string(0.786151 * a)};
  const json point = json_of(deepest).at(0);
  const json surface = json_of(words_of("stress --radius1 10 --load 100 --z 0")).at(0);

  BOOST_TEST(relative_difference(of(point, "max_shear"), 0.300283 * p0) < 1e-5);
  BOOST_TEST(relative_difference(of(point, "max_shear"), of(point, "mcewen_max_shear")) < 1e-6);
  BOOST_TEST(point.at("units").at("stress") == "MPa");
  // On the surface σ_xx = σ_zz = −p0 and σ_yy = −2νp0: no in-plane shear, but shear across the
  // plane.
  BOOST_TEST(std::abs(of(surface, "max_shear")) < 1e-9 * p0);
  BOOST_TEST(relative_difference(of(surface, "largest_shear"), 0.2 * p0) < 2e-5);
  BOOST_TEST(relative_difference(of(surface, "von_mises"), 0.4 * p0) < 2e-5);
}

BOOST_AUTO_TEST_CASE(stresses_beneath_a_strip_match_johnson) {
  // Johnson (2.30) on the axis at z = a: α = π/4, σ_zz, σ_xx = −(2p/π)(α ± sin α cos α).
  const Words strip = words_of("stress --shape uniform --peak-pressure 100 --half-width 2 --z 2");
  const json axis = json_of(strip).at(0);
  const double mean = -50, half_difference = 100 / std::numbers::pi;

  BOOST_TEST(relative_difference(of(axis, "stress_zz"), mean - half_difference) < 1e-14);
  BOOST_TEST(relative_difference(of(axis, "stress_xx"), mean + half_difference) < 1e-14);
  BOOST_TEST(relative_difference(of(axis, "largest_shear"), half_difference) < 1e-14);
  // σ_yy = ν(σ_xx + σ_zz) with ν = 0.3 of the default steel.
  BOOST_TEST(relative_difference(of(axis, "stress_yy"), 0.3 * 2 * mean) < 1e-14);
  const Words edge =
      words_of("stress --shape uniform --peak-pressure 100 --half-width 2 --x 2 --z 0");
  BOOST_TEST(json_of(edge).at(0).at("stress_zz").is_null());
  BOOST_TEST(output_of(edge).find("no limit") != std::string::npos);
  // A linear fall with fraction 1 is the strip, and a formula is sampled finely enough.
  const json linear =
      json_of(words_of("stress --shape linear:1 --peak-pressure 100 --half-width 2 --z 2"));
  BOOST_TEST(relative_difference(of(linear.at(0), "stress_zz"), of(axis, "stress_zz")) < 1e-14);
  const json formula = json_of(
      words_of("stress --shape expression:p0*(1-abs(x)/a) --peak-pressure 9 --half-width 2 --z 1"));
  const json named =
      json_of(words_of("stress --shape triangular --peak-pressure 9 --half-width 2 --z 1"));
  BOOST_TEST(relative_difference(of(formula.at(0), "von_mises"), of(named.at(0), "von_mises")) <
             1e-6);
}

BOOST_AUTO_TEST_CASE(stresses_use_poissons_ratio_of_the_first_body) {
  const auto mises = [](const char* ratios) {
    return of(
        json_of(words_of("stress --radius1 10 --load 100 --z 0 --young 1e5") + words_of(ratios))
            .at(0),
        "von_mises");
  };

  BOOST_TEST(relative_difference(mises("--poisson1 0.4 --poisson2 0"),
                                 0.2 * mises("--poisson1 0 --poisson2 0.4")) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_contact_that_is_large_for_half_spaces_is_computed_with_a_warning) {
  const std::string warning = "halfspace: warning: the contact's half-width is 0.";
  const auto errors = [](const char* more) {
    return run_program(words_of("contact --load 12000") + words_of(more)).errors;
  };

  // a = 0.105 mm·√(120·R/10) with the relative curvature 1/R; the least radius is that of one body.
  BOOST_TEST(errors("--radius1 10").find(warning) == 0U);
  BOOST_TEST(errors("--radius1 200") == "");
  BOOST_TEST(errors("--radius1 10 --radius2 1e6").find(warning) == 0U);
  BOOST_TEST(errors("--radius1 20 --radius2=-21").find("least radius") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
