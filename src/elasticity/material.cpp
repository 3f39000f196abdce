// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/material.hpp"

#include <numbers>

#include "system/require.hpp"

namespace elasticity {

Material::Material(double young, double poisson)
    : young_(sys::require_positive("young", young)), poisson_(poisson) {
  if (!(poisson > -1 && poisson < 0.5)) {
    throw sys::InvalidQuantity("poisson", poisson, "between -1 and 0.5, both excluded");
  }
}

double Material::integral_compliance() const {
  return 2 * (1 - poisson_ * poisson_) / (std::numbers::pi * young_);
}

double Material::local_compliance() const {
  return (1 - 2 * poisson_) * (1 + poisson_) / young_;
}

double contact_modulus(const Material& first, const Material& second) {
  const auto compliance = [](const Material& m) {
    return (1 - m.poisson() * m.poisson()) / m.young();
  };
  return 1 / (compliance(first) + compliance(second));
}

double dundurs_beta(const Material& first, const Material& second) {
  const double difference = first.local_compliance() - second.local_compliance();
  return difference / 2 * contact_modulus(first, second);
}

}  // namespace elasticity
