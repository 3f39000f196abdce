// SPDX-License-Identifier: GPL-3.0-or-later
#include "config/units.hpp"

#include <fmt/format.h>

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <initializer_list>
#include <numbers>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(units_test)

using config::converted;
using config::converts_exactly;
using config::Dimension;
using config::unit_system;
using config::UnitError;

BOOST_AUTO_TEST_CASE(conversions_are_exact_where_the_definitions_are) {
  BOOST_TEST(converted(1, "GPa", "MPa") == 1000);
  BOOST_TEST(converted(1, "in", "mm") == 25.4);
  BOOST_TEST(converted(1, "ksi", "psi") == 1000);
  BOOST_TEST(converted(1, "inch", "in") == 1);
  BOOST_TEST(converted(1, "kN/m", "N/mm") == 1);
  BOOST_TEST(converted(1, "lbf/in^2", "psi") == 1);
}

BOOST_AUTO_TEST_CASE(psi_and_pascal_differ_by_the_pound_and_the_inch) {
  // 0.45359237 kg · 9.80665 m/s² / (0.0254 m)², all exact by definition.
  BOOST_TEST(converted(1, "psi", "Pa") == 0.45359237 * 9.80665 / (0.0254 * 0.0254),
             boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(every_system_is_coherent) {
  for (const auto& system : config::unit_systems()) {
    BOOST_TEST(converted(1, system.force + "/" + system.length + "2", system.stress) == 1);
    BOOST_TEST(converted(1, system.force + "/" + system.length, system.line_load) == 1);
  }
}

BOOST_AUTO_TEST_CASE(a_unit_of_something_else_is_refused) {
  BOOST_CHECK_THROW(converted(1, "mm", "MPa"), UnitError);
  BOOST_CHECK_THROW(converted(1, "lbf", "lbf/in"), UnitError);
}

BOOST_AUTO_TEST_CASE(a_unit_without_an_exact_definition_is_refused) {
  // The first is measured, the others are rounded in UDUNITS-2 or stand for several units.
  for (const auto& [unit, other] : {std::pair{"u", "kg"},
                                    {"sidereal_days", "s"},
                                    {"sidereal_year", "tropical_year"},
                                    {"boiler_horsepower", "W"},
                                    {"footcandle", "lx"},
                                    {"statcoulomb", "C"},
                                    {"firkin", "L"},
                                    {"C12_faraday", "C"},
                                    {"acre_feet", "m3"},
                                    {"rods", "furlong"},
                                    {"perm_0C", "kg/(Pa.s.m2)"},
                                    {"mtorr", "Pa"},
                                    {"torr", "mmHg"},
                                    {"year", "tropical_year"}}) {
    BOOST_TEST_CONTEXT(unit) {
      BOOST_CHECK_THROW(converted(1, unit, other), UnitError);
      BOOST_CHECK_THROW(converted(1, other, unit), UnitError);
      BOOST_CHECK_THROW(converted(0, unit, other), UnitError);
      BOOST_CHECK_THROW(converts_exactly(1, unit, other), UnitError);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_unit_without_an_exact_definition_is_converted_into_its_multiples) {
  BOOST_TEST(converted(1, "Mu", "u") == 1e6);
  BOOST_TEST(converted(3, "u/mm2", "u/m2") == 3e6);
  BOOST_TEST(converted(1, "kyears", "year") == 1000);
  BOOST_TEST(converted(1, "kcal", "cal") == 1000);
  BOOST_TEST(converted(12, "cal/month", "kcal/month") == 0.012);
}

BOOST_AUTO_TEST_CASE(a_name_that_ends_as_another_is_its_own_unit) {
  BOOST_TEST(converted(1, "us", "s") == 1e-6);
  BOOST_TEST(converted(1, "us", "ms") == 1e-3);
  BOOST_TEST(converted(1, "uPa", "Pa") == 1e-6);
  BOOST_TEST(converted(1, "kilopascals", "Pa") == 1000);
  BOOST_TEST(converted(1, "pi rad", "degree") == 180);
  BOOST_TEST(converted(60, "arcminute/s", "deg s-1") == 1);
  BOOST_TEST(converted(2, "deg2", "degree^2") == 2);
  BOOST_TEST(converted(1, "usec", "s") == 1e-6);
  BOOST_CHECK_THROW(converted(1, "us", "kg"), UnitError);
  BOOST_TEST(converted(1, "meV", "eV") == 1e-3);
  BOOST_TEST(converted(1, "µeV", "eV") == 1e-6);
}

BOOST_AUTO_TEST_CASE(an_angle_is_not_converted_into_a_number_without_one) {
  for (const auto& [angle, number] : {std::pair{"rpm", "Hz"},
                                      {"rad/s", "Hz"},
                                      {"cps", "Hz"},
                                      {"rps", "s-1"},
                                      {"rad", "1"},
                                      {"sr", "1"},
                                      {"°", "percent"},
                                      {"′", "1"},
                                      {"arcsec", "ppm"},
                                      {"turn", "1"},
                                      {"grade", "1"},
                                      {"cycle/s", "Bq"},
                                      {"N.m/rad", "N.m"},
                                      {"sr", "rad"},
                                      {"lm", "cd"}}) {
    BOOST_TEST_CONTEXT(angle << " and " << number) {
      BOOST_CHECK_THROW(converted(1, angle, number), UnitError);
      BOOST_CHECK_THROW(converted(1, number, angle), UnitError);
    }
  }
  BOOST_CHECK_EXCEPTION(converted(1, "rpm", "Hz"), UnitError, [](const UnitError& error) {
    return std::string(error.what()) ==
           "\"rpm\" cannot be converted into \"Hz\": an angle is not converted into a number "
           "without one";
  });
  BOOST_TEST(converted(1, "rad", "rad") == 1);
  BOOST_TEST(converted(1, "kHz", "1/s") == 1000);
}

BOOST_AUTO_TEST_CASE(angles_are_converted_into_one_another) {
  constexpr double pi = std::numbers::pi;
  BOOST_TEST(converted(30, "rpm", "rad/s") == pi);
  BOOST_TEST(converted(3000, "rpm", "rps") == 50);
  BOOST_TEST(converted(90, "degree", "rad") == pi / 2);
  BOOST_TEST(converted(180, "°", "rad") == pi);
  BOOST_TEST(converted(90, "°", "′") == 5400);
  BOOST_TEST(converted(1, "turn", "grade") == 400);
  BOOST_TEST(converted(7, "arcsec", "°") == 7.0 / 3600);
  BOOST_TEST(converted(1, "sr", "rad2") == 1);
  BOOST_TEST(converted(5, "lx", "cd.sr/m2") == 5);
  BOOST_TEST(converts_exactly(3000, "rpm", "rps"));
  BOOST_TEST(!converts_exactly(180, "°", "rad"));
}

BOOST_AUTO_TEST_CASE(a_unit_that_is_no_multiple_of_the_wanted_one_is_refused) {
  // Zero of the one must be zero of the other: no offset, no logarithm, no turn of the axis.
  for (const char* const unit : {"in @ 1", "in from 3", "lg(re 1 mm)", "-1 in", "0 in"}) {
    BOOST_TEST_CONTEXT(unit) {
      BOOST_CHECK_THROW(converted(1, unit, "in"), UnitError);
    }
  }
  BOOST_CHECK_EXCEPTION(converted(1, "h", "s-1"), UnitError, [](const UnitError& error) {
    return std::string(error.what()).starts_with("\"h\" is the reciprocal of \"s-1\"");
  });
  BOOST_TEST(converted(1, "12 in", "in") == 12);
  BOOST_TEST(converted(1, "1e-3 in", "in") == 1e-3);
}

BOOST_AUTO_TEST_CASE(a_conversion_is_exact_where_its_digits_end) {
  BOOST_TEST(converts_exactly(39.4, "in", "m"));
  BOOST_TEST(converts_exactly(2, "mi", "km"));
  BOOST_TEST(converts_exactly(100, "lbf", "N"));
  BOOST_TEST(converts_exactly(25.4, "mm", "in"));
  BOOST_TEST(converts_exactly(1200, "m", "km"));
  BOOST_TEST(!converts_exactly(15, "km/h", "mi/h"));
  BOOST_TEST(converted(15, "km/h", "mi/h") == 15 / 1.609344);
  BOOST_TEST(!converts_exactly(3.218688, "km", "nmile"));
  BOOST_TEST(!converts_exactly(100, "psi", "Pa"));
  BOOST_TEST(!converts_exactly(0.1234567890123456, "in", "m"));
}

BOOST_AUTO_TEST_CASE(a_conversion_prints_no_digit_that_the_definition_does_not_give) {
  // The factors are exact, or have more digits than a double. Beside them stands what is printed.
  struct Known {
    const char *from, *to;
    double number;
    const char* printed;
  };
  for (const Known& known : std::initializer_list<Known>{
           {"US_liquid_gallon", "L", 1, "3.785411784"},
           {"US_liquid_quarts", "US_liquid_gallon", 4, "1"},
           {"US_liquid_gallons/min", "L/s", 60, "3.785411784"},
           {"US_fluid_ounces", "mL", 1, "29.5735295625"},
           {"printers_pica", "printers_points", 1, "12"},
           {"acre_foot", "acre_feet", 2, "2"},
           {"eV", "J", 1, "1.602176634e-19"},
           {"bev", "MeV", 1, "1000"},
           {"shaft_horsepower", "W", 1, "745.6998715822702"},   // …702 2
           {"slugs", "lb", 1, "32.17404855643045"},             // …044 62
           {"parsec", "au", 1, "206264.80624709636"},           // …635 516
           {"kparsecs", "light_year", 1, "3261.563777167434"},  // …433 56
           {"troy_pound", "troy_ounces", 1, "12"},
           {"molecules", "mol", 6.02214076e23, "1"},
           {"astronomical_unit", "m", 1, "149597870700"},
           {"in", "m", 1, "0.0254"},
           {"ft", "m", 7, "2.1336"},
           {"yd", "m", 1, "0.9144"},
           {"mi", "km", 1, "1.609344"},
           {"nmile", "m", 1, "1852"},
           {"lb", "kg", 1, "0.45359237"},
           {"lbf", "N", 1, "4.4482216152605"},
           {"lbf", "N", 3, "13.3446648457815"},
           {"klbf", "N", 1, "4448.2216152605"},
           {"psi", "Pa", 1, "6894.757293168361"},      // …168 361 336 7
           {"psi", "Pa", 3, "20684.27187950508"},      // …505 084 010
           {"psi", "Pa", 100, "689475.7293168361"},    // …168 361 336 7
           {"ksi", "MPa", 1, "6.894757293168361"},     // …168 361 336 7
           {"kPa", "psi", 1, "0.1450377377302092"},    // …302 092 151 5
           {"lbf/ft2", "Pa", 1, "47.88025898033584"},  // …335 842 616
           {"lbf.s2/in4", "kg/m3", 1, "10686895.178201316"},
           {"atm", "Pa", 1, "101325"},
           {"inHg", "Pa", 1, "3386.388640341"},
           {"inHg", "Pa", 30, "101591.65921023"},
           {"mmHg", "Pa", 1, "133.322387415"},
           {"bar", "psi", 1, "14.50377377302092"},       // …302 092 151 5
           {"lb/ft3", "kg/m3", 1, "16.01846337396014"},  // …739 601 395 8
           {"lb/in3", "kg/m3", 1, "27679.90471020312"},  // …102 031 213
           {"short_ton", "kg", 1, "907.18474"},
           {"oz/ft2", "oz/m2", 1, "10.763910416709722"},  // …167 097 223 08
           {"knot", "m/s", 1, "0.5144444444444444"},
           {"knot", "km/h", 10, "18.52"},
           {"mi/h", "m/s", 1, "0.44704"},
           {"ft.lbf", "J", 1, "1.3558179483314"},
           {"US_survey_foot", "m", 3937, "1200"},
           {"degF/s", "K/s", 9, "5"},
           {"IT_Btu", "J", 1, "1055.05585262"},
           {"kiloIT_calorie", "J", 1, "4186.8"},
           {"W.h", "kJ", 1, "3.6"},
           {"km/h", "m/s", 1, "0.2777777777777778"},
           {"degree", "rad", 1, "0.0174532925199433"}}) {  // …994 329 577
    BOOST_TEST_CONTEXT(known.number << " " << known.from << " in " << known.to) {
      BOOST_TEST(fmt::format("{}", converted(known.number, known.from, known.to)) == known.printed);
    }
  }
  BOOST_TEST(converts_exactly(30, "inHg", "Pa"));
  BOOST_TEST(converts_exactly(10, "knots", "km/h"));
}

BOOST_AUTO_TEST_CASE(a_name_of_several_units_is_not_converted) {
  for (const auto& [from, to] :
       std::initializer_list<std::pair<const char*, const char*>>{{"kcal", "J"},
                                                                  {"kcal/mol", "kJ/mol"},
                                                                  {"years", "s"},
                                                                  {"tons", "kg"},
                                                                  {"nmi", "m"},
                                                                  {"gallons", "L"},
                                                                  {"pt", "mL"},
                                                                  {"floz", "mL"},
                                                                  {"Mbbl", "m3"},
                                                                  {"tbsp", "tsp"},
                                                                  {"gallon", "US_liquid_gallon"},
                                                                  {"khp", "W"},
                                                                  {"Btu/h", "W"},
                                                                  {"pica", "mm"},
                                                                  {"m2", "acre"}}) {
    BOOST_TEST_CONTEXT(from << " in " << to) {
      BOOST_CHECK_EXCEPTION(converted(1, from, to), UnitError, [](const UnitError& e) {
        return std::string(e.what()).find("no single exact definition of \"") != std::string::npos;
      });
    }
  }
  BOOST_TEST(converted(1, "kcal", "cal") == 1000);
  BOOST_TEST(converted(1, "Julian_year", "d") == 365.25);
  BOOST_TEST(converted(1, "nautical_mile", "m") == 1852);
  BOOST_TEST(converted(1, "long_ton", "lb") == 2240);
  BOOST_TEST(converted(1, "ppt", "1") == 1e-12);  // a part of a trillion, and no picopint
  BOOST_TEST(converted(2, "Mgallons/yr", "kgallon/yr") == 2000);
}

BOOST_AUTO_TEST_CASE(powers_are_read_as_they_look) {
  for (const char* const unit : {"km s-2", "km.s^-2", "km/s2", "km·s⁻²", "km s⁻²", "km/s²"}) {
    BOOST_TEST_CONTEXT(unit) {
      BOOST_TEST(converted(1, unit, "m/s2") == 1000);
    }
  }
  BOOST_TEST(converted(1, "km⁴", "m4") == 1e12);
  BOOST_CHECK_THROW(converted(1, "m^0.5", "1"), UnitError);  // five, says UDUNITS
}

BOOST_AUTO_TEST_CASE(an_unknown_unit_or_system_is_refused_by_its_name) {
  BOOST_CHECK_EXCEPTION(converted(1, "pis", "psi"), UnitError, [](const UnitError& e) {
    return std::string(e.what()).find("\"pis\"") != std::string::npos;
  });
  BOOST_CHECK_THROW(unit_system("cgs"), UnitError);
}

BOOST_AUTO_TEST_CASE(threads_may_ask_for_units_at_once) {
  std::vector<std::thread> threads;
  std::atomic<int> n_wrong = 0;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&n_wrong] {
      for (int k = 0; k < 500; ++k) {
        const bool right = config::is_unit("lbf/in") && !config::is_unit("furlonk") &&
                           converted(39.4, "in", "m") == 1.00076;
        if (!right) ++n_wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  BOOST_TEST(n_wrong == 0);
}

BOOST_AUTO_TEST_CASE(each_dimension_has_its_unit) {
  const auto& metric = unit_system("mm-N");

  BOOST_TEST(metric.unit(Dimension::length) == "mm");
  BOOST_TEST(metric.unit(Dimension::stress) == "MPa");
  BOOST_TEST(metric.unit(Dimension::force) == "N");
  BOOST_TEST(metric.unit(Dimension::line_load) == "N/mm");
  BOOST_TEST(metric.unit(Dimension::none) == "1");
}

BOOST_AUTO_TEST_SUITE_END()
