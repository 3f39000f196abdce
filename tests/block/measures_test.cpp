// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/measures.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "block/paper_block.hpp"

BOOST_AUTO_TEST_SUITE(measures_test)

using block::Support;
using paper_block::measure;

namespace {

std::vector<block::MeasureEstimate> measures_of(const elasticity::Load& load, Support sides,
                                                const block::Discretization& discretization,
                                                int plotting_grid = 20) {
  const block::Analysis analysis(paper_block::rectangle, paper_block::material, {load},
                                 discretization);
  block::MeasureOptions options = paper_block::measure_options();
  options.plotting_grid = plotting_grid;
  return analysis.on(block::with_sides(sides)).solve(load).measures(options);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_measure_converges_within_its_estimate) {
  const auto load = elasticity::LinearFall(994, 0.608, paper_block::half_width);
  for (const Support sides : {Support::clamped, Support::free}) {
    const auto computed = measures_of(load, sides, {});

    const auto reference = measures_of(load, sides, {.order = 9, .refine = 2}, 40);

    for (std::size_t i = 0; i < computed.size(); ++i) {
      if (computed[i].name == "max_stress_prin") continue;  // has no limit, see below
      BOOST_TEST_CONTEXT(computed[i].name) {
        const auto [value, abs_error] = computed[i].value;
        const double scale = std::abs(reference[i].value.value);
        BOOST_TEST(std::abs(value - reference[i].value.value) <= abs_error + 2e-5 * scale);
        BOOST_TEST(reference[i].value.abs_error <= std::max(0.5 * abs_error, 1e-3 * scale));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(polynomials_overshoot_a_jump_of_pressure_at_every_refinement) {
  const auto load = elasticity::LinearFall(1000, 0.6, paper_block::half_width);

  for (const int refine : {1, 2}) {
    const auto measures = measures_of(load, Support::clamped, {.order = 7, .refine = refine});

    // A tenth of the jump of 600, while the tension in the block is a hundred times less
    BOOST_TEST(measure(measures, "max_stress_prin") > 60);
    BOOST_TEST(measure(measures, "max_stress_prin_regular") < 8);
  }
}

BOOST_AUTO_TEST_CASE(measures_have_the_signs_of_appendix_2) {
  const auto measures = measures_of(elasticity::LinearFall(1000, 0.6, paper_block::half_width),
                                    Support::clamped, {.order = 5, .refine = 0});

  for (const std::string name :
       {"resultant_load_y", "max_disp_y", "max_prin_mag", "max_stress_xx", "max_stress_xy",
        "max_stress_yy", "max_stress_zz", "min_stress_prin", "measure1", "measure11"}) {
    BOOST_TEST_CONTEXT(name) {
      BOOST_TEST(measure(measures, name) < 0);
    }
  }
  for (const std::string name :
       {"max_disp_mag", "max_disp_x", "max_stress_prin", "max_stress_vm", "strain_energy"}) {
    BOOST_TEST_CONTEXT(name) {
      BOOST_TEST(measure(measures, name) > 0);
    }
  }
  for (const std::string name : {"max_disp_z", "max_rot_mag", "max_stress_xz", "max_stress_yz"}) {
    BOOST_TEST_CONTEXT(name) {
      BOOST_TEST(measure(measures, name) == 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(out_of_plane_maximum_is_poisson_times_the_in_plane_maxima_as_printed) {
  // Ruggiero (2001), Appendix 2: −591.4541 = 0.30·(−978.7585 − 992.7550), all at x = 0
  const auto measures = measures_of(elasticity::LinearFall(1000, 0.6, paper_block::half_width),
                                    Support::clamped, {.order = 8, .refine = 2});

  const double sum = measure(measures, "max_stress_xx") + measure(measures, "max_stress_yy");

  BOOST_CHECK_CLOSE(measure(measures, "max_stress_zz"), 0.30 * sum, 0.02);
}

BOOST_AUTO_TEST_SUITE_END()
