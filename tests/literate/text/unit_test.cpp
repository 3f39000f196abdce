// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/unit.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>
#include <string>

#include "holds.hpp"
#include "message_of.hpp"

BOOST_AUTO_TEST_SUITE(unit_test)

using namespace literate;

namespace {

std::string refusal(const std::string& unit) {
  return message_of<std::invalid_argument>([&] { require_unit(unit); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_unit_has_the_signs_that_its_names_stand_for) {
  BOOST_TEST(plain_unit("us/deg") == "µs/°");
  BOOST_TEST(plain_unit("kohm.uF") == "kΩ µF");
  BOOST_TEST(plain_unit("percent") == "%");
  BOOST_TEST(plain_unit("'") == "′");
  BOOST_TEST(plain_unit("gCO2") == "gCO₂");
  for (const char* as_it_is : {"m", "u", "lbf/in", "cup", "min", "mol", "avoirdupois_ounce", ""}) {
    BOOST_TEST(plain_unit(as_it_is) == as_it_is);
  }
  BOOST_TEST(latex_unit("lbf/in") == "lbf/in");
  BOOST_TEST(latex_unit("avoirdupois_ounce") == "avoirdupois\\text{\\textunderscore}ounce");
  BOOST_TEST(latex_unit("degC/um") == "\\degreeCelsius /\\micro m");
  BOOST_TEST(latex_unit("Å") == "\\LiterateAngstrom ");
  BOOST_TEST(latex_unit("%") == "\\percent ");
  BOOST_TEST(latex_unit("mm H2O") == "mm.H_{2}O");
}

BOOST_AUTO_TEST_CASE(a_name_that_udunits_does_not_know_stands_in_braces_or_is_refused) {
  BOOST_TEST(plain_unit("{kWh}/m2") == "kWh/m²");
  BOOST_TEST(latex_unit("{parked vehicles}.h-1") == "parked\\ vehicles.h^{-1}");
  BOOST_TEST(unit_of_latex("kWh/m^{2}") == "kWh/m²");
  BOOST_TEST(
      refusal("meterz").starts_with("unit 'meterz': UDUNITS-2 does not know 'meterz'; what "
                                    "it does not know stands in braces, {meterz}; "));
  BOOST_TEST(refusal("kWh/m2").starts_with("unit 'kWh/m2': UDUNITS-2 does not know 'kWh'"));
  BOOST_TEST(refusal("{kWh").starts_with("unit '{kWh': a brace is not closed"));
  BOOST_TEST(refusal("{}").starts_with("unit '{}': nothing stands in braces"));
  BOOST_TEST(
      refusal("{dB re 20 µPa}")
          .starts_with("unit '{dB re 20 µPa}': '2' has no place in braces, which hold letters, "
                       "blanks, _, % and signs such as µ; "));
}

BOOST_AUTO_TEST_CASE(every_spelling_of_a_power_is_printed_as_a_power) {
  for (const char* unit : {"m s-2", "m.s-2", "m.s^-2", "m s**-2", "m·s⁻²", "m⋅s-2", "m*s-2",
                           "m-s-2", "m s⁻²", "m1 s-2"}) {
    BOOST_TEST_CONTEXT(unit) {
      BOOST_TEST(plain_unit(unit) == "m s⁻²");
      BOOST_TEST(latex_unit(unit) == "m.s^{-2}");
    }
  }
  for (const char* unit : {"km2", "km^2", "km**2", "km²", "km+2", "km^+2", "(km)2"}) {
    BOOST_TEST_CONTEXT(unit) {
      BOOST_TEST(plain_unit(unit) == "km²");
      BOOST_TEST(latex_unit(unit) == "km^{2}");
    }
  }
  BOOST_TEST(latex_unit("m^12") == "m^{12}");
  BOOST_TEST(plain_unit("MPa.m^0.5") == "MPa m^(0.5)");
  BOOST_TEST(latex_unit("MPa m^(1/2)") == "MPa.m^{1/2}");
  BOOST_TEST(plain_unit("m^2.s") == "m² s");
}

BOOST_AUTO_TEST_CASE(a_slash_divides_by_one_factor) {
  for (const char* unit : {"W/m2/K", "W/(m2 K)", "W/(m^2.K)", "W per m2 per K"}) {
    BOOST_TEST(plain_unit(unit) == "W/(m² K)");
    BOOST_TEST(latex_unit(unit) == "W/(m^{2}.K)");
  }
  BOOST_TEST(plain_unit("lbf.s^2/in^4") == "lbf s²/in⁴");
  BOOST_TEST(plain_unit("N/m.s") == "N s/m");
  BOOST_TEST(plain_unit("W/(m/s)") == "W s/m");
  BOOST_TEST(plain_unit("(m/s)^2") == "m²/s²");
  BOOST_TEST(plain_unit("m / s2") == "m/s²");
  BOOST_TEST(plain_unit("1/s") == "s⁻¹");
  BOOST_TEST(plain_unit("1/(m s2)") == "m⁻¹ s⁻²");
  BOOST_TEST(plain_unit("1") == "");
}

BOOST_AUTO_TEST_CASE(a_unit_that_cannot_be_printed_is_refused_with_how_one_is_spelt) {
  BOOST_TEST(refusal("m#s") ==
             "unit 'm#s': '#' has no place there; a unit is spelt as m s-1, m.s^-1, m/s2, "
             "W/(m2.K), um, degC or %");
  const auto is_told = [](const char* unit, const char* why) {
    BOOST_TEST_CONTEXT(unit) {
      BOOST_TEST(holds(refusal(unit), why));
    }
  };
  for (const char sign : std::string("#&$~\\}@:=<>")) {
    is_told((std::string("m") + sign).c_str(), "has no place there");
  }
  is_told("m2s", "the name 'm2s' has a digit in it");
  is_told("10 m", "a number stands there for a name");
  is_told("m 2", "a number stands there for a name");
  is_told("L/(100 km)", "a number stands there for a name");
  is_told("1e3 m", "a number stands there for a name");
  is_told("1e-3 m", "a number stands there for a name");
  is_told("1.5 m", "a number stands there for a name");
  is_told("m^x", "a power is a whole number");
  is_told("m^", "a power is a whole number");
  is_told("m⁻", "a power is a whole number");
  is_told("(m^0.5)2", "a power of several names is a whole number");
  is_told("(m", "a parenthesis is not closed");
  is_told("m)", "')' has no place there");
  is_told("m/", "a name is missing at its end");
  is_told("m3 per", "a name is missing at its end");
  is_told(" ", "a name is missing at its end");
  is_told("m/語", "'語' has no place there");
}

BOOST_AUTO_TEST_CASE(the_unit_of_a_quantity_in_the_prose_is_read_back) {
  for (const char* unit : {"kohm/°C", "m.s-1", "um", "%", "W/(m2 K)", "mm H2O"}) {
    BOOST_TEST(unit_of_latex(latex_unit(unit)) == plain_unit(unit));
  }
  BOOST_TEST(unit_of_latex("\\percent") == "%");
  BOOST_TEST(unit_of_latex("m/s^2") == "m/s²");
  for (const char* other : {"\\micrometre", "\\metre\\per\\second"}) {
    BOOST_TEST(unit_of_latex(other) == other);
  }
}

BOOST_AUTO_TEST_SUITE_END()
