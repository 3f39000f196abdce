// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/block_study.hpp"

#include "block/load_shapes.hpp"

namespace paper {
namespace {

using block::Support;

block::Analysis analysis_of(const parameters::Case& c) {
  const double a = c.half_space.load.half_width();
  return {c.block->rectangle,
          c.half_space.material,
          {block::linear_fall(1, 0, a), block::trapezoid(1, flat_fraction, a)},
          c.block->discretization};
}

std::vector<block::SurfaceDisplacement> observed_in(const parameters::Case& c) {
  std::vector<block::SurfaceDisplacement> observed;
  if (!c.printed) return observed;
  for (std::size_t i = 0; i < c.half_space.points.size(); ++i) {
    observed.push_back({c.half_space.points[i], c.printed->figure5.fea_z[i].value()});
  }
  return observed;
}

}  // namespace

std::string name_of(Support sides) {
  if (sides == Support::clamped) return "clamped";
  return sides == Support::roller ? "roller" : "free";
}

BlockStudy::BlockStudy(const parameters::Case& from_file)
    : case_(from_file),
      analysis_(analysis_of(from_file)),
      clamped_(analysis_.on(block::with_sides(Support::clamped))),
      roller_(analysis_.on(block::with_sides(Support::roller))),
      free_(analysis_.on(block::with_sides(Support::free))),
      under_triangle_(on(from_file.block->sides).solve(from_file.half_space.load)),
      observed_(observed_in(from_file)) {
  if (!observed_.empty()) fit_ = fit_on(from_file.block->sides);
}

const block::SupportedBlock& BlockStudy::on(Support sides) const {
  if (sides == Support::clamped) return clamped_;
  return sides == Support::roller ? roller_ : free_;
}

block::LinearFit BlockStudy::fit_on(Support sides) const {
  return block::fit_linear_load(on(sides), case_.half_space.load.half_width(), observed_);
}

std::vector<Candidate> BlockStudy::candidates() const {
  const double a = case_.half_space.load.half_width();
  std::vector<Candidate> candidates;
  for (const Support sides : {Support::clamped, Support::roller, Support::free}) {
    candidates.push_back({"linear fall", sides, fit_on(sides).fit});
  }
  const std::vector<std::pair<std::string, elasticity::Load>> shapes = {
      {"triangle, eq. (4)", block::linear_fall(1, 0, a)},
      {"uniform", block::linear_fall(1, 1, a)},
      {"trapezoid", block::trapezoid(1, flat_fraction, a)},
      {"elliptic", block::elliptic(1, a)},
      {"parabola", block::power_fall(1, 2, a)},
      {"quartic", block::power_fall(1, 4, a)}};
  for (const Support sides : {Support::clamped, Support::free}) {
    for (const auto& [shape, load] : shapes) {
      candidates.push_back({shape, sides, block::fit_loads({on(sides).solve(load)}, observed_)});
    }
  }
  return candidates;
}

block::MeasureOptions BlockStudy::measure_options() const {
  const double a = case_.half_space.load.half_width();
  const block::Rectangle& r = case_.block->rectangle;
  const double corner = 0.1 * r.height();
  block::MeasureOptions options;
  options.surface_points = case_.half_space.points;
  options.singular_discs = {{-a, 0, a / 10},
                            {a, 0, a / 10},
                            {r.left(), 0, corner},
                            {r.right(), 0, corner},
                            {r.left(), r.height(), corner},
                            {r.right(), r.height(), corner}};
  return options;
}

}  // namespace paper
