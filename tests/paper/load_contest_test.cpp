// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the load of the finite-element run, on displacements whose load is known.
#include "paper/load_contest.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <set>
#include <string>
#include <vector>

#include "elasticity/load_shapes.hpp"
#include "parameters/case.hpp"

BOOST_AUTO_TEST_SUITE(load_contest_test)

namespace {

using block::Support;

const std::string source_dir = HALFSPACE_SOURCE_DIR;

parameters::Case coarse_case() {
  parameters::Case c = parameters::read_case(source_dir + "/report/ruggiero2001.toml");
  c.block->discretization.order = 6;
  c.block->discretization.refine = 0;
  return c;
}

// A study whose observed displacements are those under 600 + 400·(1 − |x/a|ᵐ).
paper::BlockStudy study_of(const parameters::Case& c, double exponent) {
  const double a = c.half_space.load.half_width();
  const paper::BlockStudy unloaded(c.half_space, *c.block, {});
  const block::SupportedBlock& block = unloaded.on(c.block->sides);
  const auto under =
      block::RefinedSolution::combination({block.solve(elasticity::LinearFall(1, 1, a)),
                                           block.solve(elasticity::power_fall(1, exponent, a))},
                                          {600, 400});
  std::vector<block::SurfaceDisplacement> observed;
  for (const double x : c.half_space.points) {
    observed.push_back({x, under.displacement_z(x, 0).value});
  }
  return {c.half_space, *c.block, observed};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_exponent_of_a_known_load_is_found_and_lies_in_its_interval) {
  const parameters::Case c = coarse_case();
  const paper::BlockStudy study = study_of(c, 1.37);

  const paper::ExponentFit fit =
      paper::fit_exponent(study, c.half_space.load.half_width(), c.block->sides, 1e-3);

  BOOST_TEST(fit.best.value == 1.37, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(fit.misfit.value < 1e-5);
  BOOST_TEST(fit.least.value < 1.2);
  BOOST_TEST(fit.most.value > 1.5);
  const paper::ExponentFit closer =
      paper::fit_exponent(study, c.half_space.load.half_width(), c.block->sides, 1e-4);
  BOOST_TEST(closer.least.value > fit.least.value);
  BOOST_TEST(closer.most.value < fit.most.value);
}

BOOST_AUTO_TEST_CASE(the_shape_that_made_the_displacements_wins_on_its_supports) {
  const parameters::Case c = coarse_case();
  const paper::BlockStudy study = study_of(c, 2);

  const auto contestants = paper::contest(study, c.half_space, c.block->sides);

  const auto best = std::ranges::min_element(
      contestants, {},
      [](const paper::Contestant& contestant) { return contestant.misfit.largest.value; });
  BOOST_TEST(best->shape == "uniform + parabola");
  BOOST_TEST(best->misfit.largest.value < 1e-9);
  const auto n_own = std::ranges::count(contestants, block::with_sides(c.block->sides),
                                        &paper::Contestant::supports);
  BOOST_TEST(n_own == 10);
  BOOST_TEST(contestants.size() == 14U);
  // 600 at the ends and 400 more in the middle
  BOOST_TEST(best->peak.value() == 1000, boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(displacements_do_not_tell_several_shapes_from_a_triangle) {
  const parameters::Case c = coarse_case();
  const paper::BlockStudy study = study_of(c, 1);
  const std::set<std::string> alike = {"uniform + triangle", "uniform + cosine", "uniform + step",
                                       "uniform + narrower triangle"};

  std::size_t n_alike = 0;
  for (const auto& contestant : paper::contest(study, c.half_space, c.block->sides)) {
    if (contestant.supports != block::with_sides(c.block->sides) || contestant.n_free != 2)
      continue;
    BOOST_TEST_CONTEXT(contestant.shape) {
      const bool is_alike = alike.contains(contestant.shape);
      BOOST_TEST((contestant.misfit.largest.value < 1e-3) == is_alike);
      n_alike += is_alike ? 1 : 0;
    }
  }
  BOOST_TEST(n_alike == alike.size());
}

BOOST_AUTO_TEST_CASE(a_load_as_it_is_misses_by_as_much_as_it_is_too_small) {
  const parameters::Case c = coarse_case();
  const paper::BlockStudy study = study_of(c, 1);
  const double a = c.half_space.load.half_width();
  const auto misfit_of = [&](double peak) {
    const elasticity::Load load = elasticity::LinearFall(peak, 0.6, a);
    return paper::unfitted(study, "as it is", load, peak, c.block->sides).misfit;
  };

  BOOST_TEST(misfit_of(1000).largest.value < 1e-9);
  BOOST_TEST(misfit_of(990).largest.value == 0.01, boost::test_tools::tolerance(1e-6));
  // eleven residuals alike
  BOOST_TEST(misfit_of(990).chi_squared.value == 11e-4, boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(a_misfit_is_told_in_the_uncertainty_of_its_displacement) {
  const parameters::Case c = coarse_case();
  std::vector<block::SurfaceDisplacement> observed = study_of(c, 1).observed();
  for (std::size_t i = 0; i < observed.size(); ++i) {
    const double u_z = observed[i].u_z.value();
    const double relative = i == 0 ? 0.005 : 0.02;  // the first is known four times as well
    observed[i].u_z = {u_z, relative * u_z, "displacement/" + std::to_string(i)};
  }
  const paper::BlockStudy study(c.half_space, *c.block, observed);
  const elasticity::Load load = elasticity::LinearFall(990, 0.6, c.half_space.load.half_width());

  const auto misfit = paper::unfitted(study, "as it is", load, 990, c.block->sides).misfit;

  BOOST_TEST(misfit.largest_share.value == 2, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(misfit.chi_squared.value == 4 + 10 * 0.25, boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_SUITE_END()
