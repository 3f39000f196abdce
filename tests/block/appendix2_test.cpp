// SPDX-License-Identifier: GPL-3.0-or-later
// The printed finite-element run of Ruggiero (2001), Appendix 2, rebuilt.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "block/paper_block.hpp"

BOOST_AUTO_TEST_SUITE(appendix2_test)

using block::Support;
using paper_block::measure;

namespace {

const double a = paper_block::half_width;

const block::Analysis& analysis() {
  static const block::Analysis shared(paper_block::rectangle, paper_block::material,
                                      {elasticity::LinearFall(1, 0, a)});
  return shared;
}

block::LinearFit linear_fit(Support sides) {
  return block::fit_linear_load(analysis().on(block::with_sides(sides)), a, paper_block::printed);
}

}  // namespace

BOOST_AUTO_TEST_CASE(linear_fall_on_a_clamped_block_fits_the_eleven_within_a_thousandth) {
  const block::LinearFit fit = linear_fit(Support::clamped);

  BOOST_TEST(fit.fit.max_misfit < 1e-3);
  BOOST_CHECK_CLOSE(fit.peak.value(), 994.0, 0.1);
  BOOST_CHECK_CLOSE(fit.edge_fraction.value(), 0.608, 0.1);
}

// References: 993.6 ± 21.9 psi and 605.5 ± 21.9 psi with a correlation of −0.9994, computed apart
// from this program by weighted least squares on the influence of the two loads.
BOOST_AUTO_TEST_CASE(the_printed_convergence_leaves_peak_and_edge_uncertain_but_not_their_sum) {
  const std::vector<double> convergence{0.3, 0.3, 0.3, 0.3, 0.3, 0.3,
                                        0.2, 0.2, 0.1, 0.1, 0.1};  // %
  std::vector<block::SurfaceDisplacement> observed = paper_block::printed;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    const double u_z = observed[i].u_z.value();
    observed[i].u_z = {u_z, convergence[i] / 100 * u_z, "measure " + std::to_string(i + 1)};
  }

  const block::LinearFit fit =
      block::fit_linear_load(analysis().on(block::with_sides(Support::clamped)), a, observed);

  BOOST_TEST(std::abs(fit.peak.value() - 993.6) < 0.05);
  BOOST_TEST(std::abs(fit.peak.standard() - 21.9) < 0.05);
  BOOST_TEST(std::abs(fit.edge.value() - 605.5) < 0.05);
  BOOST_TEST(std::abs(fit.edge.standard() - 21.9) < 0.05);
  BOOST_TEST(std::abs(correlation(fit.peak, fit.edge) + 0.9994) < 5e-5);
  BOOST_TEST((fit.peak + fit.edge).standard() < 1);
  // with the resultant held at 16 lbf/in, from the same source
  const numerics::Measured held = given(fit.peak, fit.peak + fit.edge, 16 / a);
  BOOST_TEST(std::abs(held.value() - 994.6) < 0.05);
  BOOST_TEST(std::abs(held.standard() - 21.9) < 0.05);
  BOOST_TEST(fit.peak.bounded().abs_error < 0.05);
}

BOOST_AUTO_TEST_CASE(fit_predicts_what_was_not_fitted) {
  const auto measures =
      linear_fit(Support::clamped).fit.solution.measures(paper_block::measure_options());

  BOOST_CHECK_CLOSE(measure(measures, "resultant_load_y"), -1.600000e+01, 0.2);
  BOOST_CHECK_CLOSE(measure(measures, "strain_energy"), 1.212280e-05, 0.5);
  BOOST_CHECK_CLOSE(measure(measures, "max_stress_vm"), 5.317132e+02, 1.0);
  BOOST_CHECK_CLOSE(measure(measures, "max_stress_yy"), -9.927550e+02, 0.5);
  // 0.52 % by measurement; the printed u_x carry an error of 2 %: they are 3.1e-9 in where symmetry
  // wants zero, √(1.594640² − 1.594637²)·1e-6
  BOOST_CHECK_CLOSE(measure(measures, "max_disp_x"), 1.375065e-07, 0.6);
}

BOOST_AUTO_TEST_CASE(other_shapes_on_the_clamped_block_miss_by_ten_times_more) {
  const auto clamped = analysis().on(block::with_sides(Support::clamped));
  const double best = linear_fit(Support::clamped).fit.max_misfit;

  const std::vector<elasticity::Load> loads = {
      elasticity::LinearFall(1, 0, a), elasticity::LinearFall(1, 1, a),
      elasticity::EllipticLoad(1, a), elasticity::power_fall(1, 2, a),
      elasticity::power_fall(1, 4, a)};
  for (const elasticity::Load& load : loads) {
    const block::Fit fit = block::fit_loads({clamped.solve(load)}, paper_block::printed);
    BOOST_TEST(fit.max_misfit > 10 * best);
  }
}

BOOST_AUTO_TEST_CASE(free_sides_miss_by_ten_times_more_but_rollers_cannot_be_told_from_clamps) {
  const double clamped = linear_fit(Support::clamped).fit.max_misfit;

  BOOST_TEST(linear_fit(Support::free).fit.max_misfit > 10 * clamped);
  BOOST_TEST(linear_fit(Support::roller).fit.max_misfit < 1e-3);
}

BOOST_AUTO_TEST_CASE(discretisation_error_of_each_displacement_is_below_a_fiftieth_of_a_percent) {
  for (const Support sides : {Support::clamped, Support::roller, Support::free}) {
    const auto solution = linear_fit(sides).fit.solution;

    for (const auto& point : paper_block::printed) {
      const numerics::Estimate u_z = solution.displacement_z(point.x, 0);
      BOOST_TEST(u_z.abs_error < 2e-4 * u_z.value);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_stated_triangle_misses_by_a_third_to_a_half) {
  const auto clamped = analysis().on(block::with_sides(Support::clamped));

  const auto solution = clamped.solve(elasticity::LinearFall(1000, 0, a));

  for (const auto& point : paper_block::printed) {
    const double ratio = solution.displacement_z(point.x, 0).value / point.u_z.value();
    BOOST_TEST(ratio < 0.68);
    BOOST_TEST(ratio > 0.5);
  }
}

BOOST_AUTO_TEST_SUITE_END()
