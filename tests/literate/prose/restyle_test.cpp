// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/restyle.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>
#include <string>

#include "holds.hpp"
#include "literate/document/document.hpp"
#include "message_of.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(restyle_test)

using namespace literate;

namespace {

// What names.json makes of values, read again.
const Names& names() {
  static const Names stored = [] {
    Document document;
    document.value("period", Value({2.3456789, 2e-5}, significant(4), "s"));
    document.value("width", Value(0.01, exact(), "in"));
    document.value("rod", Value(39.4, exact(), "in"));
    document.value("share", Value({0.123456, 1e-4}, percent(1)));
    document.value("error", Value({7.37e-4, 6e-6}, scientific(1).rounded_up(), "in"));
    document.value("rounding", Value(2.34e-15, scientific(2)).as_is());
    document.value("small", Value({1.25e-7, 1e-12}, scientific(2), "lbf/in"));
    document.value("catchment", Value(17788.04, significant(5), "km2").as_is());
    document.value("tie", Value(0.125, exact()));
    document.value("count", Value(1048576, integer()));
    document.value("shift", Value(numerics::Estimate{2.5, 0}, fixed(0), "h"));
    document.value("sum", Value(0.1 + 0.2, exact(), "m"));
    document.value("heat", Value({20, 0.1}, fixed(1), "degC"));
    document.value("mean", Value({0.123456, 1.2e-4}, uncertain(), "s"));
    document.value("fraction", Value({0.123456, 1.2e-4}, uncertain()));
    document.value("integral", Value({2.3456789, 2e-5}, supported(4), "s"));
    document.value("speed", Value(15, exact(), "km/h"));
    document.value("slow", Value(5, exact(), "km/h"));
    document.value("mile", Value(2, exact(), "mi"));
    document.value("track", Value(3.218688, exact(), "km"));
    document.value("pressure", Value(100, exact(), "psi"));
    document.value("transfer", Value({2.5, 0.001}, fixed(3), "W/m2/K"));
    document.value("tiny", Value({2.5, 1e-15}, uncertain(), "m"));
    document.value("work", Value({9.304813, 0.284}, supported(), "ft.lbf"));
    document.value("torque", Value({9.304813, 0.284}, significant(3), "ft.lbf"));
    const numerics::Measured load =
        numerics::Measured(993.63, 20.04, "statistics") + numerics::Measured(0, 8.8, "calibration");
    document.value("load", Value(load, uncertain(), "psi"));
    document.value("sides", Value(994, Uncertainty::to_sides(18, 21), uncertain(), "psi"));
    document.value("load-by-kind", Value(load, uncertain().by_kind(), "psi"));
    document.value("word", Value::text("none"));
    const TemporaryFolder folder;
    document.write(folder / "out");
    return read_names(folder / "out/names.json");
  }();
  return stored;
}

Value styled(const std::string& key, const std::string& options) {
  return restyled(names().numbers.at(key), options);
}

std::string refusal(const std::string& key, const std::string& options) {
  return message_of<std::invalid_argument>([&] { styled(key, options); });
}

Restyled of_text(const std::string& text) {
  const TemporaryFolder folder;
  sys::write_file_atomically(folder / "paper/a.tex", text);
  return restyled_values(folder / "paper", names());
}

}  // namespace

BOOST_AUTO_TEST_CASE(digits_and_formats_come_from_the_unrounded_number) {
  BOOST_TEST(styled("period", "digits=3").latex() == "\\qty{2.35}{s}");
  BOOST_TEST(styled("period", "digits=5").latex() == "\\qty{2.3457}{s}");
  BOOST_TEST(styled("period", "decimals=1").latex() == "\\qty{2.3}{s}");
  BOOST_TEST(styled("period", "format=fixed,decimals=2").printed() == "2.35 s");
  BOOST_TEST(styled("period", " format = scientific , digits = 2 ").printed() == "2.3 s");
  BOOST_TEST(styled("period", "format=scientific").printed() == "2.346 s");
  BOOST_TEST(styled("period", "format=uncertain").printed() == "(2.345679 ± 0.000021) s");
  BOOST_TEST(styled("small", "digits=3").printed() == "1.25e-7 lbf/in");
  BOOST_TEST(styled("small", "format=significant").printed() == "1.2e-7 lbf/in");
  BOOST_TEST(styled("count", "format=scientific,digits=3").printed() == "1.05e6");
  BOOST_TEST(styled("tie", "decimals=2").printed() == "0.12");  // half to even
  BOOST_TEST(styled("share", "digits=2").latex() == "\\qty{12}{\\percent}");
  BOOST_TEST(styled("share", "format=percent,decimals=0").printed() == "12 %");
  BOOST_TEST(styled("share", "unit=1,digits=3").printed() == "0.123");
  BOOST_TEST(styled("tie", "format=percent").printed() == "12.5 %");
  BOOST_TEST(styled("tie", "unit=percent").printed() == "12.5 %");
}

