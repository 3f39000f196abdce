// SPDX-License-Identifier: GPL-3.0-or-later
#include "refused.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "line_contact/cases.hpp"
#include "line_contact/methods.hpp"

BOOST_AUTO_TEST_SUITE(refusals_test)

using namespace line_cases;
using line_contact::CylinderPair;
using line_contact::grid_of_width;
using line_contact::Hertz;
using line_contact::Radius;
using line_contact::solve_by_fft;
using line_contact::solve_by_matrix_inversion;
using line_contact::solve_by_variational_method;

BOOST_AUTO_TEST_CASE(invalid_bodies_and_grids_are_rejected_by_name) {
  const double infinity = std::numeric_limits<double>::infinity();
  const elasticity::Material steel(30e6, 0.3);
  const auto of_radius = [](double radius) { return Radius::of_cylinder("radius2", radius); };
  const auto pair = [&](double radius1, double radius2) {
    return CylinderPair(steel, of_radius(radius1), steel, of_radius(radius2));
  };
  check_refused({
      {"radius2 = 0", [&] { of_radius(0); }},
      {"radius2 = inf", [&] { of_radius(infinity); }},
      {"1/radius1 + 1/radius2 = 0", [&] { pair(1, -1); }},
      {"1/radius1 + 1/radius2 = -0.5", [&] { pair(2, -1); }},
      {"load = 0", [&] { Hertz(pair(1, 3), 0); }},
      {"datum = nan", [] { hertz.approach(NAN); }},
      {"z = -1e-09", [] { line_contact::McEwen(hertz).stress(0, -1e-9); }},
      {"x = nan", [] { line_contact::McEwen(hertz).stress(NAN, 0); }},
      {"relative_curvature", [] { Profile::parabola(0); }},
      {"profile points = 3",
       [] {
         Profile::tabulated({0, 1, 2}, {0, 1, 2});
       }},
      {"profile points = 4",
       [] {
         Profile::tabulated({0, 1, 2, 3}, {0, 1, 2});
       }},
      {"greater than the one before, 1",
       [] {
         Profile::tabulated({0, 1, 1, 2}, {0, 0, 0, 0});
       }},
      {"profile gap = inf",
       [&] {
         Profile::tabulated({0, 1, 2, 3}, {0, 0, infinity, 0});
       }},
      {"nodes = 9: must be from 10 to 16777216", [] { grid_of_width(1, 9); }},
      {"nodes = 16777217", [] { grid_of_width(1, (1 << 24) + 1); }},
      {"domain = 0", [] { grid_of_width(0, 91); }},
      {"centre = nan", [] { grid_of_width(1, 91, NAN); }},
      {"half_width = -1", [] { line_contact::grid_around(-1, 91); }},
  });
}

BOOST_AUTO_TEST_CASE(unsolvable_problems_are_rejected_by_every_method) {
  const Problem paper = cylinders_on(91);
  const auto changed = [&](const std::function<void(Problem&)>& change) {
    Problem problem = paper;
    change(problem);
    return problem;
  };
  const Problem soft = changed([](Problem& p) { p.contact_modulus = 0; });
  const Problem beyond = changed([](Problem& p) {
    p.profile = wavy_profile();
    p.grid = grid_of_width(1.2, 91);
  });
  const Problem huge = changed([](Problem& p) { p.grid.spacing = 1e60; });
  const Problem tiny = changed([](Problem& p) { p.profile = Profile::parabola(1e-135); });
  const Problem narrow = changed([](Problem& p) { p.grid.spacing *= 0.6; });
  const Problem measured = changed([](Problem& p) {
    p.profile = wavy_profile();
    p.grid = grid_of_width(0.1, 91, 0.05);
  });
  for (const auto& solve :
       {+[](const Problem&p, double P) { return solve_by_fft(p, P); },
        +[](const Problem&p, double P) { return solve_by_matrix_inversion(p, P); },
        +[](const Problem&p, double P) { return solve_by_variational_method(p, P); }}) {
    check_refused({
        {"load = 0", [&] { solve(paper, 0); }},
        {"load = nan", [&] { solve(paper, NAN); }},
        {"load = 1e+120: must be less than ", [&] { solve(paper, 1e120); }},
        {"contact_modulus = 0", [&] { solve(soft, load); }},
        {"within the profile's points, from -0.4 to 0.5", [&] { solve(beyond, load); }},
        {"gap at x = ", [&] { solve(huge, load); }},
        {"largest gap on the grid", [&] { solve(tiny, load); }},
        {"must be wider: the contact reaches its end at x = -", [&] { solve(narrow, load); }},
        {"and the profile is given from -0.4 to 0.5", [&] { solve(measured, 30 * load); }},
    });
  }
  check_refused({
      {"tolerance = 0", [&] { solve_by_fft(paper, load, 0); }},
      {"tolerance = 0.02: must be from 1e-13", [&] { solve_by_fft(paper, load, 0.02); }},
      {"nodes = 10001: must be at most 10000",
       [] { solve_by_matrix_inversion(cylinders_on(10001), load); }},
      {"nodes = 10001", [] { solve_by_variational_method(cylinders_on(10001), load); }},
      {"datum = 0: must be outside the contact",
       [&] { solve_by_matrix_inversion(paper, load).approach(0); }},
      {"of triangular elements",
       [] {
         stress_beneath(solve_by_matrix_inversion(cylinders_on(91, Element::uniform), load), 0, 1);
       }},
      {"away from the edge of the load",
       [] {
         const auto s = solve_by_matrix_inversion(cylinders_on(91, Element::uniform), load);
         surface_slope(s, s.grid.x(45) + s.grid.spacing / 2);
       }},
  });
}

BOOST_AUTO_TEST_CASE(a_contact_of_few_nodes_is_an_error_with_a_sufficient_number) {
  // From one node to seven, on grids with and without a node at the centre, nested and not.
  for (const Eigen::Index n_nodes : {91, 511, 513, 1024, 4097, 100'000}) {
    for (const double part : {1e-3, 0.1, 1.0, 1.9, 3.0, 6.0}) {  // the half-width in spacings
      const double spacing = cases[0].width / static_cast<double>(n_nodes);
      const double tiny = load * std::pow(part * spacing / hertz.half_width(), 2);
      const auto solve = [&] { solve_by_fft(cylinders_on(n_nodes), tiny); };
      if (part < 3.5) {
        check_refused({{"must be 8 or more: use at least", solve}});
        if (n_nodes < 1000) {
          check_refused({{"must be 8 or more: use at least",
                          [&] { solve_by_matrix_inversion(cylinders_on(n_nodes), tiny); }}});
        }
      } else {
        BOOST_CHECK_NO_THROW(solve());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_number_of_nodes_in_the_message_suffices) {
  const double tiny = load * std::pow(0.005, 2);
  const std::string message =
      message_of<sys::InvalidQuantity>([&] { solve_by_fft(cylinders_on(400), tiny); });
  const std::string words = "use at least ";
  const auto needed =
      static_cast<Eigen::Index>(std::stod(message.substr(message.find(words) + words.size())));
  BOOST_TEST_CONTEXT(message) {
    BOOST_CHECK_NO_THROW(solve_by_fft(cylinders_on(needed), tiny));
  }
}

BOOST_AUTO_TEST_SUITE_END()
