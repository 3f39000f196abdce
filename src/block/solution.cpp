// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/solution.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace block {

Abscissae::Abscissae(const LobattoBasis& basis, const Eigen::VectorXd& xi)
    : points(xi), values(basis.values_at(xi)), derivatives(basis.derivatives_at(xi)) {}

Solution::Solution(std::shared_ptr<const Model> model, Eigen::VectorXd displacements,
                   const Eigen::VectorXd& load)
    : model_(std::move(model)),
      displacements_(std::move(displacements)),
      strain_energy_(displacements_.dot(load) / 2),
      applied_(load.reshaped(2, load.size() / 2).rowwise().sum()) {}

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

namespace {

// The kind of extreme: the greatest magnitude, the greatest value or the least value.
enum class Extreme { magnitude, greatest, least };

struct Quantity {
  const char* name;
  Extreme extreme;
  bool is_stress;
};

constexpr std::array<Quantity, 11> quantities = {{
    {"max_disp_mag", Extreme::greatest, false},
    {"max_disp_x", Extreme::magnitude, false},
    {"max_disp_y", Extreme::magnitude, false},
    {"max_prin_mag", Extreme::magnitude, true},
    {"max_stress_prin", Extreme::greatest, true},
    {"max_stress_vm", Extreme::greatest, true},
    {"max_stress_xx", Extreme::magnitude, true},
    {"max_stress_xy", Extreme::magnitude, true},
    {"max_stress_yy", Extreme::magnitude, true},
    {"max_stress_zz", Extreme::magnitude, true},
    {"min_stress_prin", Extreme::least, true},
}};

// The quantities at one point. Here z points down and y out of the plane; in Appendix 2 y points up
// and z out of the plane, so the shear changes sign.
std::array<double, quantities.size()> values_of(const PointState& state, double nu) {
  const elasticity::Stress& s = state.stress;
  const auto principal = s.principal(nu);
  const double greatest = principal.front();
  const double least = principal.back();
  return {state.displacement.norm(),
          state.displacement.x(),
          -state.displacement.y(),
          std::abs(greatest) > std::abs(least) ? greatest : least,
          greatest,
          s.von_mises(nu),
          s.xx,
          -s.xz,
          s.zz,
          s.yy(nu),
          least};
}

double rank_of(Extreme extreme, double value) {
  if (extreme == Extreme::magnitude) return std::abs(value);
  return extreme == Extreme::greatest ? value : -value;
}

struct Best {
  double value = 0;
  double rank = -std::numeric_limits<double>::infinity();
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Eigen::Vector2d spacing = Eigen::Vector2d::Zero();  // of the samples around it
};

class Search {
 public:
  Search(const Solution& solution, const std::vector<Disc>& left_out)
      : solution_(solution), left_out_(left_out), nu_(solution.model().material().poisson()) {}

  std::vector<Measure> maxima() {
    sample_elements();
    for (const Disc& disc : left_out_) sample_circle(disc);
    std::vector<Measure> list;
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      climb(q);
      list.push_back({quantities[q].name, best_[q].value});
    }
    return list;
  }

 private:
  bool is_left_out(const Eigen::Vector2d& position) const {
    return std::any_of(left_out_.begin(), left_out_.end(),
                       [&](const Disc& disc) { return disc.holds(position); });
  }

  // Keeps the state if it is better. The two sides of a symmetric block agree to rounding; taking
  // the left one keeps the sign of an antisymmetric quantity independent of rounding.
  void offer(const PointState& state, const Eigen::Vector2d& spacing) {
    const bool has_stress = !is_left_out(state.position);
    const auto values = values_of(state, nu_);
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      if (quantities[q].is_stress && !has_stress) continue;
      const double rank = rank_of(quantities[q].extreme, values[q]);
      const double gain = rank - best_[q].rank;
      const double margin = 1e-6 * std::abs(rank);
      if (gain > margin || (gain > -margin && state.position.x() < best_[q].position.x())) {
        best_[q] = {values[q], rank, state.position, spacing};
      }
    }
  }

  void sample_elements() {
    constexpr int n_intervals = 10;
    const Model& model = solution_.model();
    const Abscissae grid(model.basis(), Eigen::VectorXd::LinSpaced(n_intervals + 1, -1, 1));
    for (Index index = 0; index < model.mesh().n_elements(); ++index) {
      const Element e = model.mesh().element(index);
      const Eigen::Vector2d spacing(e.width() / n_intervals, e.height() / n_intervals);
      for (const PointState& state : solution_.sample(index, grid, grid)) offer(state, spacing);
    }
  }

  void sample_circle(const Disc& disc) {
    constexpr int n_points = 800;
    for (int i = 0; i < n_points; ++i) {
      // Between the axes: on the line between two elements the stress is that of the right one,
      // which would make the two sides of a symmetric block differ.
      const double angle = 2 * std::numbers::pi * (i + 0.5) / n_points;
      const double outside = disc.radius * (1 + 1e-12);
      const Eigen::Vector2d position(disc.x + outside * std::cos(angle),
                                     disc.z + outside * std::sin(angle));
      if (const auto state = state_at(position))
        offer(*state, {disc.radius / 10, disc.radius / 10});
    }
  }

  std::optional<PointState> state_at(const Eigen::Vector2d& position) const {
    const Mesh& mesh = solution_.model().mesh();
    const bool is_inside =
        position.x() >= mesh.x_lines().front() && position.x() <= mesh.x_lines().back() &&
        position.y() >= mesh.z_lines().front() && position.y() <= mesh.z_lines().back();
    if (!is_inside) return std::nullopt;
    return solution_.at(position.x(), position.y());
  }

  // Moves from the best point to a better neighbour while there is one, in ever smaller steps.
  void climb(std::size_t q) {
    Best& best = best_[q];
    for (double size = 0.5; size > 1e-3;) {
      Best next = best;
      for (const Eigen::Vector2d& direction : {Eigen::Vector2d{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const auto state = state_at(best.position + size * direction.cwiseProduct(best.spacing));
        if (!state || (quantities[q].is_stress && is_left_out(state->position))) continue;
        const double value = values_of(*state, nu_)[q];
        const double rank = rank_of(quantities[q].extreme, value);
        if (rank > next.rank) next = {value, rank, state->position, best.spacing};
      }
      if (next.rank > best.rank)
        best = next;
      else
        size /= 2;
    }
  }

  const Solution& solution_;
  const std::vector<Disc>& left_out_;
  double nu_;
  std::array<Best, quantities.size()> best_;
};

}  // namespace

std::vector<Measure> measures(const Solution& solution, const std::vector<Disc>& left_out,
                              const std::vector<double>& surface_points) {
  std::vector<Measure> list = Search(solution, left_out).maxima();
  list.insert(list.begin(), {"resultant_load_y", -solution.applied().y()});
  list.push_back({"strain_energy", solution.strain_energy()});
  for (std::size_t i = 0; i < surface_points.size(); ++i) {
    const double u_z = solution.displacement(surface_points[i], 0).y();
    list.push_back({fmt::format("measure{}", i + 1), -u_z});
  }
  return list;
}

}  // namespace block
