// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/point_contact_stress.hpp"

#include <fmt/core.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "command_line/number_text.hpp"
#include "point_contact/closed_forms/huber.hpp"
#include "point_contact/solver/beneath.hpp"

namespace app {
namespace {

// On the axis rr = tt, and the principal stresses are these and zz.
double max_shear_on_axis(const point_contact::AxialStress& s) {
  return std::abs(s.rr - s.zz) / 2;
}

}  // namespace

std::vector<StressBeneath> stresses_beneath(const PointContactInput& input,
                                            const point_contact::Solution& solution) {
  const elasticity::Material& material = input.is_second_body ? input.material2 : input.material1;
  std::vector<StressBeneath> stresses;
  for (const double z : input.depths) {
    const Eigen::Matrix3d s = point_contact::field_beneath(solution, material, {0, 0, z}).stress;
    const Eigen::Vector3d principal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(s, Eigen::EigenvaluesOnly).eigenvalues();
    const Eigen::Vector3d differences(principal[1] - principal[0], principal[2] - principal[1],
                                      principal[2] - principal[0]);
    StressBeneath at{.z = z,
                     .stress = s,
                     .max_shear = differences[2] / 2,
                     .von_mises = std::sqrt(differences.squaredNorm() / 2),
                     .huber_max_shear = {}};
    if (input.hertz) {
      at.huber_max_shear =
          max_shear_on_axis(point_contact::Huber(*input.hertz, material.poisson()).stress(0, z));
    }
    command_line::finite_result(fmt::format("stress at z = {}", z), at.von_mises);
    stresses.push_back(at);
  }
  return stresses;
}

nlohmann::ordered_json stresses_json(const std::vector<StressBeneath>& stresses) {
  auto json = nlohmann::ordered_json::array();
  for (const StressBeneath& at : stresses) {
    nlohmann::ordered_json entry = {{"z", at.z},
                                    {"stress_xx", at.stress(0, 0)},
                                    {"stress_yy", at.stress(1, 1)},
                                    {"stress_zz", at.stress(2, 2)},
                                    {"max_shear", at.max_shear},
                                    {"von_mises", at.von_mises}};
    if (at.huber_max_shear) entry["huber_max_shear"] = *at.huber_max_shear;
    json.push_back(std::move(entry));
  }
  return json;
}

std::string stresses_text(const std::vector<StressBeneath>& stresses,
                          const config::UnitSystem& units) {
  if (stresses.empty()) return "";
  const bool has_huber = stresses.front().huber_max_shear.has_value();
  const auto row = [&](auto&&... cells) {
    return fmt::format("{:>12}{:>14}{:>14}{:>14}{:>14}{:>14}", cells...);
  };
  const std::string unit = "[" + units.stress + "]";
  std::string text = row("depth", "stress xx", "stress yy", "stress zz", "max shear", "von Mises");
  text += has_huber ? "         Huber\n" : "\n";
  text += row("[" + units.length + "]", unit, unit, unit, unit, unit);
  text += has_huber ? "     max shear\n" : "\n";
  for (const StressBeneath& at : stresses) {
    const auto six = [](double number) { return fmt::format("{:.6g}", number); };
    text += row(six(at.z), six(at.stress(0, 0)), six(at.stress(1, 1)), six(at.stress(2, 2)),
                six(at.max_shear), six(at.von_mises));
    if (at.huber_max_shear) text += fmt::format("{:>14}", six(*at.huber_max_shear));
    text += '\n';
  }
  return text;
}

}  // namespace app
