// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/contact_options.hpp"

#include <limits>

#include "app/csv_files.hpp"
#include "line_contact/power_law.hpp"
#include "line_contact/rounded_punch.hpp"
#include "line_contact/wedge.hpp"
#include "system/require.hpp"

namespace app {
namespace {

ChosenProfile wedge(const ChoiceOption& given, double modulus, std::optional<double> load) {
  const double slope = given.number("--slope");
  ChosenProfile chosen{line_contact::Profile::wedge(slope), {}};
  if (load) {
    chosen.closed_form = closed_form("wedge", line_contact::Wedge(modulus, slope, *load),
                                     std::numeric_limits<double>::infinity());
  }
  return chosen;
}

ChosenProfile rounded_punch(const ChoiceOption& given, double modulus, std::optional<double> load) {
  const double flat = given.number("--flat");
  const double curvature = 1 / sys::require_positive("edge-radius", given.number("--edge-radius"));
  ChosenProfile chosen{line_contact::Profile::rounded_punch(flat, curvature), {}};
  if (load) {
    const line_contact::RoundedPunch punch(modulus, flat, curvature, *load);
    chosen.closed_form = closed_form("rounded-punch", punch, punch.peak_pressure());
  }
  return chosen;
}

ChosenProfile power_law(const ChoiceOption& given, double modulus, std::optional<double> load) {
  const int n = given.integer("--power", 1, line_contact::Profile::max_power);
  const double coefficient = given.number("--coefficient");
  ChosenProfile chosen{line_contact::Profile::power_law(coefficient, n), {}};
  if (load) {
    const line_contact::PowerLaw power(modulus, coefficient, n, *load);
    chosen.closed_form = closed_form("power", power, power.peak_pressure());
  }
  return chosen;
}

// From a CSV file: x and the gap h there, in the unit of length of the case.
ChosenProfile measured(const ChoiceOption& given, double /*modulus*/,
                       std::optional<double> /*load*/) {
  const CsvColumns points = read_curve(given.argument(), "x", "gap", 4);
  return {line_contact::Profile::tabulated(points.first, points.second)};
}

}  // namespace

const std::vector<ProfileChoice>& profile_choices() {
  static const std::vector<ProfileChoice> choices = {
      {{"cylinder"}, nullptr},
      {{"wedge", "", {{"--slope", "Wedge: tangent of the angle between face and surface"}}}, wedge},
      {{"rounded-punch",
        "",
        {{"--flat", "Rounded punch: half-width of its flat"},
         {"--edge-radius", "Rounded punch: radius of its edges"}}},
       rounded_punch},
      {{"power",
        "",
        {{"--power", "Power law A x^2n: n"}, {"--coefficient", "Power law A x^2n: A"}}},
       power_law},
      {{"file", "PATH"}, measured}};
  return choices;
}

}  // namespace app
