// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/block_study.hpp"

#include "elasticity/loads.hpp"
#include "paper/conventions.hpp"

namespace paper {
namespace {

block::Analysis analysis_of(const HalfSpaceCase& half_space, const BlockCase& block_case) {
  return {block_case.rectangle, half_space.material, {half_space.load}, block_case.discretization};
}

}  // namespace

BlockStudy::BlockStudy(const HalfSpaceCase& half_space, const BlockCase& block_case)
    : half_space_(half_space),
      block_case_(block_case),
      analysis_(analysis_of(half_space, block_case)),
      own_(analysis_.on(block::with_sides(block_case.sides))),
      under_triangle_(own_.solve(half_space.load)) {}

Level BlockStudy::level(const std::string& name, const block::SupportedBlock& supported) const {
  const HalfSpaceCase& h = half_space_;
  const elasticity::UniformLoad uniform(1, h.load.half_width());
  const block::RefinedSolution of_triangle = supported.solve(h.load);
  const block::RefinedSolution of_uniform = supported.solve(uniform);
  const auto under_triangle = [&](double x) {
    return level(of_triangle, x).value / h.load.line_load();
  };
  const auto under_uniform = [&](double x) {
    return (normal_displacement(h.material, uniform, x, h.datum) -
            of_uniform.displacement_z(x, 0).value) /
           uniform.line_load();
  };
  const double a = h.load.half_width();
  Level level{
      name, {under_triangle(0), under_triangle(a), {}}, {under_uniform(0), under_uniform(a), {}}};
  for (const double x : h.points) {
    level.triangle.at_points.push_back(under_triangle(x));
    level.uniform.at_points.push_back(under_uniform(x));
  }
  return level;
}

block::RefinedSolution BlockStudy::enlarged(double factor) const {
  BlockCase larger = block_case_;
  larger.rectangle = {factor * block_case_.rectangle.width(),
                      factor * block_case_.rectangle.height()};
  return analysis_of(half_space_, larger)
      .on(block::with_sides(block_case_.sides))
      .solve(half_space_.load);
}

Estimate BlockStudy::level(const block::RefinedSolution& solution, double x) const {
  return displacement(half_space_, x) - solution.displacement_z(x, 0);
}

std::string name_of(block::Support sides) {
  if (sides == block::Support::clamped) return "clamped";
  return sides == block::Support::roller ? "roller" : "free";
}

}  // namespace paper
