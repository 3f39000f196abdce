// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/solution.hpp"

#include <utility>

namespace block {
namespace {

Eigen::Vector2d sum_of(const Eigen::VectorXd& forces) {
  return forces.reshaped(2, forces.size() / 2).rowwise().sum();
}

}  // namespace

Abscissae::Abscissae(const LobattoBasis& basis, const Eigen::VectorXd& xi)
    : points(xi), values(basis.values_at(xi)), derivatives(basis.derivatives_at(xi)) {}

Solution::Solution(std::shared_ptr<const Model> model, Eigen::VectorXd displacements,
                   const Eigen::VectorXd& load, const Eigen::VectorXd& reactions)
    : model_(std::move(model)),
      displacements_(std::move(displacements)),
      strain_energy_(displacements_.dot(load) / 2),
      applied_(sum_of(load)),
      reaction_(sum_of(reactions)) {}

PointState Solution::at(double x, double z) const {
  const LocalPoint point = model_->mesh().locate(x, z);
  const auto single = [&](double place) {
    return Abscissae(model_->basis(), Eigen::VectorXd::Constant(1, place));
  };
  return sample(point.element, single(point.xi), single(point.zeta)).front();
}

std::vector<PointState> Solution::sample(Index element, const Abscissae& xi,
                                         const Abscissae& zeta) const {
  // Evaluate the tensor product N_i(ξ) N_j(ζ), one direction after the other
  const Element e = model_->mesh().element(element);
  const Eigen::VectorXd local = displacements_(model_->unknowns(element));
  const Index n = model_->basis().order() + 1;
  Eigen::MatrixXd u[2];
  Eigen::MatrixXd du_dx[2];
  Eigen::MatrixXd du_dz[2];
  for (int c = 0; c < 2; ++c) {
    const Eigen::VectorXd component = local(Eigen::seqN(c, n * n, 2));
    const Eigen::MatrixXd along_x = xi.values * component.reshaped(n, n);
    u[c] = along_x * zeta.values.transpose();
    du_dx[c] =
        2 / e.width() * (xi.derivatives * component.reshaped(n, n)) * zeta.values.transpose();
    du_dz[c] = 2 / e.height() * along_x * zeta.derivatives.transpose();
  }

  const auto [lambda, mu] = model_->lame();
  std::vector<PointState> states;
  states.reserve(static_cast<std::size_t>(xi.points.size() * zeta.points.size()));
  for (Index l = 0; l < zeta.points.size(); ++l) {
    for (Index k = 0; k < xi.points.size(); ++k) {
      const double e_xx = du_dx[0](k, l);
      const double e_zz = du_dz[1](k, l);
      const double gamma = du_dz[0](k, l) + du_dx[1](k, l);
      states.push_back({{e.x0 + e.width() * (1 + xi.points[k]) / 2,
                         e.z0 + e.height() * (1 + zeta.points[l]) / 2},
                        {u[0](k, l), u[1](k, l)},
                        {lambda * (e_xx + e_zz) + 2 * mu * e_xx,
                         lambda * (e_xx + e_zz) + 2 * mu * e_zz, mu * gamma}});
    }
  }
  return states;
}

}  // namespace block
