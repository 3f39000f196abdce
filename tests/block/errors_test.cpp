// SPDX-License-Identifier: GPL-3.0-or-later
// The error bounds of measures and displacements hold: loads × supports × discretisations.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "block/paper_block.hpp"
#include "block/solution.hpp"

BOOST_AUTO_TEST_SUITE(errors_test)

using block::Support;

namespace {

constexpr double a = paper_block::half_width;
const std::vector<double> points = {0, a, 0.03, 0.6};

double ellipse(double x) {
  return 1000 * std::sqrt(std::max(0.0, (1 - x / a) * (1 + x / a)));
}

const elasticity::Load loads[] = {
    elasticity::TriangularLoad(1000, a), elasticity::UniformLoad(1000, a),
    elasticity::LinearFall(1000, 0.6, a), elasticity::distributed_load(ellipse, {-a, a})};

constexpr block::Discretization discretizations[] = {{4, 1}, {5, 1}, {7, 1}, {10, 1}, {7, 2}};

}  // namespace

BOOST_AUTO_TEST_CASE(errors_hold_in_sixty_runs) {
  int n_runs = 0;
  for (const elasticity::Load& load : loads) {
    // The reference: errors of at most a tenth of those of the finest run
    const auto model = std::make_shared<const block::Model>(
        block::graded_mesh(paper_block::rectangle, {load}, {10, 3}), paper_block::material);
    for (const Support sides : {Support::clamped, Support::roller, Support::free}) {
      const block::Supports supports = block::with_sides(sides);
      const auto reference =
          block::measures(block::Factorization(model, supports).solve(load),
                          discs_without_limit(paper_block::rectangle, supports, load), points);
      for (const block::Discretization& discretization : discretizations) {
        const auto measures = paper_block::solve(load, supports, discretization).measures(points);
        ++n_runs;
        BOOST_TEST_REQUIRE(measures.size() == reference.size());
        for (std::size_t i = 0; i < measures.size(); ++i) {
          const numerics::Estimate computed = measures[i].value;
          BOOST_TEST_CONTEXT(measures[i].name << ", order " << discretization.order << ", refine "
                                              << discretization.refine) {
            BOOST_TEST(std::abs(computed.value - reference[i].value) <= computed.abs_error);
          }
        }
      }
    }
  }
  BOOST_TEST(n_runs == 60);
}

BOOST_AUTO_TEST_SUITE_END()
