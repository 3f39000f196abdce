// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/solver.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "contact/contact_search.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/energy.hpp"
#include "line_contact/power_law.hpp"
#include "line_contact/rounded_punch.hpp"
#include "line_contact/wedge.hpp"
#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(fft_solver_test)

using Eigen::Index;
using Eigen::VectorXd;
using line_contact::Element;
using line_contact::Grid;
using line_contact::grid_of_width;
using line_contact::one_sided_grid;
using line_contact::Problem;
using line_contact::Profile;
using line_contact::Progress;
using line_contact::Region;
using line_contact::Solution;
using line_contact::solve_by_fft;
using line_contact::solve_by_matrix_inversion;
using line_contact::solve_by_variational_method;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr Element elements[] = {Element::point, Element::uniform, Element::triangular};
constexpr double modulus = 913.7;
constexpr double load = 3.461;
constexpr double curvature = 0.571;

// E* of two alike bodies of E = 2(1 − 0.09)E*, one of them flat.
const line_contact::CylinderPair cylinders(elasticity::Material(2 * 0.91 * modulus, 0.3),
                                           line_contact::Radius::of_cylinder("radius1",
                                                                             1 / curvature),
                                           elasticity::Material(2 * 0.91 * modulus, 0.3),
                                           line_contact::Radius::of_plane());
const line_contact::Hertz hertz(cylinders, load);

// A parabola with waves on it, its lowest point aside, known at 120 points from −0.4 to 0.5.
double wavy_gap(double x) {
  return 0.3 * (x - 0.03) * (x - 0.03) + 0.004 * std::cos(71 * x + 0.4);
}

Profile wavy_profile() {
  std::vector<double> x, gap;
  for (int i = 0; i < 120; ++i) {
    x.push_back(-0.4 + 0.9 * i / 119);
    gap.push_back(wavy_gap(x.back()));
  }
  return Profile::tabulated(x, gap);
}

struct Case {
  const char* name;
  Profile profile;
  double width;  // of the domain
  double centre = 0;
};

// Domains a fifth to a half wider than the contact.
const std::vector<Case> cases{
    {"cylinders", Profile::parabola(curvature), 2.385 * hertz.half_width()},
    {"wedge", Profile::wedge(0.0371),
     2.5 * line_contact::Wedge(modulus, 0.0371, load).half_width()},
    {"rounded punch", Profile::rounded_punch(0.063, 1.7),
     2.7 * line_contact::RoundedPunch(modulus, 0.063, 1.7, load).half_width()},
    {"power law", Profile::power_law(57, 3),
     3.1 * line_contact::PowerLaw(modulus, 57, 3, load).half_width()},
    {"wavy", wavy_profile(), 0.81, 0.07}};

Problem problem_of(const Case& c, Index n_nodes, Element element = Element::triangular) {
  return {c.profile, modulus, grid_of_width(c.width, n_nodes, c.centre), element};
}

Problem cylinders_on(Index n_nodes, Element element = Element::triangular) {
  return problem_of(cases[0], n_nodes, element);
}

double difference(const VectorXd& a, const VectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.maxCoeff();
}

// The slope of ln(error) over ln(spacing), fitted: single errors scatter with where the edge falls
// between nodes.
class Fit {
 public:
  void add(double spacing, double error) {
    const double x = std::log(spacing);
    const double y = std::log(error);
    n_ += 1, x_ += x, y_ += y, xx_ += x * x, xy_ += x * y;
  }
  double order() const { return (n_ * xy_ - x_ * y_) / (n_ * xx_ - x_ * x_); }

 private:
  double n_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0;
};

// Root of the mean square over |x| < a/2, relative to the peak.
double error_inside(const Solution& s) {
  double squares = 0;
  double n_inside = 0;
  for (Index i = 0; i < s.grid.n_nodes; ++i) {
    const double x = s.grid.x(i);
    if (std::abs(x) > 0.5 * hertz.half_width()) continue;
    squares += std::pow((s.pressure[i] - hertz.pressure(x)) / hertz.peak_pressure(), 2);
    n_inside += 1;
  }
  return std::sqrt(squares / n_inside);
}

