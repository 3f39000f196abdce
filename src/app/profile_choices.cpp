// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/contact_options.hpp"


#include "app/csv_files.hpp"

namespace app {
namespace {

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
      {{"file", "PATH"}, measured}};
  return choices;
}

}  // namespace app
