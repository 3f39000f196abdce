// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/unit.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>
#include <string>

#include "messages.hpp"

BOOST_AUTO_TEST_SUITE(unit_test)

BOOST_AUTO_TEST_CASE(units_are_printed_with_signs_and_powers) {
  const struct {
    const char *unit, *plain, *latex;
  } table[] = {
      {"in", "in", "\\mathrm{in}"},
      {"lbf.s^2/in^4", "lbf s²/in⁴", "\\mathrm{lbf}\\,\\mathrm{s}^{2}/\\mathrm{in}^{4}"},
      {"m s-1", "m s⁻¹", "\\mathrm{m}\\,\\mathrm{s}^{-1}"},
      {"m per s", "m/s", "\\mathrm{m}/\\mathrm{s}"},
      {"m²·kg", "m² kg", "\\mathrm{m}^{2}\\,\\mathrm{kg}"},
      {"W/(m2.K)", "W/(m² K)", "\\mathrm{W}/(\\mathrm{m}^{2}\\,\\mathrm{K})"},
      {"N/m.s", "N s/m", "\\mathrm{N}\\,\\mathrm{s}/\\mathrm{m}"},  // (N/m)·s to UDUNITS-2
      {"1/s", "1/s", "1/\\mathrm{s}"},
      {"um", "µm", "\\mathrm{\\mbox{\\textmu}m}"},
      {"μm", "µm", "\\mathrm{\\mbox{\\textmu}m}"},
      {"kohm", "kΩ", "\\mathrm{k\\Omega }"},
      {"degC", "°C", "{}^{\\circ}\\mathrm{C}"},
      {"°", "°", "^{\\circ}"},
      {"%", "%", "\\%"},
      {"unit", "unit", "\\mathrm{unit}"},
      {"1", "", ""},
      {" ", "", ""},
      {"", "", ""},
  };
  for (const auto& [unit, plain, latex] : table) {
    BOOST_TEST(literate::plain_unit(unit) == plain);
    BOOST_TEST(literate::latex_unit(unit) == latex);
  }
}

BOOST_AUTO_TEST_CASE(unknown_units_are_refused) {
  for (const char* unit : {"{ }", "furlongs per fortnite", "m/", "10 m", "m^", "\\mu m", "50%"}) {
    const std::string message =
        message_of<std::invalid_argument>([=] { literate::plain_unit(unit); });
    BOOST_TEST(holds(message, std::string("'") + unit + "' is not a unit that UDUNITS-2 knows"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
