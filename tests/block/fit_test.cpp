// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/fit.hpp"

#include <boost/test/unit_test.hpp>

#include "block/paper_block.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(fit_test)

namespace {

block::SupportedBlock clamped_block(const std::vector<elasticity::Load>& loads) {
  return block::Analysis(paper_block::rectangle, paper_block::material, loads,
                         {.order = 5, .refine = 1})
      .on(block::with_sides(block::Support::clamped));
}

std::vector<block::SurfaceDisplacement> observe(const block::RefinedSolution& solution) {
  std::vector<block::SurfaceDisplacement> observed;
  for (const auto& point : paper_block::printed) {
    observed.push_back({point.x, solution.displacement_z(point.x, 0).value});
  }
  return observed;
}

}  // namespace

BOOST_AUTO_TEST_CASE(fit_recovers_a_known_linear_fall) {
  const auto known = elasticity::LinearFall(871.5, 0.4385, paper_block::half_width);
  const auto clamped = clamped_block({known});
  const auto observed = observe(clamped.solve(known));

  const block::LinearFit fit = block::fit_linear_load(clamped, paper_block::half_width, observed);

  BOOST_CHECK_CLOSE(fit.peak.value(), 871.5, 1e-6);
  BOOST_CHECK_CLOSE(fit.edge_fraction.value(), 0.4385, 1e-6);
  BOOST_TEST(fit.fit.max_misfit < 1e-9);
  BOOST_CHECK_CLOSE(elasticity::normal_resultant(fit.load), 871.5 * 1.4385 * 0.01, 1e-6);
}

BOOST_AUTO_TEST_CASE(fit_of_one_load_finds_its_scale) {
  const auto unit = elasticity::EllipticLoad(1, paper_block::half_width);
  const auto clamped = clamped_block({unit});
  const auto observed = observe(clamped.solve(elasticity::scaled(unit, 742)));

  const block::Fit fit = block::fit_loads({clamped.solve(unit)}, observed);

  BOOST_CHECK_CLOSE(fit.factors[0].value(), 742.0, 1e-7);
}

BOOST_AUTO_TEST_CASE(misfits_are_the_relative_residuals_of_the_fitted_solution) {
  const auto clamped = clamped_block({elasticity::LinearFall(1, 0, paper_block::half_width)});

  const block::LinearFit fit =
      block::fit_linear_load(clamped, paper_block::half_width, paper_block::printed);

  double largest = 0;
  for (std::size_t i = 0; i < paper_block::printed.size(); ++i) {
    const auto& point = paper_block::printed[i];
    const double residual =
        fit.fit.solution.displacement_z(point.x, 0).value / point.u_z.value() - 1;
    BOOST_TEST(std::abs(fit.fit.residuals[i] - residual) < 1e-12);
    largest = std::max(largest, std::abs(residual));
  }
  BOOST_CHECK_CLOSE(fit.fit.max_misfit, largest, 1e-6);
}

BOOST_AUTO_TEST_CASE(no_other_peak_and_edge_fraction_fit_better) {
  const auto clamped = clamped_block({elasticity::LinearFall(1, 0, paper_block::half_width)});
  const auto best = block::fit_linear_load(clamped, paper_block::half_width, paper_block::printed);

  double least = 0;
  for (const double residual : best.fit.residuals) least += residual * residual;
  for (const double peak_step : {-1e-4, 0.0, 1e-4}) {
    for (const double edge_step : {-1e-4, 0.0, 1e-4}) {
      if (peak_step == 0 && edge_step == 0) continue;
      const auto load = elasticity::LinearFall(best.peak.value() * (1 + peak_step),
                                                best.edge_fraction.value() * (1 + edge_step),
                                                paper_block::half_width);
      const auto solution = clamped.solve(load);
      double square = 0;
      for (const auto& point : paper_block::printed) {
        const double residual = solution.displacement_z(point.x, 0).value / point.u_z.value() - 1;
        square += residual * residual;
      }
      BOOST_TEST(square > least);
    }
  }
}

BOOST_AUTO_TEST_CASE(too_few_or_senseless_observations_are_refused) {
  const double a = paper_block::half_width;
  const auto clamped = clamped_block({elasticity::LinearFall(1, 0, a)});

  BOOST_CHECK_THROW(block::fit_linear_load(clamped, a, {{0, 1e-6}}), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::fit_linear_load(clamped, a, {{0, 1e-6}, {0.01, 0}}),
                    sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::fit_linear_load(clamped, a, {{0, 1e-6}, {1.5, 1e-6}}),
                    sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::fit_linear_load(clamped, 0, paper_block::printed), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::fit_loads({}, paper_block::printed), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
