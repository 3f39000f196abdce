// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/solver/partial_slip.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "point_contact/closed_forms/revolution.hpp"
#include "point_contact/closed_forms/spheres.hpp"
#include "point_contact/solver/methods.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(partial_slip_test)

using point_contact::CattaneoMindlin;
using point_contact::Element;
using point_contact::Friction;
using point_contact::Hertz;
using point_contact::hexagonal_grid;
using point_contact::Problem;
using point_contact::Profile;
using point_contact::Solution;
using tolerance::relative_difference;

namespace {

constexpr double load = 3.461;
constexpr double friction = 0.37;
constexpr double tangential_load = -0.81;
const elasticity::Material material(2000, 0.2385);
const double modulus = elasticity::contact_modulus(material, material);
const Hertz hertz(modulus, 0.571, load);
const double compliance = point_contact::tangential_compliance(material, material);

Problem spheres(Eigen::Index n) {
  return {Profile::paraboloid(0.571), modulus, hexagonal_grid(2 * hertz.radius() / 0.9, n),
          Element::pyramid};
}

// The greatest error of the shear but for two spacings about the edges of stick and of contact.
double error_of_shear(Eigen::Index n) {
  const Problem problem = spheres(n);
  const Solution solution = solve_for_load(problem, load);
  const Friction slip = partial_slip(problem, solution, friction, tangential_load);
  const CattaneoMindlin exact(hertz, friction, tangential_load);
  double greatest = 0;
  const point_contact::Grid& grid = problem.grid;
  for (Eigen::Index j = 0; j < grid.n2; ++j) {
    for (Eigen::Index i = 0; i < grid.n1; ++i) {
      const double r = grid.node(i, j).norm();
      const double to_edge =
          std::min(std::abs(r - exact.stick_radius()), std::abs(r - hertz.radius()));
      if (to_edge < 0.1 * hertz.radius()) continue;
      greatest = std::max(greatest, std::abs(slip.shear[grid.index(i, j)] - exact.traction(r)));
    }
  }
  return greatest / (friction * hertz.peak_pressure());
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_shear_of_spheres_is_that_of_cattaneo_and_mindlin_to_the_second_order) {
  const double coarse = error_of_shear(64);
  const double fine = error_of_shear(192);

  BOOST_TEST(fine < 1e-3, fine);
  BOOST_TEST(coarse / fine > 5, coarse / fine);  // nine by the second order
}

BOOST_AUTO_TEST_CASE(the_shear_carries_the_tangential_load_and_never_exceeds_friction) {
  const Problem problem = spheres(64);
  const Solution solution = solve_for_load(problem, load);
  const Friction slip = partial_slip(problem, solution, friction, tangential_load);

  BOOST_TEST(relative_difference(slip.shear.sum() * problem.grid.lattice.cell_area(),
                                 tangential_load) < 1e-12);
  BOOST_TEST((slip.shear.array() <= 0).all());
  BOOST_TEST((-slip.shear.array() <= (1 + 1e-7) * friction * solution.pressure.array()).all());
  const double stick_radius = CattaneoMindlin(hertz, friction, tangential_load).stick_radius();
  const double stick_area = static_cast<double>(slip.n_sticking) * problem.grid.lattice.cell_area();
  BOOST_TEST(relative_difference(stick_area, std::numbers::pi * stick_radius * stick_radius) <
             0.02);
}

BOOST_AUTO_TEST_CASE(distant_points_of_spheres_move_as_mindlin_says) {
  const Problem problem = spheres(128);
  const Solution solution = solve_for_load(problem, load);
  const Friction slip = partial_slip(problem, solution, friction, tangential_load);
  const double exact = CattaneoMindlin(hertz, friction, tangential_load).displacement(compliance);

  BOOST_TEST(exact < 0);
  BOOST_TEST(relative_difference(
                 tangential_displacement(problem, solution, slip, friction, compliance), exact) <
             1e-4);
}

BOOST_AUTO_TEST_CASE(bodies_that_slide_bear_friction_everywhere) {
  const Solution solution = solve_for_load(spheres(32), load);
  const Friction slides = sliding(solution, friction);

  BOOST_TEST((slides.shear.array() == friction * solution.pressure.array()).all());
  BOOST_TEST(relative_difference(slides.tangential_load, friction * load) < 1e-13);
  BOOST_TEST(slides.n_sticking == 0);
}

BOOST_AUTO_TEST_CASE(more_than_friction_holds_and_no_friction_are_refused) {
  const Problem problem = spheres(32);
  const Solution solution = solve_for_load(problem, load);
  BOOST_CHECK_THROW(partial_slip(problem, solution, friction, friction * load * 1.0001),
                    sys::InvalidQuantity);
  BOOST_CHECK_THROW(partial_slip(problem, solution, 0, 0), sys::InvalidQuantity);
  BOOST_CHECK_THROW(sliding(solution, -0.1), sys::InvalidQuantity);
  BOOST_CHECK_THROW(sliding(solution, std::nan("")), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
