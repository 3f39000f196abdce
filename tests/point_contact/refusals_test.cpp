// SPDX-License-Identifier: GPL-3.0-or-later
#include "refused.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "point_contact/cases.hpp"
#include "point_contact/methods.hpp"

BOOST_AUTO_TEST_SUITE(refusals_test)

using namespace point_cases;
using point_contact::Hertz;
using point_contact::HertzElliptic;
using point_contact::rectangular_grid;
using point_contact::solve_by_variational_method;
using point_contact::solve_for_load;
using point_contact::square_grid;

BOOST_AUTO_TEST_CASE(invalid_bodies_and_grids_are_rejected_by_name) {
  const Eigen::ArrayXXd flat = Eigen::ArrayXXd::Zero(5, 5);
  Eigen::ArrayXXd infinite = flat;
  infinite(3, 2) = std::numeric_limits<double>::infinity();
  check_refused({
      {"relative_curvature = 0", [] { Hertz(1, 0, 1); }},
      {"contact_modulus = -1", [] { Hertz(-1, 1, 1); }},
      {"load = nan", [] { Hertz(1, 1, NAN); }},
      {"curvature_y = 0", [] { HertzElliptic(1, 1, 0, 1); }},
      {"curvature_x/curvature_y = 1000000000", [] { HertzElliptic(1, 1e9, 1, 1); }},
      {"load = 0", [] { HertzElliptic(1, 1, 1, 0); }},
      {"curvature_x = -1", [] { Profile::elliptic_paraboloid(-1, 1); }},
      {"rows of heights = 3", [&] { Profile::height_map(flat.topRows(3), 1); }},
      {"columns of heights = 2", [&] { Profile::height_map(flat.leftCols(2), 1); }},
      {"height = inf", [&] { Profile::height_map(infinite, 1); }},
      {"spacing = 0", [&] { Profile::height_map(flat, 0); }},
      {"domain = 0", [] { square_grid(0, 64); }},
      {"domain = nan", [] { rectangular_grid(1, NAN, 64); }},
      {"nodes = 7: must be from 8 to 8192", [] { square_grid(1, 7); }},
      {"nodes = 20000: must be from 8 to 8192", [] { square_grid(1, 20000); }},
  });
}

BOOST_AUTO_TEST_CASE(unsolvable_problems_are_rejected_by_both_methods) {
  const Problem spheres = spheres_on(32);
  Problem soft = spheres, beyond = problem_of(cases[2], 32), huge = spheres, narrow = spheres,
          measured = beyond;
  soft.contact_modulus = 0;
  beyond.grid.spacing *= 1.1;
  huge.grid.spacing = 1e60;
  narrow.grid.spacing *= 0.6;
  measured.grid.spacing *= 0.1;
  for (const auto& solve :
       {+[](const Problem&p, double P) { solve_for_load(p, P); },
        +[](const Problem&p, double P) { solve_by_variational_method(p, P); }}) {
    check_refused({
        {"load = 0", [&] { solve(spheres, 0); }},
        {"load = 1e+120: must be less than ", [&] { solve(spheres, 1e120); }},
        {"contact_modulus = 0", [&] { solve(soft, load); }},
        {"within the measured surface, |x| ≤ 0.5", [&] { solve(beyond, load); }},
        {"largest gap on the grid", [&] { solve(huge, load); }},
        {"wider: the contact reaches the end of the grid", [&] { solve(narrow, load); }},
        {"which must lie within the measured surface", [&] { solve(measured, load); }},
    });
  }
  check_refused({
      {"tolerance = 0", [&] { solve_for_load(spheres, load, 0); }},
      {"tolerance = 0.02: must be from 1e-12", [&] { solve_for_load(spheres, load, 0.02); }},
      {"tolerance = nan", [&] { solve_by_variational_method(spheres, load, NAN); }},
  });
}

BOOST_AUTO_TEST_CASE(a_contact_of_few_nodes_is_an_error_with_a_sufficient_number) {
  for (const Eigen::Index n : {64, 65, 300, 513}) {
    for (const double part : {1e-3, 0.3, 0.8, 1.3, 3.0}) {  // the radius in spacings
      const double spacing = cases[0].width / static_cast<double>(n);
      const double tiny = load * std::pow(part * spacing / hertz.radius(), 3);
      const auto solve = [&] { solve_for_load(spheres_on(n), tiny); };
      if (part < 1.5) {
        check_refused({{"must be 8 or more: use at least", solve}});
      } else {
        BOOST_CHECK_NO_THROW(solve());
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