BOOST_AUTO_TEST_CASE(a_value_keeps_its_unit_and_converts_into_others) {
  BOOST_TEST(styled("width", "unit=mm").latex() == "\\qty{0.254}{mm}");
  BOOST_TEST(styled("width", "unit={um},digits=2").latex() == "\\qty{250}{\\micro m}");
  BOOST_TEST(styled("rod", "unit=m").printed() == "1.00076 m");
  BOOST_TEST(styled("shift", "unit=min").printed() == "150 min");
  BOOST_TEST(styled("shift", "unit=min,format=fixed,decimals=0").printed() == "150 min");
  BOOST_TEST(styled("sum", "unit=cm").printed() == "30.000000000000004 cm");
  BOOST_TEST(styled("width", "digits=1").latex() == "\\qty{0.01}{in}");
  BOOST_TEST(styled("period", "unit=ms").printed() == "2346 ms");
  BOOST_TEST(styled("period", "unit=ms,digits=5").printed() == "2345.7 ms");
  BOOST_TEST(styled("period", "unit=ms,format=uncertain").printed() == "(2345.679 ± 0.021) ms");
  BOOST_TEST(styled("catchment", "unit=mi2").printed() == "6868 mi²");  // 6868.0 is not known
  BOOST_TEST(styled("small", "unit=N/m").printed() == "2.2e-5 N/m");
}

BOOST_AUTO_TEST_CASE(an_error_stays_beside_its_number) {
  BOOST_TEST(styled("mean", "unit=ms").printed() == "(123.46 ± 0.13) ms");
  BOOST_TEST(styled("mean", "unit=s").printed() == "(0.12346 ± 0.00013) s");
  BOOST_TEST(styled("fraction", "unit=percent").printed() == "(12.346 ± 0.013) %");
  BOOST_TEST(styled("fraction", "digits=2").printed() == "0.12");
  BOOST_TEST(styled("mean", "unit=ms,format=significant,digits=2").printed() == "1.2e2 ms");
}

BOOST_AUTO_TEST_CASE(a_standard_uncertainty_stays_beside_its_number) {
  // 1 psi are 6.894757 kPa
  BOOST_TEST(styled("load", "unit=kPa").printed() == "6.85(15)e3 kPa");
  BOOST_TEST(styled("sides", "unit=MPa").printed() == "(6.85 +0.15 −0.13) MPa");
  BOOST_TEST(styled("load", "digits=1").printed() == "1e3 psi");
  BOOST_TEST(styled("load-by-kind", "unit=MPa").printed() ==
             "(6.851 ± 0.061 (calibration) ± 0.138 (statistics)) MPa");
  BOOST_TEST(refusal("load-by-kind", "digits=3").starts_with("993.63 is printed as '994 psi'"));
}

BOOST_AUTO_TEST_CASE(the_rounding_of_a_conversion_costs_no_digit) {
  BOOST_TEST(styled("transfer", "unit=W/m2/K").printed() == "2.500 W/(m² K)");
  BOOST_TEST(styled("transfer", "unit=mW/m2/K").printed() == "2500 mW/(m² K)");
  BOOST_TEST(styled("transfer", "unit=kW/m2/K").printed() == "0.002500 kW/(m² K)");
  BOOST_TEST(styled("tiny", "unit=mm").printed() == "(2500.0000000000000 ± 0.0000000000022) mm");
}

