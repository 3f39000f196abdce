// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/load_contest.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "elasticity/load_shapes.hpp"
#include "numerics/least_squares.hpp"
#include "paper/prelude.hpp"

namespace paper {
namespace {

using block::RefinedSolution;
using block::Support;
using block::Supports;

// Every shape is 1 in the middle and falls to 0 at the ends of the load, where only the uniform
// pressure, the first of two, is left.
Measured largest_pressure(const std::vector<Measured>& factors) {
  Measured middle = 0;
  for (const Measured& factor : factors) middle = middle + factor;
  return middle.value() > factors.front().value() ? middle : factors.front();
}

// The misfit on one mesh.
struct MisfitOnOneMesh {
  double largest = 0;
  double largest_share = 0;
  double sum_of_squares = 0;

  MisfitOnOneMesh(const std::vector<double>& residuals, const std::vector<Measured>& ones) {
    for (std::size_t i = 0; i < ones.size(); ++i) {
      const double residual = std::abs(residuals[i]);
      const double standard = ones[i].standard();
      const double share = standard > 0 ? residual / standard : residual;
      largest = std::max(largest, residual);
      largest_share = std::max(largest_share, share);
      sum_of_squares += share * share;
    }
  }
};

Misfit on_both(const MisfitOnOneMesh& fine, const MisfitOnOneMesh& coarse) {
  const auto estimate = [&](double MisfitOnOneMesh::*which) {
    return Estimate{fine.*which, std::abs(fine.*which - coarse.*which)};
  };
  return {estimate(&MisfitOnOneMesh::largest), estimate(&MisfitOnOneMesh::largest_share),
          estimate(&MisfitOnOneMesh::sum_of_squares)};
}

Contestant fitted(const BlockStudy& study, std::string shape, const Supports& supports,
                  const std::vector<RefinedSolution>& solutions) {
  const block::Fit fine = block::fit_loads(solutions, study.observed());
  const block::Fit coarse = block::fit_coarse_loads(solutions, study.observed());
  const std::vector<Measured> ones = block::relative(study.observed());
  return {std::move(shape),
          static_cast<int>(solutions.size()),
          supports,
          on_both({fine.residuals, ones}, {coarse.residuals, ones}),
          largest_pressure(fine.factors),
          {fine.solution.fine(), coarse.solution.fine()}};
}

// The displacements at the observed points over those observed, for one load.
using Ratios = std::vector<double>;

Ratios ratios_of(const block::Solution& solution,
                 const std::vector<block::SurfaceDisplacement>& observed) {
  Ratios ratios;
  for (const block::SurfaceDisplacement& point : observed) {
    ratios.push_back(solution.displacement(point.x, 0).y() / point.u_z.value());
  }
  return ratios;
}

constexpr double narrower = 0.9;  // the half-width of a triangle over that of the load
}  // namespace

std::vector<Contestant> contest(const BlockStudy& study, const HalfSpaceCase& half_space,
                                Support sides) {
  const double a = half_space.load.half_width();
  const block::SupportedBlock& own = study.on(sides);
  const Supports own_supports = block::with_sides(sides);
  const RefinedSolution uniform = own.solve(elasticity::LinearFall(1, 1, a));
  struct Shape {
    std::string name;
    elasticity::Load load;
  };
  const Shape shapes[] = {
      {"triangle", elasticity::LinearFall(1, 0, a)},
      {"narrower triangle", elasticity::LinearFall(1, 0, narrower * a)},
      {"step", elasticity::LinearFall(1, 1, a / 2)},
      {"parabola",
       elasticity::distributed_load([a](double x) { return 1 - x * x / (a * a); }, {}, {-a, a})},
      {"root", elasticity::distributed_load(
                   [a](double x) { return 1 - std::sqrt(std::abs(x) / a); }, {}, {-a, 0, a})}};

  std::vector<Contestant> contestants;
  for (const Shape& shape : shapes) {
    const RefinedSolution solution = own.solve(shape.load);
    if (contestants.empty()) {
      contestants.push_back(fitted(study, shape.name + " alone", own_supports, {solution}));
      contestants.push_back(fitted(study, "uniform alone", own_supports, {uniform}));
    }
    contestants.push_back(
        fitted(study, "uniform + " + shape.name, own_supports, {uniform, solution}));
  }

  const auto add = [&](const Supports& supports) {
    if (supports == own_supports) return;
    const block::SupportedBlock block = study.on(supports);
    contestants.push_back(fitted(study, "uniform + triangle", supports,
                                 {block.solve(elasticity::LinearFall(1, 1, a)),
                                  block.solve(elasticity::LinearFall(1, 0, a))}));
  };
  for (const Support other : {Support::clamped, Support::roller, Support::free}) {
    add(block::with_sides(other));
  }
  for (const Support other : {Support::clamped, Support::roller}) {
    add({.left = other, .right = other, .bottom = Support::roller});
  }
  return contestants;
}

elasticity::Load round_load(const HalfSpaceCase& half_space) {
  return elasticity::LinearFall(half_space.load.peak_pressure(), round_edge_share,
                                 half_space.load.half_width());
}

Contestant unfitted(const BlockStudy& study, const std::string& shape, const elasticity::Load& load,
                    double peak, Support sides) {
  const RefinedSolution solution = study.on(sides).solve(load);
  const std::vector<Measured> ones = block::relative(study.observed());
  const auto misfit = [&](const block::Solution& s) {
    Ratios residuals = ratios_of(s, study.observed());
    for (double& residual : residuals) residual -= 1;
    return MisfitOnOneMesh(residuals, ones);
  };
  return {shape,
          0,
          block::with_sides(sides),
          on_both(misfit(solution.fine()), misfit(solution.coarse())),
          peak,
          solution};
}

}  // namespace paper
