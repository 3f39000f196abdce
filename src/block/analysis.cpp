// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/analysis.hpp"

#include <cmath>
#include <utility>

#include "block/solution.hpp"

namespace block {
namespace {

template <class T, class F>
auto each(const Levels<T>& levels, F of) {
  return Levels<decltype(of(levels[0]))>{of(levels[0]), of(levels[1]), of(levels[2])};
}

numerics::Estimate estimate(double fine, double coarse, double coarser) {
  constexpr double unbalanced = 1e-10;  // the greatest part of the load that a solution leaves
  return {fine,
          std::abs(fine - coarse) + std::abs(coarse - coarser) / 2 + unbalanced * std::abs(fine)};
}

}  // namespace

RefinedSolution::RefinedSolution(Levels<Solution> levels, std::vector<Disc> left_out)
    : levels_(std::move(levels)), left_out_(std::move(left_out)) {}

numerics::Estimate RefinedSolution::displacement_z(double x, double z) const {
  const auto [fine, coarse, coarser] =
      each(levels_, [&](const Solution& solution) { return solution.displacement(x, z).y(); });
  return estimate(fine, coarse, coarser);
}

std::vector<MeasureEstimate> RefinedSolution::measures(
    const std::vector<double>& surface_points) const {
  const auto [fine, coarse, coarser] = each(levels_, [&](const Solution& solution) {
    return block::measures(solution, left_out_, surface_points);
  });
  std::vector<MeasureEstimate> estimates;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    estimates.push_back({fine[i].name, estimate(fine[i].value, coarse[i].value, coarser[i].value)});
  }
  return estimates;
}

SupportedBlock::SupportedBlock(const Rectangle& block,
                               const Levels<std::shared_ptr<const Model>>& models,
                               const Supports& supports)
    : block_(block),
      supports_(supports),
      levels_(each(models, [&](const auto& model) { return Factorization(model, supports); })) {}

RefinedSolution SupportedBlock::solve(const elasticity::Load& load) const {
  return {each(levels_, [&](const Factorization& f) { return f.solve(load); }),
          discs_without_limit(block_, supports_, load)};
}

Analysis::Analysis(const Rectangle& block, const elasticity::Material& material,
                   const std::vector<elasticity::Load>& loads, const Discretization& discretization)
    : block_(block) {
  require_valid(discretization);
  Discretization level = discretization;
  for (std::shared_ptr<const Model>& model : levels_) {
    model = std::make_shared<const Model>(graded_mesh(block, loads, level), material);
    level = coarser(level);
  }
}

}  // namespace block