BOOST_AUTO_TEST_CASE(a_value_has_the_digits_that_its_error_supports_in_the_other_unit) {
  BOOST_TEST(styled("work", "unit=J").printed() == "13 J");
  BOOST_TEST(styled("work", "unit=mJ").printed() == "1.3e4 mJ");
  BOOST_TEST(styled("work", "unit=ft.lbf").printed() == "9 ft lbf");
  BOOST_TEST(styled("torque", "unit=mJ").printed() == "1.3e4 mJ");
}

BOOST_AUTO_TEST_CASE(an_exact_value_has_all_its_digits_in_another_unit_or_as_many_as_before) {
  BOOST_TEST(styled("mile", "unit=km").printed() == "3.218688 km");
  BOOST_TEST(styled("mile", "unit=km,digits=17").printed() == "3.2186880000000000 km");
  BOOST_TEST(styled("mile", "unit=km,decimals=8").printed() == "3.21868800 km");
  BOOST_TEST(styled("rod", "digits=17").printed() == "39.400000000000000 in");
  BOOST_TEST(styled("speed", "unit=mi/h").printed() == "9.32 mi/h");
  BOOST_TEST(styled("slow", "unit=mi/h").printed() == "3.11 mi/h");
  BOOST_TEST(styled("slow", "unit=mi/h,digits=9").printed() == "3.10685596 mi/h");
  BOOST_TEST(styled("track", "unit=nmile").printed() == "1.737952 nmile");
  BOOST_TEST(styled("track", "unit=mi").printed() == "2 mi");
  BOOST_TEST(styled("pressure", "unit=Pa").printed() == "6.89e5 Pa");
  BOOST_TEST(styled("integral", "unit=ms").printed() == "2346 ms");
}

BOOST_AUTO_TEST_CASE(maxdigits_prints_no_more_than_the_error_supports) {
  BOOST_TEST(styled("period", "maxdigits=3").printed() == "2.35 s");
  BOOST_TEST(styled("period", "maxdigits=9").printed() == "2.3457 s");
  BOOST_TEST(styled("period", "maxdigits=9,unit=ms").printed() == "2345.7 ms");
  BOOST_TEST(styled("mean", "maxdigits=2").printed() == "0.12 s");
  BOOST_TEST(styled("rounding", "maxdigits=4").printed() == "2.3e-15");
  BOOST_TEST(styled("rod", "maxdigits=2").printed() == "39 in");
  BOOST_TEST(styled("rod", "maxdigits=9").printed() == "39.4 in");
  BOOST_TEST(styled("share", "format=percent,maxdigits=2").printed() == "12 %");
  BOOST_TEST(refusal("period", "maxdigits=2,digits=2") ==
             "maxdigits goes with format=significant, scientific and percent alone");
}

BOOST_AUTO_TEST_CASE(a_bound_is_rounded_up_in_every_style) {
  BOOST_TEST(styled("error", "digits=2").printed() == "7.5e-4 in");
  BOOST_TEST(styled("error", "unit=mm").printed() == "2e-2 mm");
  BOOST_TEST(styled("error", "format=fixed,decimals=4").printed() == "0.0008 in");
}

BOOST_AUTO_TEST_CASE(digits_that_are_not_earned_are_refused) {
  BOOST_TEST(refusal("period", "digits=6") ==
             "2.3456789 is printed as '2.34568 s', more digits than an error of 2e-05 supports");
  BOOST_TEST(holds(refusal("period", "unit=ms,digits=7"), "more digits than an error of 0.02"));
  BOOST_TEST(holds(refusal("share", "decimals=3"), "more digits"));
  BOOST_TEST(holds(refusal("error", "digits=3"), "more digits"));
  BOOST_TEST(
      refusal("rounding", "digits=3") ==
      "'2.34e-15' has more digits than the value, which has no error bound, is printed with");
  BOOST_TEST(styled("rounding", "digits=1").printed() == "2e-15");
}