auto names(const char* quantity) {
  return [=](const InvalidQuantity& e) { return e.quantity() == quantity; };
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_three_methods_find_the_same_pressure_gap_and_approach) {
  for (const Case& c : cases) {
    for (const Element element : elements) {
      for (const Index n_nodes : {150, 161}) {
        const Problem problem = problem_of(c, n_nodes, element);
        const Solution inverted = solve_by_matrix_inversion(problem, load);
        const Solution by_fft = solve_by_fft(problem, load, 1e-13);
        const Solution least = solve_by_variational_method(problem, load);
        const double datum = 2.385 * c.width;

        BOOST_TEST_CONTEXT(c.name << ", " << name_of(element) << ", " << n_nodes) {
          BOOST_TEST(by_fft.n_in_contact() == inverted.n_in_contact());
          BOOST_TEST(difference(by_fft.pressure, inverted.pressure) < 1e-11);
          BOOST_TEST(difference(least.pressure, inverted.pressure) < 1e-9);
          BOOST_TEST(difference(by_fft.gap, inverted.gap) < 1e-12);
          BOOST_TEST(relative_difference(by_fft.approach(datum), inverted.approach(datum)) < 1e-12);
          BOOST_TEST(relative_difference(energy(problem, by_fft), energy(problem, inverted)) <
                     1e-12);
          BOOST_TEST(relative_difference(energy(problem, least), energy(problem, inverted)) <
                     1e-12);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(one_side_with_its_mirror_image_is_the_same_contact) {
  for (const Case& c : cases) {
    if (!c.profile.is_symmetric()) continue;
    for (const Element element : elements) {
      const Problem both = problem_of(c, 161, element);
      const Problem half{c.profile, modulus, one_sided_grid(c.width, 81), element};
      const VectorXd right = solve_by_fft(both, load, 1e-13).pressure.tail(81);
      const Solution by_fft = solve_by_fft(half, load, 1e-13);

      BOOST_TEST_CONTEXT(c.name << ", " << name_of(element)) {
        BOOST_TEST(by_fft.grid.is_one_sided);
        BOOST_TEST(difference(by_fft.pressure, right) < 1e-12);
        BOOST_TEST(difference(solve_by_matrix_inversion(half, load).pressure, right) < 1e-11);
        BOOST_TEST(difference(solve_by_variational_method(half, load).pressure, right) < 1e-9);
        BOOST_TEST(by_fft.residuals.load < 1e-13 * load);
        BOOST_TEST(difference(by_fft.gap, solve_by_matrix_inversion(half, load).gap) < 1e-12);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(any_small_number_of_nodes_is_solved_as_by_matrix_inversion) {
  // 128 nodes are the coarsest of the nested grids, 129 have a coarser one of 65.
  for (const Index n_nodes : {5, 6, 7, 31, 64, 127, 128, 129, 130, 257, 258, 385}) {
    // a few nodes reach less far: their ends lie half a spacing inside the domain
    const auto n = static_cast<double>(n_nodes);
    Problem problem = cylinders_on(n_nodes);
    problem.grid.spacing *= n / (n - 2);
    BOOST_TEST_CONTEXT(n_nodes << " nodes") {
      BOOST_TEST(difference(solve_by_fft(problem, load, 1e-13).pressure,
                            solve_by_matrix_inversion(problem, load).pressure) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(one_or_two_nodes_bear_a_tiny_load) {
  for (const Element element : elements) {
    for (const Index n_nodes : {600, 601}) {
      const Solution s = solve_by_fft(cylinders_on(n_nodes, element), 1e-7);

      BOOST_TEST(s.n_in_contact() == (n_nodes == 601 ? 1 : 2));
      BOOST_TEST(relative_difference(s.line_load(), 1e-7) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_conditions_of_contact_hold) {
  for (const Case& c : cases) {
    const Solution s = solve_by_fft(problem_of(c, 1000), load);
    const double unit = s.peak_pressure() / s.pressure_per_phi;
    BOOST_TEST_CONTEXT(c.name) {
      BOOST_TEST(s.pressure.minCoeff() == 0);
      BOOST_TEST(s.residuals.gap < 1e-9 * unit);
      BOOST_TEST(s.residuals.separation < 1e-9 * unit);
      BOOST_TEST(s.residuals.pressure <= line_contact::default_tolerance * s.peak_pressure());
      BOOST_TEST(s.residuals.load < 1e-13 * load);
    }
  }
}

BOOST_AUTO_TEST_CASE(pressures_converge_to_hertz_inside_with_order_two) {
  Fit inside, peak;
  for (int power = 10; power <= 15; ++power) {
    for (const int odd : {16, 19, 23, 27}) {
      const Solution s = solve_by_fft(cylinders_on((odd << power) / 16 + 1), load, 1e-11);
      inside.add(s.grid.spacing, error_inside(s));
      peak.add(s.grid.spacing, std::abs(s.peak_pressure() / hertz.peak_pressure() - 1));
    }
  }

  BOOST_TEST(std::abs(inside.order() - 2) < 0.25);
  BOOST_TEST(std::abs(peak.order() - 2) < 0.25);
}

BOOST_AUTO_TEST_CASE(sixteen_thousand_nodes_give_hertz_to_1e_8) {
  const Solution s = solve_by_fft(cylinders_on(1 << 14), load);

  BOOST_TEST(error_inside(s) < 1e-8);
  BOOST_TEST(relative_difference(s.peak_pressure(), hertz.peak_pressure()) < 1e-8);
  BOOST_TEST(relative_difference(s.half_width(), hertz.half_width()) < 1e-8);
  const std::vector<Region> regions = s.regions();
  BOOST_REQUIRE(regions.size() == 1);
  BOOST_TEST(std::abs(regions[0].end - hertz.half_width()) < s.grid.spacing / 2);
}

BOOST_AUTO_TEST_CASE(the_closed_forms_are_approached) {
  const line_contact::Wedge wedge(modulus, 0.0371, load);
  const line_contact::RoundedPunch punch(modulus, 0.063, 1.7, load);
  const line_contact::PowerLaw power(modulus, 57, 3, load);
  const Solution of_wedge = solve_by_fft(problem_of(cases[1], 2000), load);
  const Solution of_punch = solve_by_fft(problem_of(cases[2], 2000), load);
  const Solution of_power = solve_by_fft(problem_of(cases[3], 2000), load);
  const auto worst = [](const Solution& s, const auto& exact) {
    double error = 0;
    for (Index i = 0; i < s.grid.n_nodes; ++i) {
      const double x = s.grid.x(i);
      const double share = std::abs(x) / exact.half_width();
      if (share < 0.05 || share > 0.95) continue;
      error = std::max(error, std::abs(s.pressure[i] / exact.pressure(x) - 1));
    }
    return error;
  };

  BOOST_TEST(worst(of_wedge, wedge) < 2e-4);
  BOOST_TEST(worst(of_punch, punch) < 5e-4);
  BOOST_TEST(worst(of_power, power) < 2e-5);
}

BOOST_AUTO_TEST_CASE(pressures_are_right_to_the_tolerance) {
  for (const Case& c : cases) {
    const Problem problem = problem_of(c, 2000);
    const Solution best = solve_by_fft(problem, load, line_contact::min_tolerance);
    for (const double tolerance : {1e-3, 1e-5, 1e-8, 1e-10, 1e-12}) {
      const Solution s = solve_by_fft(problem, load, tolerance);
      BOOST_TEST_CONTEXT(c.name << ", tolerance " << tolerance) {
        BOOST_TEST(difference(s.pressure, best.pressure) < tolerance);
        BOOST_TEST(s.residuals.pressure <= tolerance * s.peak_pressure());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(products_on_the_finest_grid_do_not_grow_with_its_nodes) {
  for (int power = 10; power <= 16; power += 2) {
    const Solution s = solve_by_fft(cylinders_on(1 << power), load);

    BOOST_TEST(s.work.products <= 30);
    BOOST_TEST(s.work.iterations < s.work.products);
    BOOST_TEST(s.work.revisions >= 1);
    BOOST_TEST(s.work.revisions <= 6);
  }
}

BOOST_AUTO_TEST_CASE(regions_of_a_wavy_profile_are_found_at_eight_thousand_nodes) {
  const Problem fine = problem_of(cases[4], 1 << 13);
  const Problem coarse = problem_of(cases[4], 512);
  const Solution s = solve_by_fft(fine, load);
  const std::vector<Region> regions = s.regions();
  const std::vector<Region> expected = solve_by_matrix_inversion(coarse, load).regions();

  BOOST_REQUIRE(regions.size() == expected.size());
  BOOST_TEST_MESSAGE(regions.size());
  BOOST_TEST(regions.size() >= 3);
  double sum = 0;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    BOOST_TEST(std::abs(regions[i].begin - expected[i].begin) < coarse.grid.spacing);
    BOOST_TEST(std::abs(regions[i].end - expected[i].end) < coarse.grid.spacing);
    BOOST_TEST(std::abs(regions[i].load - expected[i].load) < 0.01 * load);
    sum += regions[i].load;
  }
  BOOST_TEST(relative_difference(sum, load) < 1e-13);
}

BOOST_AUTO_TEST_CASE(progress_is_reported_from_the_coarsest_grid_to_the_finest) {
  std::vector<Progress> reports;
  const Solution s = solve_by_fft(cylinders_on(2385), load, 1e-10,
                                  [&](const Progress& progress) { reports.push_back(progress); });

  BOOST_REQUIRE(!reports.empty());
  BOOST_TEST(reports.front().n_nodes == 75);  // 2385, 1193, 597, 299, 150, 75
  BOOST_TEST(reports.back().n_nodes == 2385);
  BOOST_TEST(reports.back().revisions == s.work.revisions);
  BOOST_TEST(reports.back().iterations == s.work.iterations);
  for (std::size_t i = 1; i < reports.size(); ++i) {
    const Progress& before = reports[i - 1];
    const Progress& after = reports[i];
    BOOST_TEST(after.n_nodes >= before.n_nodes);
    if (after.n_nodes == before.n_nodes) {
      BOOST_TEST(after.revisions == before.revisions + 1);
      BOOST_TEST(after.iterations >= before.iterations);
    } else {
      BOOST_TEST(after.revisions == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_load_that_fills_the_domain_is_refused_with_a_width_that_holds_it) {
  for (const Case& c : cases) {
    if (!c.profile.is_symmetric()) continue;
    for (const bool is_one_sided : {false, true}) {
      Problem problem = problem_of(c, 300);
      problem.grid.spacing *= 0.2385;
      if (is_one_sided) problem.grid = one_sided_grid(0.2385 * c.width, 150);
      double width = 0;
      BOOST_CHECK_EXCEPTION(
          solve_by_fft(problem, load), InvalidQuantity, [&](const InvalidQuantity& e) {
            width = std::stod(e.allowed().substr(std::string("at least ").size()));
            return e.quantity() == "domain";
          });
      problem.grid = is_one_sided ? one_sided_grid(width, 150) : grid_of_width(width, 300);
      BOOST_CHECK_NO_THROW(solve_by_fft(problem, load));
    }
  }
}

BOOST_AUTO_TEST_CASE(tolerances_out_of_range_are_refused) {
  for (const double bad : {0.0, 0.99e-13, -1.0, 0.01, 1.0, double(NAN)}) {
    BOOST_CHECK_EXCEPTION(line_contact::require_tolerance(bad), InvalidQuantity,
                          names("tolerance"));
    BOOST_CHECK_EXCEPTION(solve_by_fft(cylinders_on(50), load, bad), InvalidQuantity,
                          names("tolerance"));
  }
  BOOST_TEST(line_contact::require_tolerance(line_contact::min_tolerance) ==
             line_contact::min_tolerance);
  BOOST_TEST(line_contact::require_tolerance(0.00999) == 0.00999);
}

BOOST_AUTO_TEST_CASE(loads_and_problems_out_of_range_are_refused) {
  BOOST_CHECK_EXCEPTION(solve_by_fft(cylinders_on(50), 0), InvalidQuantity, names("load"));
  BOOST_CHECK_EXCEPTION(solve_by_fft(cylinders_on(50), NAN), InvalidQuantity, names("load"));
  const Problem one_sided{cases[4].profile, modulus, one_sided_grid(0.2, 50)};
  BOOST_CHECK_EXCEPTION(solve_by_fft(one_sided, load), InvalidQuantity,
                        names("one-sided grid's end"));
}

BOOST_AUTO_TEST_CASE(a_steep_profile_far_outside_leaves_the_pressure_its_digits) {
  // Gaps at the ends of the grid are up to 1e20 times those in contact.
  struct Steep {
    Profile profile;
    double width;
  };
  const std::vector<Steep> steep = {{Profile::power_law(1, 10), 10},
                                    {Profile::power_law(1, 20), 6},
                                    {Profile::rounded_punch(1, 1e9), 2.2}};
  for (const Steep& s : steep) {
    const Problem problem{s.profile, 1.65e7, line_contact::grid_of_width(s.width, 601)};
    const Solution inverted = line_contact::solve_by_matrix_inversion(problem, 2500);
    const Solution fast = solve_by_fft(problem, 2500);
    const Solution variational = line_contact::solve_by_variational_method(problem, 2500);
    const double peak = inverted.peak_pressure();
    BOOST_TEST((fast.pressure - inverted.pressure).cwiseAbs().maxCoeff() < 1e-10 * peak);
    BOOST_TEST((variational.pressure - inverted.pressure).cwiseAbs().maxCoeff() < 1e-9 * peak);
    BOOST_TEST(std::abs(fast.approach(1000) / inverted.approach(1000) - 1) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(what_no_double_can_hold_is_refused) {
  const auto solve = [](const Profile& profile, double width) {
    return solve_by_fft({profile, 1.65e7, line_contact::grid_of_width(width, 300)}, 2500);
  };
  BOOST_CHECK_THROW(solve(Profile::wedge(1e308), 1), sys::InvalidQuantity);
  BOOST_CHECK_THROW(solve(Profile::power_law(1, 20), 1e8), sys::InvalidQuantity);
  BOOST_CHECK_THROW(solve(Profile::parabola(1), 1e150), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
