// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/point_contact_options.hpp"

#include "app/csv_files.hpp"
#include "system/require.hpp"

namespace app {
namespace {

using point_contact::Profile;

ChosenBody measured_gaps(const ChoiceOption& given, const Pressing& /*pressing*/) {
  const double spacing = sys::require_positive("spacing", given.number("--spacing"));
  return {Profile::height_map(read_grid(given.argument()), spacing)};
}

ChosenBody measured_heights(const ChoiceOption& given, const Pressing& /*pressing*/) {
  const double spacing = sys::require_positive("spacing", given.number("--spacing"));
  const auto heights = read_grid(given.argument());
  return {Profile::height_map(heights.maxCoeff() - heights, spacing)};
}

}  // namespace

const std::vector<BodyChoice>& body_choices() {
  const ChoiceFlag spacing = {"--spacing", "Measured surface: distance between its points"};
  static const std::vector<BodyChoice> choices = {
      {{"sphere"},
       true,
       nullptr},
      {{"file", "PATH", {spacing}}, false, measured_gaps},
      {{"heights", "PATH", {spacing}}, false, measured_heights}};
  return choices;
}

}  // namespace app