BOOST_AUTO_TEST_CASE(what_cannot_be_done_is_refused_with_what_can) {
  BOOST_TEST(refusal("period", "digits=40") == "digits = 40: must be a whole number from 1 to 17");
  BOOST_TEST(refusal("period", "digits=0") == "digits = 0: must be a whole number from 1 to 17");
  BOOST_TEST(refusal("period", "decimals=x") ==
             "decimals = x: must be a whole number from 0 to 17");
  BOOST_TEST(refusal("period", "digit=3") ==
             "unknown option 'digit': must be one of digits, decimals, maxdigits, format, unit");
  BOOST_TEST(refusal("period", "digits") ==
             "option 'digits' has no value, as digits=3, format=percent and unit=mm have");
  BOOST_TEST(refusal("share", "percent,decimals=1") ==
             "option 'percent' has no value, as digits=3, format=percent and unit=mm have");
  BOOST_TEST(refusal("period", "digits=3,digits=2") == "option 'digits' is given twice");
  BOOST_TEST(refusal("period", "digits=3,decimals=2") ==
             "digits and decimals cannot both be given");
  BOOST_TEST(refusal("period", "format=fixed,digits=2") ==
             "format=fixed takes decimals, not digits");
  BOOST_TEST(refusal("period", "format=scientific,decimals=2") ==
             "decimals go with format=fixed and percent: say digits");
  BOOST_TEST(refusal("period", "format=percent") == "format = percent: the value has the unit s");
  BOOST_TEST(refusal("period", "format=round") ==
             "format = round: must be one of fixed, significant, scientific, percent, uncertain");
  BOOST_TEST(refusal("count", "format=uncertain") == "format=uncertain needs an error");
  BOOST_TEST(refusal("period", "unit=mm") == "unit = mm: \"s\" cannot be converted into \"mm\"");
  BOOST_TEST(
      refusal("period", "unit=furlonk").starts_with("unit 'furlonk': UDUNITS-2 does not know"));
  BOOST_TEST(refusal("heat", "unit=K") ==
             "unit = K: \"degC\" and \"K\" count from different zeros, and only a factor converts "
             "units: give the number in \"K\"");
}

BOOST_AUTO_TEST_CASE(the_prose_gets_a_definition_for_each_variant_it_uses) {
  const Restyled found = of_text(
      "\\val[digits=3]{period} \\val{width} \\val[unit=mm]{width}\n% \\val[digits=1]{width}\n"
      "\\val[digits=3]{period} \\val[format=fixed,\n  decimals=2]{period}\\rawval[unit=mm]{width}"
      "\\rawval[unit=percent]{tie}\\rawval[unit=percent]{share}\\rawval[unit=ppm]{share}");

  BOOST_TEST(found.errors.empty());
  BOOST_TEST(found.latex ==
             "\\LiterateRestyledRaw{share}{[unit=percent]}{12.3456}\n"
             "\\LiterateRestyledRaw{share}{[unit=ppm]}{123456}\n"
             "\\LiterateRestyledRaw{tie}{[unit=percent]}{12.5}\n"
             "\\LiterateRestyledRaw{width}{[unit=mm]}{0.254}\n"
             "\\LiterateRestyled{period}{[digits=3]}{\\qty{2.35}{s}}{2.35 s}\n"
             "\\LiterateRestyled{period}{[format=fixed, decimals=2]}{\\qty{2.35}{s}}{2.35 s}\n"
             "\\LiterateRestyled{width}{[unit=mm]}{\\qty{0.254}{mm}}{0.254 mm}\n");
}

BOOST_AUTO_TEST_CASE(errors_have_the_place_in_the_prose) {
  const Restyled found = of_text(
      "a\n é \\val[digits=40]{period}\\val[digits=2]{word}\\rawval[digits=2]{width}"
      "\\val[digits=2]{unknown}");

  const std::vector<std::string> expected = {
      "paper/a.tex:2:4: \\val[digits=40]{period}: digits = 40: must be a whole number from 1 to 17",
      "paper/a.tex:2:27: \\val[digits=2]{word}: the value is a text, which has no other style",
      "paper/a.tex:2:47: \\rawval[digits=2]{width}: unknown option 'digits': must be one of unit, "
      "since \\rawval gives the unrounded number"};
  BOOST_TEST(found.errors == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
