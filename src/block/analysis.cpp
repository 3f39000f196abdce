// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/analysis.hpp"

#include <cmath>
#include <utility>

namespace block {
namespace {

numerics::Estimate compare(double fine, double coarse) {
  return {fine, std::abs(fine - coarse)};
}

std::shared_ptr<const Model> mesh_and_condense(const Rectangle& block,
                                               const elasticity::Material& material,
                                               const std::vector<elasticity::Load>& loads,
                                               const Discretization& discretization) {
  return std::make_shared<const Model>(graded_mesh(block, loads, discretization), material,
                                       discretization.max_megabytes);
}

}  // namespace

RefinedSolution::RefinedSolution(Solution fine, Solution coarse)
    : fine_(std::move(fine)), coarse_(std::move(coarse)) {}

RefinedSolution RefinedSolution::combination(const std::vector<RefinedSolution>& solutions,
                                             const std::vector<double>& factors) {
  std::vector<Solution> fine;
  std::vector<Solution> coarse;
  for (const RefinedSolution& solution : solutions) {
    fine.push_back(solution.fine_);
    coarse.push_back(solution.coarse_);
  }
  return {Solution::combination(fine, factors), Solution::combination(coarse, factors)};
}

numerics::Estimate RefinedSolution::displacement_z(double x, double z) const {
  return compare(fine_.displacement(x, z).y(), coarse_.displacement(x, z).y());
}

std::vector<MeasureEstimate> RefinedSolution::measures(const MeasureOptions& options) const {
  const std::vector<Measure> fine = block::measures(fine_, options);
  const std::vector<Measure> coarse = block::measures(coarse_, options);
  MeasureOptions every_second = options;
  every_second.plotting_grid = std::max(1, options.plotting_grid / 2);
  const std::vector<Measure> sparse = block::measures(fine_, every_second);
  std::vector<MeasureEstimate> estimates;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    numerics::Estimate value = compare(fine[i].value, coarse[i].value);
    value.abs_error += std::abs(fine[i].value - sparse[i].value);
    estimates.push_back({fine[i].name, value});
  }
  return estimates;
}

SupportedBlock::SupportedBlock(std::shared_ptr<const Model> fine,
                               std::shared_ptr<const Model> coarse, const Supports& supports)
    : fine_(std::move(fine), supports), coarse_(std::move(coarse), supports) {}

RefinedSolution SupportedBlock::solve(const elasticity::Load& load) const {
  return {fine_.solve(load), coarse_.solve(load)};
}

Analysis::Analysis(const Rectangle& block, const elasticity::Material& material,
                   const std::vector<elasticity::Load>& loads,
                   const Discretization& discretization) {
  require_valid(discretization);
  fine_ = mesh_and_condense(block, material, loads, discretization);
  coarse_ = mesh_and_condense(block, material, loads, coarser(discretization));
}

SupportedBlock Analysis::on(const Supports& supports) const {
  return {fine_, coarse_, supports};
}

}  // namespace block
