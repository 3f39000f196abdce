// SPDX-License-Identifier: GPL-3.0-or-later
// halfspace contact and halfspace stress beyond two cylinders, and the input that they refuse.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "program.hpp"

BOOST_AUTO_TEST_SUITE(contact_command_test)

namespace {

using nlohmann::json;

const Words contact = {"contact", "--case", papers_case.string()};
const Words stress = {"stress", "--case", papers_case.string()};
const Words as_json = {"--format", "json"};

json result_of(const Words& command, const Words& more) {
  return json::parse(output_of(command + more + as_json));
}

double number(const json& result, const char* key) {
  return result.at(key).get<double>();
}

double relative_difference(double a, double b) {
  return std::abs(a / b - 1);
}

struct Contact {
  const char* exact;  // the key of the closed form
  Words flags;
};

const std::vector<Contact> contacts = {
    {"hertz", {}},
    {"wedge", {"--profile", "wedge", "--slope", "0.01"}},
    {"rounded-punch", {"--profile", "rounded-punch", "--flat", "0.01", "--edge-radius", "2"}},
    {"power", {"--profile", "power", "--power", "2", "--coefficient", "10"}}};

}  // namespace

BOOST_AUTO_TEST_CASE(every_profile_has_the_half_width_of_its_closed_form) {
  for (const Contact& c : contacts) {
    const json result = result_of(contact, c.flags + Words{"--nodes", "4000"});
    BOOST_TEST(result.at("method") == "fft");
    BOOST_TEST(relative_difference(number(result, "half_width"),
                                   number(result.at(c.exact), "half_width")) < 1e-3,
               c.exact);
  }
}

