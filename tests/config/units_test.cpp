// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/units.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <thread>
#include <vector>

#include "messages.hpp"

using config::converted;
using config::UnitError;

BOOST_AUTO_TEST_SUITE(units_test)

// NIST SP 811 (2008), appendix B: 1 in = 0.0254 m, 1 lbf = 4.4482216152605 N.
BOOST_AUTO_TEST_CASE(conversions_follow_the_definitions_of_the_units) {
  const struct {
    double number;
    const char *from, *to;
    double expected;
  } table[] = {
      {39.4, "in", "m", 1.00076},
      {12, "in", "m", 0.3048},
      {3, "ft", "m", 0.9144},
      {-39.4, "lbf", "N", -175.259931641264},
      {3, "psi", "Pa", 20684.2718795051},
      {30e6, "psi", "psi", 30e6},
      {210, "GPa", "MPa", 210e3},
      {1, "lbf.s^2/in^4", "kg/m^3", 10686895.1782013},
      {1, "µm", "m", 1e-6},
      {36, "km/h", "m/s", 10},
      {90, "degree", "rad", 1.5707963267949},
      {0, "in", "m", 0},
  };
  for (const auto& [number, from, to, expected] : table) {
    BOOST_TEST_CONTEXT(number << " " << from) BOOST_TEST(converted(number, from, to) == expected);
  }
}

BOOST_AUTO_TEST_CASE(a_converted_number_has_no_rounding_noise) {
  for (int i = 1; i < 1000; ++i) {
    BOOST_TEST(converted(12 * i, "in", "ft") == i);
    BOOST_TEST(converted(254 * i, "mm", "in") == 10 * i);
  }
}

BOOST_AUTO_TEST_CASE(unit_systems_are_coherent) {
  for (const config::UnitSystem& system : config::unit_systems()) {
    BOOST_TEST(converted(1, system.force + "/(" + system.length + ")^2", system.stress) == 1);
    BOOST_TEST(converted(1, system.force + "/(" + system.length + ")", system.line_load) == 1);
    const std::string mass = system.force + ".s^2/(" + system.length + ")";
    BOOST_TEST(converted(1, mass + "/(" + system.length + ")^3", system.density) == 1);
    BOOST_TEST(system.unit(config::Dimension::stress) == system.stress);
  }
  BOOST_TEST(config::unit_system("mm-N").stress == "MPa");
}

BOOST_AUTO_TEST_CASE(an_impossible_conversion_is_an_error) {
  const auto refused = [](const char* from, const char* to) {
    return message_of<UnitError>([=] { converted(1, from, to); });
  };
  BOOST_TEST(refused("inches of something", "m") == "unknown unit \"inches of something\"");
  BOOST_TEST(refused("N", "m") == "\"N\" cannot be converted into \"m\"");
  BOOST_TEST(holds(refused("degC", "K"), "\"degC\" is not a multiple of \"K\""));
  BOOST_TEST(holds(refused("Hz", "s"), "\"Hz\" is not a multiple of \"s\""));
  BOOST_TEST(holds(message_of<UnitError>([] { config::unit_system("cgs"); }),
                   "unknown unit system \"cgs\": must be one of in-lbf, mm-N, m-N"));
  BOOST_TEST(config::is_unit("W/(m2.K)"));
  BOOST_TEST(!config::is_unit("{ }"));
}

BOOST_AUTO_TEST_CASE(several_threads_can_convert_at_the_same_time) {
  std::vector<double> results(64);
  {
    std::vector<std::jthread> threads;
    for (double& result : results) {
      threads.emplace_back([&result] { result = converted(12, "in", "ft"); });
    }
  }
  for (const double result : results) BOOST_TEST(result == 1);
}

BOOST_AUTO_TEST_SUITE_END()
