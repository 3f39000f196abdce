// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/solution.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <utility>

namespace block {
namespace {

Resultant resultant_of(const Mesh& mesh, const Eigen::VectorXd& forces) {
  Resultant sum;
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    const Eigen::Vector2d force = forces.segment<2>(2 * node);
    const Eigen::Vector2d position = mesh.position(node);
    sum.force += force;
    sum.moment += position.y() * force.x() - position.x() * force.y();
  }
  return sum;
}

}  // namespace

Stress stress(const Lame& lame, const Strain& strain) {
  const double volumetric = lame.lambda * (strain.xx + strain.zz);
  return {volumetric + 2 * lame.mu * strain.xx, volumetric + 2 * lame.mu * strain.zz,
          lame.mu * strain.gamma, volumetric};
}

double von_mises(const Stress& s) {
  const double xz = s.xx - s.zz;
  const double zy = s.zz - s.yy;
  const double yx = s.yy - s.xx;
  return std::sqrt((xz * xz + zy * zy + yx * yx) / 2 + 3 * s.xz * s.xz);
}

std::array<double, 3> principal_stresses(const Stress& s) {
  const double centre = (s.xx + s.zz) / 2;
  const double radius = std::hypot((s.xx - s.zz) / 2, s.xz);
  std::array<double, 3> principal{centre + radius, centre - radius, s.yy};
  std::sort(principal.begin(), principal.end(), std::greater<>());
  return principal;
}

Solution::Solution(std::shared_ptr<const Model> model, Eigen::VectorXd displacements,
                   Eigen::VectorXd applied_forces, Eigen::VectorXd support_forces)
    : model_(std::move(model)),
      displacements_(std::move(displacements)),
      applied_forces_(std::move(applied_forces)),
      support_forces_(std::move(support_forces)) {}

Solution Solution::combination(const std::vector<Solution>& solutions,
                               const std::vector<double>& factors) {
  assert(!solutions.empty() && solutions.size() == factors.size());
  Solution sum = solutions.front();
  sum.displacements_ *= factors.front();
  sum.applied_forces_ *= factors.front();
  sum.support_forces_ *= factors.front();
  for (std::size_t k = 1; k < solutions.size(); ++k) {
    assert(solutions[k].model_ == sum.model_);
    sum.displacements_ += factors[k] * solutions[k].displacements_;
    sum.applied_forces_ += factors[k] * solutions[k].applied_forces_;
    sum.support_forces_ += factors[k] * solutions[k].support_forces_;
  }
  return sum;
}

Eigen::Vector2d Solution::displacement(double x, double z) const {
  return at(x, z).displacement;
}

PointState Solution::at(double x, double z) const {
  const LocalPoint point = model_->mesh().locate(x, z);
  return states(point.element, Eigen::VectorXd::Constant(1, point.xi),
                Eigen::VectorXd::Constant(1, point.zeta))
      .front();
}

std::vector<PointState> Solution::sample(Index element, const Eigen::VectorXd& points) const {
  return states(element, points, points);
}

std::vector<PointState> Solution::states(Index element, const Eigen::VectorXd& xi,
                                         const Eigen::VectorXd& zeta) const {
  const Element e = model_->mesh().element(element);
  const std::vector<Index> unknowns = model_->unknowns(element);
  const Eigen::VectorXd local = displacements_(unknowns);
  const Eigen::Index n = model_->basis().order() + 1;

  // Evaluate the tensor product N_i(ξ) N_j(ζ), one direction after the other
  const Eigen::MatrixXd n_x = model_->basis().values_at(xi);
  const Eigen::MatrixXd n_z = model_->basis().values_at(zeta);
  const Eigen::MatrixXd dn_x = model_->basis().derivatives_at(xi) * (2 / e.width());
  const Eigen::MatrixXd dn_z = model_->basis().derivatives_at(zeta) * (2 / e.height());
  Eigen::MatrixXd u[2];
  Eigen::MatrixXd du_dx[2];
  Eigen::MatrixXd du_dz[2];
  for (int c = 0; c < 2; ++c) {
    const Eigen::VectorXd component = local(Eigen::seqN(c, n * n, 2));
    const auto nodal = component.reshaped(n, n);
    u[c] = n_x * nodal * n_z.transpose();
    du_dx[c] = dn_x * nodal * n_z.transpose();
    du_dz[c] = n_x * nodal * dn_z.transpose();
  }

  std::vector<PointState> result;
  result.reserve(static_cast<std::size_t>(xi.size() * zeta.size()));
  for (Index l = 0; l < zeta.size(); ++l) {
    for (Index k = 0; k < xi.size(); ++k) {
      const Strain strain{du_dx[0](k, l), du_dz[1](k, l), du_dz[0](k, l) + du_dx[1](k, l)};
      result.push_back({{e.x0 + e.width() * (1 + xi[k]) / 2, e.z0 + e.height() * (1 + zeta[l]) / 2},
                        {u[0](k, l), u[1](k, l)},
                        strain,
                        stress(model_->lame(), strain)});
    }
  }
  return result;
}

double Solution::strain_energy() const {
  return displacements_.dot(model_->internal_forces(displacements_)) / 2;
}

Resultant Solution::applied() const {
  return resultant_of(model_->mesh(), applied_forces_);
}

Resultant Solution::reactions() const {
  return resultant_of(model_->mesh(), support_forces_);
}

}  // namespace block
