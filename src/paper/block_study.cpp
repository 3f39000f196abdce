// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/block_study.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "block/load_shapes.hpp"
#include "block/mass_properties.hpp"
#include "system/parallel.hpp"

namespace paper {
namespace {

using block::Support;

block::Analysis analysis_of(const parameters::HalfSpaceCase& half_space,
                            const parameters::BlockCase& block_case) {
  const double a = half_space.load.half_width();
  return {block_case.rectangle,
          half_space.material,
          {block::linear_fall(1, 0, a), block::trapezoid(1, flat_fraction, a)},
          block_case.discretization};
}

// The same fit on the coarser mesh alone.
block::Fit coarse_fit(const std::vector<block::RefinedSolution>& solutions,
                      const std::vector<block::SurfaceDisplacement>& observed) {
  std::vector<block::RefinedSolution> coarse;
  coarse.reserve(solutions.size());
  for (const block::RefinedSolution& s : solutions) coarse.emplace_back(s.coarse(), s.coarse());
  return block::fit_loads(coarse, observed);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

std::vector<block::SurfaceDisplacement> observed_in(const parameters::HalfSpaceCase& half_space,
                                                    const PrintedFigure5& printed) {
  std::vector<block::SurfaceDisplacement> observed;
  for (std::size_t i = 0; i < half_space.points.size(); ++i) {
    observed.push_back({half_space.points[i], printed.fea_z[i].value()});
  }
  return observed;
}

std::vector<std::pair<std::string, double>> mass_by_name(const parameters::BlockCase& block_case) {
  const block::MassProperties mass =
      block::mass_properties(block_case.rectangle, block_case.density);
  return {{"mass", mass.mass},
          {"centre_y", mass.centre_y},
          {"ixx_about_origin", mass.about_origin.ixx},
          {"iyy_about_origin", mass.about_origin.iyy},
          {"izz_about_origin", mass.about_origin.izz},
          {"ixx_about_centre", mass.about_centre.ixx},
          {"iyy_about_centre", mass.about_centre.iyy},
          {"izz_about_centre", mass.about_centre.izz}};
}

std::string name_of(Support sides) {
  if (sides == Support::clamped) return "clamped";
  return sides == Support::roller ? "roller" : "free";
}

BlockStudy::OnSides::OnSides(const block::Analysis& analysis, Support sides, double half_width)
    : block(analysis.on(block::with_sides(sides))),
      falls{block.solve(block::linear_fall(1, 0, half_width)),
            block.solve(block::linear_fall(1, 1, half_width))} {}

BlockStudy::BlockStudy(const parameters::HalfSpaceCase& half_space,
                       const parameters::BlockCase& block_case,
                       std::vector<block::SurfaceDisplacement> observed)
    : half_space_(half_space),
      block_case_(block_case),
      analysis_(analysis_of(half_space, block_case)),
      observed_(std::move(observed)) {
  sys::for_each_parallel(sides_.size(), 0, [&](std::size_t i) {
    sides_[i].emplace(analysis_, static_cast<Support>(i), half_space_.load.half_width());
  });
  under_triangle_ = on(block_case.sides).solve(half_space.load);
  if (observed_.empty()) return;
  const Support sides = block_case.sides;
  fit_ = fit_on(sides);
  const block::Fit coarse = coarse_fit(falls_on(sides), observed_);
  under_fit_.emplace(fit_->fit.solution.fine(), coarse.solution.fine());
  misfit_error_ = largest_difference(fit_->fit.residuals, coarse.residuals);
}

block::LinearFit BlockStudy::fit_on(Support sides) const {
  return block::fit_linear_load(on(sides), half_space_.load.half_width(), observed_);
}

std::vector<Candidate> BlockStudy::candidates() const {
  const double a = half_space_.load.half_width();
  std::vector<Candidate> candidates;
  const auto add = [&](const std::string& shape, Support sides,
                       const std::vector<block::RefinedSolution>& solutions) {
    block::Fit fit = block::fit_loads(solutions, observed_);
    const block::Fit coarse = coarse_fit(solutions, observed_);
    const double error = largest_difference(fit.residuals, coarse.residuals);
    block::RefinedSolution refitted(fit.solution.fine(), coarse.solution.fine());
    candidates.push_back({shape, sides, std::move(fit), error, std::move(refitted)});
  };
  for (const Support sides : {Support::clamped, Support::roller, Support::free}) {
    add("linear fall", sides, falls_on(sides));
  }
  const std::vector<std::pair<std::string, elasticity::Load>> shapes = {
      {"trapezoid", block::trapezoid(1, flat_fraction, a)},
      {"elliptic", block::elliptic(1, a)},
      {"parabola", block::power_fall(1, 2, a)},
      {"quartic", block::power_fall(1, 4, a)}};
  for (const Support sides : {Support::clamped, Support::free}) {
    add("triangle, eq. (4)", sides, {falls_on(sides)[0]});
    add("uniform", sides, {falls_on(sides)[1]});
    for (const auto& [shape, load] : shapes) {
      add(shape, sides, {on(sides).solve(load)});
    }
  }
  return candidates;
}

block::MeasureOptions BlockStudy::measure_options() const {
  const double a = half_space_.load.half_width();
  const block::Rectangle& r = block_case_.rectangle;
  const double corner = 0.1 * r.height();
  block::MeasureOptions options;
  options.surface_points = half_space_.points;
  options.singular_discs = {{-a, 0, a / 10},
                            {a, 0, a / 10},
                            {r.left(), 0, corner},
                            {r.right(), 0, corner},
                            {r.left(), r.height(), corner},
                            {r.right(), r.height(), corner}};
  return options;
}

}  // namespace paper
