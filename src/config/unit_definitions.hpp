// SPDX-License-Identifier: GPL-3.0-or-later
// What units are worth.
#pragma once

namespace config {

/// A unit as a number times a power of π times powers of SI base units.
struct Definition {
  const char* name;  ///< one of its names in UDUNITS-2
  const char* number;
  const char* over = "1";
  int power_of_pi = 0;
};

/// The units, besides powers of ten of SI units, that have one exact definition. UDUNITS-2 knows
/// many of them by a rounded or outdated number, as 3.785412 litres for a gallon, so it reads their
/// names and these are the numbers. Sources: NIST SP 811 (2008), appendix B; the SI brochure
/// (2019); IAU resolutions 2012 B2 and 2015 B2; the Weights and Measures Act 1985 of the UK.
/// Numbers are in SI base units and exact.
inline constexpr Definition definitions[] = {
    {"minute", "60"},
    {"hour", "3600"},
    {"day", "86400"},
    {"week", "604800"},
    {"fortnight", "1209600"},
    {"common_year", "31536000"},
    {"leap_year", "31622400"},
    {"Julian_year", "31557600"},
    {"Gregorian_year", "31556952"},
    {"pi", "1", "1", 1},
    {"degree", "1", "180", 1},
    {"arcminute", "1", "10800", 1},
    {"arcsecond", "1", "648000", 1},
    {"grade", "1", "200", 1},
    {"turn", "2", "1", 1},
    {"rps", "2", "1", 1},
    {"rpm", "1", "30", 1},
    {"inch", "0.0254"},
    {"foot", "0.3048"},
    {"yard", "0.9144"},
    {"mile", "1609.344"},
    {"nautical_mile", "1852"},
    {"US_survey_foot", "1200", "3937"},
    {"US_survey_yard", "3600", "3937"},
    {"US_survey_mile", "6336000", "3937"},
    {"printers_point", "0.0003514598"},
    {"printers_pica", "0.0042175176"},
    {"big_point", "0.0254", "72"},
    {"astronomical_unit", "149597870700"},
    {"light_year", "9460730472580800"},
    {"parsec", "96939420213600000", "1", -1},
    {"knot", "1852", "3600"},
    {"standard_free_fall", "9.80665"},
    {"circular_mil", "1.6129e-10", "1", 1},
    {"darcy", "1e-7", "101325"},
    {"board_foot", "0.028316846592", "12"},
    {"register_ton", "2.8316846592"},
    {"US_liquid_gallon", "0.003785411784"},
    {"US_liquid_quart", "0.000946352946"},
    {"US_liquid_pint", "0.000473176473"},
    {"US_liquid_cup", "0.0002365882365"},
    {"US_liquid_gill", "0.00011829411825"},
    {"US_fluid_ounce", "0.0000295735295625"},
    {"US_dry_gallon", "0.00440488377086"},
    {"US_dry_quart", "0.001101220942715"},
    {"US_dry_pint", "0.0005506104713575"},
    {"UK_liquid_gallon", "0.00454609"},
    {"UK_liquid_quart", "0.0011365225"},
    {"UK_liquid_pint", "0.00056826125"},
    {"UK_liquid_gill", "0.0001420653125"},
    {"UK_fluid_ounce", "0.0000284130625"},
    {"pound", "0.45359237"},
    {"avoirdupois_ounce", "0.45359237", "16"},
    {"grain", "0.00006479891"},
    {"short_ton", "907.18474"},
    {"long_ton", "1016.0469088"},
    {"short_hundredweight", "45.359237"},
    {"long_hundredweight", "50.80234544"},
    {"slug", "4.4482216152605", "0.3048"},
    {"troy_ounce", "0.0311034768"},
    {"troy_pound", "0.3732417216"},
    {"pennyweight", "0.00155517384"},
    {"carat", "0.0002"},
    {"denier", "1e-6", "9"},
    {"kilogram_force", "9.80665"},
    {"pound_force", "4.4482216152605"},
    {"ounce_force", "4.4482216152605", "16"},
    {"poundal", "0.138254954376"},
    {"atmosphere", "101325"},
    {"technical_atmosphere", "98066.5"},
    {"conventional_water", "9806.65"},
    {"conventional_mercury", "133322.387415"},
    {"mmHg", "133.322387415"},
    {"inHg", "3386.388640341"},
    {"ftH2O", "2989.06692"},
    {"psi", "4.4482216152605", "0.00064516"},
    {"watthour", "3600"},
    {"electronvolt", "1.602176634e-19"},
    {"IT_Btu", "1055.05585262"},
    {"IT_calorie", "4.1868"},
    {"thermochemical_calorie", "4.184"},
    {"shaft_horsepower", "745.69987158227022"},
    {"electric_horsepower", "746"},
    {"metric_horsepower", "735.49875"},
    {"degree_rankine", "5", "9"},
    {"avogadro_constant", "6.02214076e23"},
    {"molecule", "1", "6.02214076e23"},
    {"e", "1.602176634e-19"},
    {"curie", "3.7e10"},
    {"roentgen", "0.000258"},
    {"lambert", "1e4", "1", -1},
    {"apostilb", "1", "1", -1},
    {"byte", "8"},
};

/// The names that stand for several units, of which UDUNITS-2 takes one without a word: the calorie
/// of steam tables, the short ton, the tropical year, a nanomile, the millimetre of mercury for a
/// torr, the gallon and the horsepower of the USA.
inline constexpr const char* ambiguous_names[] = {"cal",          "calorie",
                                                  "Btu",          "BTU",
                                                  "ton",          "torr",
                                                  "year",         "yr",
                                                  "nmi",          "hp",
                                                  "horsepower",   "gallon",
                                                  "quart",        "pint",
                                                  "pt",           "cup",
                                                  "gill",         "oz",
                                                  "floz",         "fluid_ounce",
                                                  "liquid_ounce", "liquid_gallon",
                                                  "liquid_quart", "liquid_pint",
                                                  "liquid_cup",   "liquid_gill",
                                                  "fluid_dram",   "fldr",
                                                  "tablespoon",   "Tbl",
                                                  "Tbsp",         "tbsp",
                                                  "Tblsp",        "tblsp",
                                                  "teaspoon",     "tsp",
                                                  "barrel",       "bbl",
                                                  "bushel",       "bu",
                                                  "peck",         "pk",
                                                  "dram",         "dr",
                                                  "pica"};

}  // namespace config
