// SPDX-License-Identifier: GPL-3.0-or-later
// The printed finite-element run of Ruggiero (2001), Appendix 2, rebuilt.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "block/paper_block.hpp"

BOOST_AUTO_TEST_SUITE(appendix2_test)

using block::Support;
using paper_block::measure;
using paper_block::solve;

namespace {

const block::Supports clamped = block::with_sides(Support::clamped);

}  // namespace

BOOST_AUTO_TEST_CASE(block_of_2_by_1_inches_has_the_printed_mass_properties) {
  const double printed_mass = 1.464799e-03;

  const block::MassProperties p = block::mass_properties({2, 1}, printed_mass / 2);

  const double digits = 5e-4;  // percent: half a unit of the sixth digit printed
  BOOST_CHECK_CLOSE(p.mass, printed_mass, 1e-10);
  BOOST_CHECK_CLOSE(p.centre_y, -0.5, 1e-10);
  BOOST_CHECK_CLOSE(p.about_origin.ixx, 4.88266e-04, digits);
  BOOST_CHECK_CLOSE(p.about_origin.iyy, 4.88266e-04, digits);
  BOOST_CHECK_CLOSE(p.about_origin.izz, 9.76532e-04, digits);
  BOOST_CHECK_CLOSE(p.about_centre.ixx, 1.22067e-04, digits);
  BOOST_CHECK_CLOSE(p.about_centre.iyy, 4.88266e-04, digits);
  BOOST_CHECK_CLOSE(p.about_centre.izz, 6.10333e-04, digits);
}

BOOST_AUTO_TEST_CASE(a_linear_fall_on_the_clamped_block_reproduces_the_run) {
  const auto solution = solve(elasticity::LinearFall(994, 0.608, paper_block::half_width), clamped);

  for (const auto& [x, printed] : paper_block::printed) {
    const numerics::Estimate u_z = solution.displacement_z(x, 0);
    BOOST_TEST(std::abs(u_z.value / printed - 1) < 1e-3);
    BOOST_TEST(u_z.abs_error < 2e-4 * printed);
  }
  // Measures that were not fitted. The printed u_x have an error of 2 %: they are 3.1e-9 in where
  // symmetry requires zero
  const auto measures = solution.measures({0, 0.005});
  const auto check = [&](const char* name, double printed, double percent) {
    BOOST_CHECK_CLOSE(measure(measures, name).value, printed, percent);
  };
  check("resultant_load_y", -1.600000e+01, 0.2);
  check("strain_energy", 1.212280e-05, 0.5);
  check("max_stress_vm", 5.317132e+02, 1.0);
  check("max_stress_yy", -9.927550e+02, 0.5);
  check("max_disp_x", 1.375065e-07, 0.6);
  check("max_disp_y", -1.594637e-06, 0.1);
  check("measure1", -1.594637e-06, 0.1);
  check("measure2", -1.523029e-06, 0.1);
  check("max_stress_zz", 0.3 * (measure(measures, "max_stress_xx").value - 992.7550), 0.5);
  for (const char* name : {"max_prin_mag", "max_stress_xx", "max_stress_xy", "min_stress_prin"}) {
    BOOST_TEST(measure(measures, name).value < 0);
  }
  for (const char* name : {"max_disp_mag", "max_stress_prin"}) {
    BOOST_TEST(measure(measures, name).value > 0);
  }
}

BOOST_AUTO_TEST_CASE(the_stated_triangle_gives_half_to_two_thirds_of_the_printed_displacements) {
  const auto solution = solve(elasticity::TriangularLoad(1000, paper_block::half_width), clamped);

  for (const auto& [x, printed] : paper_block::printed) {
    BOOST_TEST(std::abs(solution.displacement_z(x, 0).value / printed - 0.59) < 0.09);
  }
}

BOOST_AUTO_TEST_CASE(stresses_are_excluded_where_they_have_no_limit) {
  const double a = paper_block::half_width;
  const auto left_out = [&](const elasticity::Load& load, const block::Supports& supports) {
    return block::discs_without_limit(paper_block::rectangle, supports, load);
  };
  const elasticity::Load triangle = elasticity::TriangularLoad(1000, a);
  BOOST_TEST(left_out(triangle, block::with_sides(Support::roller)).empty());
  const auto at_jumps = left_out(elasticity::LinearFall(1000, 0.6, a), {.left = Support::roller});
  BOOST_TEST(at_jumps.size() == 3U);  // and the corner between the bottom and the free right
  BOOST_TEST(at_jumps[0].x == -a);
  BOOST_TEST(at_jumps[0].radius == a / 4);
  BOOST_TEST(at_jumps[2].x == 1);
  BOOST_TEST(at_jumps[2].z == 1);
  BOOST_TEST(left_out(triangle, clamped).size() == 2U);  // where the clamps meet the top
  BOOST_TEST(left_out(triangle, clamped)[1].z == 0);
  const block::Supports right_only = {Support::free, Support::clamped, Support::free};
  BOOST_TEST(left_out(triangle, right_only).size() == 2U);

  // The measures exclude the overshoot beside a jump, a tenth of it
  for (const Support sides : {Support::clamped, Support::free}) {
    const auto measures =
        solve(elasticity::UniformLoad(1000, a), block::with_sides(sides)).measures();
    BOOST_TEST(std::abs(measure(measures, "max_stress_yy").value + 1000) < 2);
    BOOST_TEST(measure(measures, "max_stress_prin").value < 20);
  }
}

// The two sides have the same magnitude with opposite signs; meshes must agree on one of them.
BOOST_AUTO_TEST_CASE(the_greatest_shear_of_a_symmetric_block_has_the_same_sign_on_every_mesh) {
  const elasticity::Load strip = elasticity::UniformLoad(100, 1);
  const block::Analysis analysis({50, 25}, elasticity::Material(210'000, 0.3), {strip});

  const auto measures = analysis.on(block::with_sides(Support::free)).solve(strip).measures();

  const numerics::Estimate shear = measure(measures, "max_stress_xy");
  BOOST_TEST(shear.value < 0);
  BOOST_TEST(shear.abs_error < 0.02 * std::abs(shear.value));
}

BOOST_AUTO_TEST_SUITE_END()
