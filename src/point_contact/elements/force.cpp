// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/interior.hpp"

#include <cmath>
#include <numbers>

#include "system/require.hpp"

namespace point_contact {

InteriorField field_of_force(double force, const elasticity::Material& material,
                             const Eigen::Vector3d& at) {
  const double z = at.z();
  sys::require_positive("z", z);
  const Vector2 d = at.head<2>();
  const double nu = material.poisson();
  const double shear_modulus = material.young() / (2 * (1 + nu));
  const double rho = at.norm();
  const double rho3 = rho * rho * rho;
  const double rho5 = rho3 * rho * rho;
  const double sum = rho + z;

  InteriorField field;
  field.displacement.head<2>() = (z / rho3 - (1 - 2 * nu) / (rho * sum)) * d;
  field.displacement.z() = z * z / rho3 + 2 * (1 - nu) / rho;
  field.displacement *= force / (4 * std::numbers::pi * shear_modulus);

  const double along = (1 - 2 * nu) * (z / rho3 - 1 / (rho * sum));
  const double across = (1 - 2 * nu) * (2 * rho + z) / (rho3 * sum * sum) - 3 * z / rho5;
  field.stress.topLeftCorner<2, 2>() =
      along * Eigen::Matrix2d::Identity() + across * d * d.transpose();
  field.stress.topRightCorner<2, 1>() = -3 * z * z / rho5 * d;
  field.stress.bottomLeftCorner<1, 2>() = field.stress.topRightCorner<2, 1>().transpose();
  field.stress(2, 2) = -3 * z * z * z / rho5;
  field.stress *= force / (2 * std::numbers::pi);
  return field;
}

}  // namespace point_contact
