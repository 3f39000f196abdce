// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/falling_pressure.hpp"

#include <cmath>
#include <numbers>

#include "elasticity/load_shapes.hpp"
#include "elasticity/stress.hpp"

namespace paper {
namespace {

constexpr int n_pieces = 80;

}  // namespace

FallingPressure::FallingPressure(const std::function<double(double)>& f, double middle, double end,
                                 double half_width)
    : f_(f), middle_(middle), end_(end), half_width_(half_width) {
  for (int k = 0; k <= n_pieces; ++k) {
    const double t = (1 - std::cos(std::numbers::pi * k / n_pieces)) / 2;
    nodes_.push_back(t * half_width);
    values_.push_back(end + (middle - end) * f(t));
  }
}

double FallingPressure::pressure(double x) const {
  return end_ + (middle_ - end_) * f_(std::abs(x) / half_width_);
}

double FallingPressure::line_load() const {
  double sum = 0;
  for (std::size_t k = 1; k < nodes_.size(); ++k) {
    sum += (nodes_[k] - nodes_[k - 1]) * (values_[k] + values_[k - 1]);
  }
  return sum;
}

double FallingPressure::second_moment() const {
  double sum = 0;
  for (std::size_t k = 1; k < nodes_.size(); ++k) {
    const double middle = (nodes_[k - 1] + nodes_[k]) / 2;  // Simpson's rule is exact for x² p
    sum +=
        (nodes_[k] - nodes_[k - 1]) / 3 *
        (std::pow(nodes_[k - 1], 2) * values_[k - 1] +
         2 * middle * middle * (values_[k - 1] + values_[k]) + std::pow(nodes_[k], 2) * values_[k]);
  }
  return sum / line_load();
}

double FallingPressure::displacement(const elasticity::Material& material, double x,
                                     double datum) const {
  double sum = values_.back() *
               normal_displacement(material, elasticity::UniformLoad(1, half_width_), x, datum);
  // A triangle of height w on |x| ≤ b adds −w/b to the slope on [0, b]. From the outermost piece
  // inwards, each triangle adds the slope still missing.
  double slope_so_far = 0;
  for (std::size_t k = nodes_.size() - 1; k > 0; --k) {
    const double slope = (values_[k] - values_[k - 1]) / (nodes_[k] - nodes_[k - 1]);
    const double height = (slope_so_far - slope) * nodes_[k];
    slope_so_far = slope;
    if (height == 0) continue;
    sum +=
        height * normal_displacement(material, elasticity::TriangularLoad(1, nodes_[k]), x, datum);
  }
  return sum;
}

double FallingPressure::work(const std::function<double(double)>& u) const {
  // Simpson's rule on each piece; both sides of the strip do the same work.
  double sum = 0;
  for (std::size_t k = 1; k < nodes_.size(); ++k) {
    const double middle = (nodes_[k - 1] + nodes_[k]) / 2;
    sum += (nodes_[k] - nodes_[k - 1]) / 6 *
           (values_[k - 1] * u(nodes_[k - 1]) + 2 * (values_[k - 1] + values_[k]) * u(middle) +
            values_[k] * u(nodes_[k]));
  }
  return sum;
}

double FallingPressure::largest_shear() const {
  std::vector<double> nodes, values;
  for (std::size_t k = nodes_.size() - 1; k > 0; --k) {
    nodes.push_back(-nodes_[k]);
    values.push_back(values_[k]);
  }
  nodes.insert(nodes.end(), nodes_.begin(), nodes_.end());
  values.insert(values.end(), values_.begin(), values_.end());
  const auto shear = [&](double x, double z) {
    return std::abs(elasticity::stress_beneath(nodes, values, x, z).xz);
  };

  // Beneath a jump at the end of the strip the shear stress tends to pressure/π. A greater one lies
  // beneath the end, at most a half-width deep.
  constexpr int n = 5;         // steps to either side
  constexpr double finer = 3;  // from one grid to the next
  double best = values_.back() / std::numbers::pi;
  double best_x = 0.75 * half_width_, best_z = 0.5 * half_width_;
  for (double step = half_width_ / (2.0 * n); step > 1e-4 * half_width_; step /= finer) {
    const double centre_x = best_x, centre_z = best_z;
    for (int i = -n; i <= n; ++i) {
      for (int j = -n; j <= n; ++j) {
        const double x = centre_x + i * step;
        const double z = centre_z + j * step;
        if (z <= 0) continue;
        const double here = shear(x, z);
        if (here <= best) continue;
        best = here;
        best_x = x;
        best_z = z;
      }
    }
  }
  return best;
}

elasticity::Load FallingPressure::load() const {
  return elasticity::distributed_load([*this](double x) { return pressure(x); },
                                      {-half_width_, 0, half_width_});
}

}  // namespace paper