BOOST_AUTO_TEST_CASE(every_method_element_and_grid_finds_the_same_load_and_its_residuals) {
  for (const Contact& c : contacts) {
    for (const char* method : {"matrix-inversion", "variational", "fft"}) {
      for (const char* element : {"triangular", "uniform", "point"}) {
        for (const char* grid : {"symmetric", "one-sided"}) {
          const json result = result_of(
              contact, c.flags + Words{"--method", method, "--element", element, "--grid", grid});
          BOOST_TEST_CONTEXT(c.exact << ", " << method << ", " << element << ", " << grid) {
            BOOST_TEST(relative_difference(number(result, "load"), 2500) < 1e-12);
            BOOST_TEST(relative_difference(number(result, "half_width"),
                                           number(result.at(c.exact), "half_width")) < 0.02);
            const json& residuals = result.at("residuals");
            BOOST_TEST(number(residuals, "pressure") < 1e-9 * number(result, "peak_pressure"));
            BOOST_TEST(number(residuals, "gap") < 1e-9 * number(result, "half_width"));
            BOOST_TEST(number(residuals, "load") < 1e-12 * 2500);
            BOOST_TEST(result.at("contact_regions").size() == 1U);
            BOOST_TEST(result.at("seconds").get<double>() > 0);
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(sixty_five_thousand_nodes_find_the_peak_to_ten_digits) {
  const json result = result_of(
      contact, {"--nodes", "65536", "--domain", "0.0493417579", "--element", "triangular"});

  BOOST_TEST(relative_difference(number(result, "peak_pressure"),
                                 number(result.at("hertz"), "peak_pressure")) < 1e-10);
  BOOST_TEST(result.at("products").get<int>() <= 25);
}

BOOST_AUTO_TEST_CASE(the_approach_of_a_load_leads_back_to_the_load) {
  const json under_load = result_of(contact, {"--domain", "0.04"});
  const std::string approach = under_load.at("approach").dump();
  const json back = result_of(contact, {"--domain", "0.04", "--approach", approach});

  BOOST_TEST(relative_difference(number(back, "load"), 2500) < 1e-11);
}

BOOST_AUTO_TEST_CASE(a_profile_from_a_file_touches_where_it_is_highest) {
  const TemporaryFolder folder;
  std::string text = "# two bumps\nx,gap\n";
  for (int i = -50; i <= 50; ++i) {
    const double x = i / 1000.0;
    text += std::to_string(x) + "," + std::to_string(1e-3 * std::cos(200 * x) + 1e-3) + "\n";
  }
  const std::string file = "file:" + folder.write("two bumps.csv", text).string();
  const json result = result_of(contact, {"--profile", file, "--load", "100", "--nodes", "500"});
  const json& regions = result.at("contact_regions");

  BOOST_TEST_REQUIRE(regions.size() > 1U);
  double sum = 0;
  for (const json& region : regions) sum += number(region, "load");
  BOOST_TEST(relative_difference(sum, 100) < 1e-12);
}

BOOST_AUTO_TEST_CASE(friction_adds_shear_that_is_at_most_mu_times_the_pressure) {
  const json sliding = result_of(contact, {"--friction", "0.3"});
  const json sticking = result_of(contact, {"--friction", "0.3", "--tangential-load", "-200"});

  BOOST_TEST(relative_difference(number(sliding.at("friction"), "tangential_load"), 750) < 1e-12);
  BOOST_TEST(sliding.at("friction").at("state") == "sliding");
  BOOST_TEST(number(sticking.at("friction"), "tangential_load") == -200);
  BOOST_TEST(sticking.at("friction").at("state") == "partial slip");
  for (std::size_t i = 0; i < sticking.at("x").size(); ++i) {
    const double limit = 0.3 * sticking.at("pressure").at(i).get<double>();
    const double shear = sticking.at("shear").at(i).get<double>();
    BOOST_TEST(shear <= 0);
    BOOST_TEST(-shear <= limit * (1 + 1e-12));
  }
  BOOST_TEST(output_of(contact + Words{"--friction", "0.3", "--format", "csv"})
                 .starts_with("x,pressure,hertz_pressure,gap,shear,slope_of_pressure,"));
}

BOOST_AUTO_TEST_CASE(stresses_beneath_cylinders_are_those_of_mcewen) {
  // The greatest shear, 0.30028 p0 at 0.78615 a (Johnson 4.2), for p0 = 132248 psi, a = 0.0120346
  // in.
  const json result = result_of(stress, {"--x", "0", "--z", "0.00946098", "--nodes", "2000"});
  const json& point = result.at(0);

  BOOST_TEST(relative_difference(number(point, "max_shear"), 0.300283 * 132248.08) < 1e-5);
  BOOST_TEST(relative_difference(number(point, "max_shear"), number(point, "mcewen_max_shear")) <
             1e-6);
}

BOOST_AUTO_TEST_CASE(stresses_at_points_of_a_file_are_those_of_lists) {
  const TemporaryFolder folder;
  const std::string file = folder.write("points.csv", "x,z\n0.001,0.002\n0.001,0.003\n").string();

  BOOST_TEST(output_of(stress + Words{"--points", file}) ==
             output_of(stress + Words{"--x", "0.001", "--z", "0.002,0.003"}));
}

BOOST_AUTO_TEST_CASE(shear_turns_round_on_the_other_body) {
  const Words sliding = {"--friction", "0.2", "--x", "0.003", "--z", "0.001"};
  const json first = result_of(stress, sliding + Words{"--body", "1"});
  const json second = result_of(stress, sliding + Words{"--body", "2"});
  const json without = result_of(stress, {"--x", "0.003", "--z", "0.001"});

  const auto xz = [](const json& result) { return number(result.at(0), "stress_xz"); };
  BOOST_TEST(std::abs(xz(first) + xz(second) - 2 * xz(without)) < 1e-9 * std::abs(xz(without)));
  BOOST_TEST(xz(first) < xz(without));
}

BOOST_AUTO_TEST_CASE(a_load_too_large_for_the_domain_is_refused_with_the_domain_it_needs) {
  for (const char* method : {"matrix-inversion", "variational", "fft"}) {
    check_refused(2, contact + Words{"--domain", "0.02", "--method", method},
                  {"domain = 0.02", "at least 0.02", "contact reaches its end"});
  }
}

BOOST_AUTO_TEST_CASE(bodies_that_do_not_touch_are_refused) {
  check_refused(2, contact + Words{"--approach", "-0.001", "--domain", "0.04"},
                {"approach = -0.001", "no contact"});
}

BOOST_AUTO_TEST_CASE(more_nodes_than_a_dense_matrix_holds_are_refused_with_its_memory) {
  check_refused(2, contact + Words{"--nodes", "20000", "--method", "variational"},
                {"nodes = 20000", "to 10000", "3.2 GB"});
}

BOOST_AUTO_TEST_CASE(tolerances_below_rounding_or_for_another_method_are_refused) {
  for (const char* tolerance : {"1e-15", "0", "-1", "0.5"}) {
    check_refused(2, contact + Words{"--method", "fft", std::string("--tolerance=") + tolerance},
                  {"tolerance", tolerance, "rounding"});
  }
  check_refused(2, contact + Words{"--tolerance", "1e-8"}, {"--tolerance", "matrix-inversion"});
}

BOOST_AUTO_TEST_CASE(flags_that_the_profile_makes_no_use_of_are_refused) {
  check_refused(2, contact + Words{"--slope", "0.1"}, {"--slope", "--profile cylinder"});
  check_refused(2, contact + Words{"--profile", "wedge", "--slope", "0.1", "--radius1", "1"},
                {"--radius1", "--profile wedge"});
  check_refused(2, contact + Words{"--profile", "wedge"}, {"--slope", "missing"});
  check_refused(2, contact + Words{"--profile", "cone"}, {"--profile", "cone", "wedge"});
  check_refused(2, contact + Words{"--load", "1", "--approach", "1"}, {"--load", "--approach"});
  check_refused(2, contact + Words{"--tangential-load", "1"}, {"--tangential-load", "--friction"});
  check_refused(2, contact + Words{"--approach", "1e-4"}, {"--domain", "missing"});
  check_refused(2, contact + Words{"--friction", "0.1", "--tangential-load", "250.1"},
                {"tangential_load", "250.1", "slide"});
}

BOOST_AUTO_TEST_CASE(profiles_that_are_no_profile_are_refused_by_file_and_line) {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& text, const Words& parts) {
    const std::string file = folder.write("profile.csv", text).string();
    check_refused(2, contact + Words{"--profile", "file:" + file}, Words{file} + parts);
  };
  check("x,gap\n0,1\n1,0\n0.5,1\n2,2\n", {":4: ", "x = 0.5", "greater than the one before, 1"});
  check("x,gap\n0,1\n1,0\n1,1\n2,2\n", {":4: ", "x = 1"});
  check("x,gap\n0,1\n1,low\n2,1\n3,2\n", {":3: ", "gap", "low"});
  check("x,gap\n0,1\n1\n2,1\n3,2\n", {":3:1: ", "the line has 1 field, the first one has 2"});
  check("x,height\n0,1\n1,2\n", {":1: ", "heading must be x,gap"});
  check("x,gap\n0,1\n1,2\n", {"2 points", "4 or more"});
  check("", {":1: ", "heading"});
  check_refused(2, contact + Words{"--profile", "file:/none.csv"}, {"cannot read", "/none.csv", "No such file"});
  check_refused(2, contact + Words{"--profile", "file:" + folder.path().string()}, {"Is a directory"});
}

BOOST_AUTO_TEST_CASE(stresses_above_the_surface_or_of_other_elements_are_refused) {
  check_refused(2, stress + Words{"--x", "0", "--z=-1"}, {"z = -1"});
  check_refused(2, stress + Words{"--x", "0"}, {"--z"});
  check_refused(2, stress, {"--x", "--z", "--points"});
  check_refused(2, stress + Words{"--x", "0", "--z", "1", "--element", "uniform"},
                {"triangular elements"});
}

BOOST_AUTO_TEST_CASE(a_grid_too_coarse_for_the_contact_is_refused) {
  check_refused(2, contact + Words{"--domain", "1e6"}, {"nodes = 91", "takes 1 of them"});
}

BOOST_AUTO_TEST_CASE(friction_on_a_one_sided_grid_is_refused) {
  check_refused(2, contact + Words{"--friction", "0.3", "--grid", "one-sided"},
                {"--friction", "--grid symmetric"});
}

BOOST_AUTO_TEST_CASE(shear_that_no_double_holds_is_refused) {
  for (const char* format : {"table", "csv", "json"}) {
    check_refused(2, contact + Words{"--friction", "1e305", "--format", format},
                  {"tangential load", "not a finite number"});
  }
}

BOOST_AUTO_TEST_CASE(a_contact_that_is_not_small_beside_the_bodies_is_warned_of_and_computed) {
  const std::string warning = "halfspace: warning: the contact's half-width is 0.";
  // the half-width grows with the root of the load: 0.012 in at 2500 lbf/in, the smaller radius 1 in
  const Outcome small = run_program(contact + Words{"--load", "1.5e5"});
  BOOST_TEST(small.status == 0);
  BOOST_TEST(small.errors == "");
  const Words heavy = {"--load", "2e5"};
  for (const Words& command : {contact, stress + Words{"--x", "0", "--z", "0.1"}}) {
    const Outcome outcome = run_program(command + heavy);
    BOOST_TEST(outcome.status == 0);
    BOOST_TEST(outcome.errors.find(warning) == 0U, outcome.errors);
    BOOST_TEST(outcome.output != "");
  }
}

BOOST_AUTO_TEST_CASE(the_smaller_radius_is_what_counts_a_hollow_s_too) {
  const auto errors = [](const Words& more) { return run_program(contact + more).errors; };
  const Words heavy = {"--load", "2e5"};
  BOOST_TEST(errors(heavy + Words{"--radius1", "3", "--radius2", "plane"}) == "");
  // R = 3 in, but a shaft of 1 in in a hollow of 1.5 in
  BOOST_TEST(errors(heavy + Words{"--radius1", "1", "--radius2", "-1.5"}).find("least radius") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(other_profiles_have_no_radius_to_be_small_beside) {
  const Words wedge = {"--profile", "wedge", "--slope", "0.01", "--load", "8e4"};
  BOOST_TEST(run_program(contact + wedge).errors == "");
}

BOOST_AUTO_TEST_SUITE_END()
