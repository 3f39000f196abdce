// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/block_figures.hpp"

#include <cmath>

#include "block/load_shapes.hpp"
#include "figures/block_contours.hpp"
#include "figures/block_convergence.hpp"
#include "figures/block_mesh.hpp"
#include "figures/fit_misfit.hpp"
#include "figures/like_with_like.hpp"

namespace paper {
namespace {

using block::Support;

// What the convergence of the lower orders is measured against.
constexpr int highest_order = 8;

// Samples a window of the block evenly and moves each point by its displacement, enlarged.
figures::ContourWindow sample(const block::Solution& solution, double left, double right,
                              double depth, double enlargement) {
  constexpr int n_along_x = 96, n_along_z = 48;
  figures::ContourWindow window;
  window.n_along_x = n_along_x + 1;
  for (int j = 0; j <= n_along_z; ++j) {
    for (int i = 0; i <= n_along_x; ++i) {
      const double x = left + (right - left) * i / n_along_x;
      const double z = depth * j / n_along_z;
      const Eigen::Vector2d u = solution.displacement(x, z);
      window.x.push_back(x + enlargement * u.x());
      window.y.push_back(-z - enlargement * u.y());
      window.u_z.push_back(u.y());
    }
  }
  return window;
}

figures::BlockContours contours(const parameters::HalfSpaceCase& half_space,
                                const parameters::BlockCase& block_case,
                                const config::UnitSystem& units, const BlockStudy& study) {
  const block::Solution& solution =
      study.fit() ? study.fit()->fit.solution.fine() : study.under_triangle().fine();
  const block::Rectangle& r = block_case.rectangle;
  const double a = half_space.load.half_width();
  const double largest = solution.displacement(0, 0).y();
  return {sample(solution, r.left(), r.right(), r.height(), 0.08 * r.height() / largest),
          sample(solution, -4 * a, 4 * a, 4 * a, 0.8 * a / largest), a, largest, units.length};
}

// What each order of the elements leaves, on one mesh that is graded for this load alone.
figures::BlockConvergence convergence(const parameters::HalfSpaceCase& half_space,
                                      const parameters::BlockCase& block_case,
                                      const BlockStudy& study) {
  const auto options = study.measure_options();
  const auto measures_of = [&](int order) {
    const block::Analysis analysis(block_case.rectangle, half_space.material, {half_space.load},
                                   {.order = order, .refine = block_case.discretization.refine});
    const block::Factorization factorization(analysis.fine(), block::with_sides(block_case.sides));
    return block::measures(factorization.solve(half_space.load), options);
  };
  const auto exact = measures_of(highest_order);
  const auto value = [](const std::vector<block::Measure>& list, const std::string& name) {
    for (const block::Measure& m : list) {
      if (m.name == name) return m.value;
    }
    return std::nan("");
  };
  figures::BlockConvergence figure;
  for (int order = 2; order < highest_order; ++order) {
    const auto measured = measures_of(order);
    const auto error = [&](const char* name) {
      return std::abs(value(measured, name) / value(exact, name) - 1);
    };
    figure.order.push_back(order);
    figure.displacement.push_back(error("measure1"));
    figure.energy.push_back(error("strain_energy"));
    figure.von_mises.push_back(error("max_stress_vm"));
  }
  return figure;
}

figures::BlockMesh mesh(const parameters::HalfSpaceCase& half_space,
                        const parameters::BlockCase& block_case, const config::UnitSystem& units,
                        const BlockStudy& study) {
  const block::Mesh& m = study.on(block_case.sides).fine().model()->mesh();
  return {m.x_lines(), m.z_lines(), half_space.load.half_width(), units.length};
}

// The largest misfit for each edge fraction, with the best peak for it.
figures::FitMisfit misfits(const parameters::HalfSpaceCase& half_space, const BlockStudy& study) {
  const double a = half_space.load.half_width();
  figures::FitMisfit figure;
  for (int i = 0; i <= 100; ++i) figure.edge_fraction.push_back(0.01 * i);
  for (const Support sides : {Support::clamped, Support::roller, Support::free}) {
    // Solutions add, so that two loads serve for all edge fractions.
    const block::RefinedSolution triangle = study.on(sides).solve(block::linear_fall(1, 0, a));
    const block::RefinedSolution uniform = study.on(sides).solve(block::linear_fall(1, 1, a));
    std::vector<double> misfit;
    for (const double f : figure.edge_fraction) {
      const auto fall = block::RefinedSolution::combination({triangle, uniform}, {1 - f, f});
      misfit.push_back(block::fit_loads({fall}, study.observed()).max_misfit);
    }
    (sides == Support::clamped  ? figure.clamped
     : sides == Support::roller ? figure.roller
                                : figure.free) = misfit;
  }
  return figure;
}

figures::LikeWithLike like_with_like(const parameters::HalfSpaceCase& h,
                                     const config::UnitSystem& units, const BlockStudy& study) {
  figures::LikeWithLike figure;
  figure.unit = units.length;
  constexpr int n = 240;
  for (int i = 0; i <= n; ++i) {
    const double x = h.points.back() * i / n;
    figure.x.push_back(x);
    figure.half_space.push_back(normal_displacement(h.material, h.load, x, h.datum));
    figure.block_stated.push_back(study.under_triangle().displacement_z(x, 0).value);
    figure.block_fitted.push_back(study.fit()->fit.solution.displacement_z(x, 0).value);
  }
  for (const block::SurfaceDisplacement& printed : study.observed()) {
    figure.printed_x.push_back(printed.x);
    figure.printed.push_back(printed.u_z);
  }
  return figure;
}

}  // namespace

void register_block_figures(literate::Document& document,
                            const parameters::HalfSpaceCase& half_space,
                            const parameters::BlockCase& block_case,
                            const config::UnitSystem& units, const BlockStudy& study) {
  document.value("block.highest-order", literate::Value::integer(highest_order));
  document.figure("block-contours", 15, 6.2,
                  [d = contours(half_space, block_case, units, study)](literate::Plot& plot) {
                    figures::draw_block_contours(plot, d);
                  });
  document.figure("block-mesh", 15, 5.4,
                  [d = mesh(half_space, block_case, units, study)](literate::Plot& plot) {
                    figures::draw_block_mesh(plot, d);
                  });
  document.figure("block-convergence", 10, 6.4,
                  [d = convergence(half_space, block_case, study)](literate::Plot& plot) {
                    figures::draw_block_convergence(plot, d);
                  });
  if (!study.fit()) return;
  document.figure("fit-misfit", 10, 6.4, [d = misfits(half_space, study)](literate::Plot& plot) {
    figures::draw_fit_misfit(plot, d);
  });
  document.figure("like-with-like", 12.5, 7.2,
                  [d = like_with_like(half_space, units, study)](literate::Plot& plot) {
                    figures::draw_like_with_like(plot, d);
                  });
}

}  // namespace paper
