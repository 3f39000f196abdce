// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/profile_choices.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "contact/power_law.hpp"
#include "contact/rounded_punch.hpp"
#include "contact/wedge.hpp"
#include "system/require.hpp"

namespace app {
namespace {

ChosenProfile wedge(const ProfileNumbers& numbers, double modulus, std::optional<double> load) {
  const double slope = numbers.number("--slope");
  ChosenProfile chosen{contact::Profile::wedge(slope), {}};
  if (load) {
    chosen.closed_form = closed_form("wedge", contact::Wedge(modulus, slope, *load),
                                     std::numeric_limits<double>::infinity());
  }
  return chosen;
}

ChosenProfile rounded_punch(const ProfileNumbers& numbers, double modulus,
                            std::optional<double> load) {
  const double flat = numbers.number("--flat");
  const double curvature =
      1 / sys::require_positive("edge-radius", numbers.number("--edge-radius"));
  ChosenProfile chosen{contact::Profile::rounded_punch(flat, curvature), {}};
  if (load) {
    const contact::RoundedPunch punch(modulus, flat, curvature, *load);
    chosen.closed_form = closed_form("rounded-punch", punch, punch.peak_pressure());
  }
  return chosen;
}

ChosenProfile power_law(const ProfileNumbers& numbers, double modulus, std::optional<double> load) {
  const int n = numbers.integer("--power", 1, contact::Profile::max_power);
  const double coefficient = numbers.number("--coefficient");
  ChosenProfile chosen{contact::Profile::power_law(coefficient, n), {}};
  if (load) {
    const contact::PowerLaw power(modulus, coefficient, n, *load);
    chosen.closed_form = closed_form("power", power, power.peak_pressure());
  }
  return chosen;
}

}  // namespace

const std::vector<ProfileChoice>& profile_choices() {
  static const std::vector<ProfileChoice> choices = {
      {"wedge", {{"--slope", "Wedge: tangent of the angle between face and surface"}}, wedge},
      {"rounded-punch",
       {{"--flat", "Rounded punch: half-width of its flat"},
        {"--edge-radius", "Rounded punch: radius of its edges"}},
       rounded_punch},
      {"power",
       {{"--power", "Power law A x^2n: n"}, {"--coefficient", "Power law A x^2n: A"}},
       power_law}};
  return choices;
}

ProfileNumbers::ProfileNumbers(CLI::App& command) {
  for (const ProfileChoice& choice : profile_choices()) {
    for (const auto& [flag, help] : choice.flags) {
      options_.push_back(std::make_unique<NumberOption>(command, flag, help));
    }
  }
}

const NumberOption& ProfileNumbers::option(const std::string& flag) const {
  const auto found = std::ranges::find(options_, flag, [](const auto& it) { return it->flag(); });
  if (found == options_.end()) throw std::logic_error("no profile has the flag " + flag);
  return **found;
}

double ProfileNumbers::number(const std::string& flag) const {
  const auto number = option(flag).number();
  if (!number) throw sys::InputError(flag + " is missing");
  return *number;
}

int ProfileNumbers::integer(const std::string& flag, int least, int most) const {
  const auto integer = option(flag).integer();
  if (!integer) throw sys::InputError(flag + " is missing");
  if (*integer < least || *integer > most) {
    throw sys::InputError(
        fmt::format("{} = {}: must be from {} to {}", flag, *integer, least, most));
  }
  return static_cast<int>(*integer);
}

void ProfileNumbers::refuse_flags_of_others(const std::string& profile) const {
  for (const ProfileChoice& choice : profile_choices()) {
    for (const auto& [flag, help] : choice.flags) {
      if (choice.name == profile || option(flag).text().empty()) continue;
      throw sys::InputError(fmt::format("{} has no meaning for --profile {}", flag, profile));
    }
  }
}

}  // namespace app
