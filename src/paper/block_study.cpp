// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/block_study.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "block/rectangle.hpp"
#include "elasticity/load_shapes.hpp"
#include "paper/prelude.hpp"
#include "system/parallel.hpp"

namespace paper {
namespace {

using block::Support;

block::Analysis analysis_of(const HalfSpaceCase& half_space, const BlockCase& block_case) {
  const double a = half_space.load.half_width();
  return {block_case.rectangle,
          half_space.material,
          {elasticity::LinearFall(1, 0, a)},
          block_case.discretization};
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

std::vector<block::SurfaceDisplacement> observed_in(const HalfSpaceCase& half_space,
                                                    const PrintedData& printed) {
  const auto& convergence = printed.appendix2.convergence;
  std::vector<block::SurfaceDisplacement> observed;
  for (std::size_t i = 0; i < half_space.points.size(); ++i) {
    const double u_z = printed.figure5.fea_z[i].value();
    const std::string measure = fmt::format("measure{}", i + 1);
    const double relative = convergence.at(measure).value() / 100;
    observed.push_back({half_space.points[i], {u_z, relative * u_z, "convergence/" + measure}});
  }
  return observed;
}

std::vector<std::pair<std::string, double>> mass_by_name(const BlockCase& block_case) {
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

BlockStudy::BlockStudy(const HalfSpaceCase& half_space, const BlockCase& block_case,
                       std::vector<block::SurfaceDisplacement> observed)
    : half_space_(half_space),
      block_case_(block_case),
      analysis_(analysis_of(half_space, block_case)),
      observed_(std::move(observed)) {
  sys::for_each_parallel(sides_.size(), 0, [&](std::size_t i) {
    sides_[i].emplace(analysis_.fine(), analysis_.coarse(),
                      block::with_sides(static_cast<Support>(i)));
  });
  under_triangle_ = on(block_case.sides).solve(half_space.load);
  if (observed_.empty()) return;
  const Support sides = block_case.sides;
  fit_ = fit_on(sides);
  const double a = half_space_.load.half_width();
  const block::Fit coarse =
      block::fit_coarse_loads({on(sides).solve(elasticity::LinearFall(1, 0, a)),
                               on(sides).solve(elasticity::LinearFall(1, 1, a))},
                              observed_);
  under_fit_.emplace(fit_->fit.solution.fine(), coarse.solution.fine());
  misfit_error_ = largest_difference(fit_->fit.residuals, coarse.residuals);
}

block::SupportedBlock BlockStudy::enlarged(double factor, Support sides) const {
  BlockCase larger = block_case_;
  larger.rectangle = {factor * block_case_.rectangle.width(),
                      factor * block_case_.rectangle.height()};
  return analysis_of(half_space_, larger).on(block::with_sides(sides));
}

block::LinearFit BlockStudy::fit_on(Support sides) const {
  return block::fit_linear_load(on(sides), half_space_.load.half_width(), observed_);
}

block::MeasureOptions BlockStudy::measure_options() const {
  const double a = half_space_.load.half_width();
  const block::Rectangle& r = block_case_.rectangle;
  const double corner = 0.1 * r.height();
  block::MeasureOptions options;
  options.plotting_grid = 20;  // twice that of the run, whose elements are larger
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
