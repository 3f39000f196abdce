// SPDX-License-Identifier: GPL-3.0-or-later
// Three methods, three kinds of elements, one contact.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "line_contact/cases.hpp"
#include "line_contact/methods.hpp"
#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(methods_test)

using namespace line_cases;
using Eigen::Index;
using Eigen::VectorXd;
using line_contact::Solution;
using line_contact::solve_by_fft;
using line_contact::solve_by_matrix_inversion;
using line_contact::solve_by_variational_method;
using tolerance::relative_difference;

namespace {

struct Method {
  std::string name;
  std::function<Solution(const Problem&, double line_load)> solve;
  double agrees_to;  // agreement with matrix inversion, relative to the peak
};
const std::vector<Method> methods{
    {"matrix inversion", solve_by_matrix_inversion, 0},
    {"fft", [](const Problem& p, double P) { return solve_by_fft(p, P, 1e-13); }, 1e-11},
    {"variational", solve_by_variational_method, 1e-9}};

double difference(const VectorXd& a, const VectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.maxCoeff();
}

// The fitted slope of ln(error) over ln(spacing): single errors scatter with the position of the
// edge between nodes.
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

// Root mean square over |x| < a/2, relative to the peak.
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

template <class Check>
void for_each_solution(Index n_nodes, const Check& check) {
  for (const Case& c : cases) {
    for (const Element element : elements) {
      const Problem problem = problem_of(c, n_nodes, element);
      for (const Method& method : methods) {
        BOOST_TEST_CONTEXT(c.name << ", " << name_of(element) << ", " << method.name) {
          check(problem, method);
        }
      }
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(all_methods_find_the_pressure_gap_and_approach_of_matrix_inversion) {
  for (const Index n_nodes : {150, 161}) {
    for_each_solution(n_nodes, [](const Problem& problem, const Method& method) {
      const Solution inverted = solve_by_matrix_inversion(problem, load);
      const Solution found = method.solve(problem, load);
      const double datum = 2.385 * problem.grid.width();
      BOOST_TEST(found.n_in_contact() == inverted.n_in_contact());
      BOOST_TEST(difference(found.pressure, inverted.pressure) <= method.agrees_to);
      BOOST_TEST(difference(found.gap, inverted.gap) <= 1e-12);
      BOOST_TEST(relative_difference(found.approach(datum), inverted.approach(datum)) < 1e-12);
    });
  }
}

BOOST_AUTO_TEST_CASE(a_needle_that_coarser_grids_miss_comes_into_contact) {
  // Beside a cylinder, three spacings of the finest grid wide and as high as the cylinder's lowest
  // point; the coarsest grid has a spacing eight times as large.
  const double a = hertz.half_width();
  const double at = 2.003 * a, half_width = 0.01 * a;
  std::vector<double> x, gap;
  for (int i = -140; i <= 140; ++i) {
    const double here = 0.025 * i * a;
    if (std::abs(here - at) < 0.02 * a) {
      for (const int side : {-1, 0, 1}) {
        x.push_back(at + side * half_width);
        gap.push_back(side == 0 ? 0 : curvature / 2 * at * at);
      }
      continue;
    }
    x.push_back(here);
    gap.push_back(curvature / 2 * here * here);
  }
  const Problem problem =
      problem_of({"needle", Profile::tabulated(x, gap), 6 * a}, 1000, Element::triangular);
  const VectorXd inverted = solve_by_matrix_inversion(problem, load).pressure;
  const auto needle = static_cast<Index>((at - problem.grid.begin()) / problem.grid.spacing);

  BOOST_TEST(inverted.segment(needle - 2, 5).maxCoeff() > 0);
  BOOST_TEST(difference(solve_by_fft(problem, load, 1e-13).pressure, inverted) < 1e-10);
}

BOOST_AUTO_TEST_CASE(the_conditions_of_contact_hold) {
  for_each_solution(200, [](const Problem& problem, const Method& method) {
    const Solution s = method.solve(problem, load);
    const double length = s.peak_pressure() * s.grid.spacing / modulus;  // a nodal load
    BOOST_TEST(s.pressure.minCoeff() == 0);
    BOOST_TEST(s.residuals.gap < 1e-9 * length);
    BOOST_TEST(s.residuals.separation < 1e-9 * length);
    BOOST_TEST(s.residuals.load < 1e-13 * load);
    BOOST_TEST(relative_difference(s.line_load(), load) < 1e-13);
  });
}

BOOST_AUTO_TEST_CASE(a_symmetric_contact_has_a_symmetric_pressure) {
  for (const Element element : elements) {
    for (const Method& method : methods) {
      const VectorXd p = method.solve(cylinders_on(151, element), load).pressure;
      BOOST_TEST(difference(p.reverse(), p) < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(other_units_of_length_and_stress_change_nothing) {
  const double length = 2.54e-2, stress = 6.895e3;
  for (const Element element : elements) {
    Problem scaled{Profile::parabola(curvature / length), modulus * stress,
                   line_contact::grid_of_width(cases[0].width * length, 150), element};
    for (const Method& method : methods) {
      const Solution ours = method.solve(cylinders_on(150, element), load);
      const Solution theirs = method.solve(scaled, load * length * stress);
      BOOST_TEST(difference(theirs.pressure / stress, ours.pressure) < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(any_small_number_of_nodes_agrees_with_matrix_inversion) {
  // 128 nodes are the coarsest of the nested grids, 129 have a coarser one of 65.
  for (const Index n_nodes : {13, 31, 64, 127, 128, 129, 130, 257, 258, 385}) {
    const Problem problem = cylinders_on(n_nodes);
    BOOST_TEST_CONTEXT(n_nodes << " nodes") {
      BOOST_TEST(difference(solve_by_fft(problem, load, 1e-13).pressure,
                            solve_by_matrix_inversion(problem, load).pressure) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(pressures_converge_to_hertz_inside_with_order_two) {
  for (const Element element : {Element::triangular, Element::uniform}) {
    Fit inside, peak;
    for (int power = 10; power <= 13; ++power) {
      for (const int odd : {16, 19, 23, 27}) {
        const Solution s =
            solve_by_fft(cylinders_on((odd << power) / 16 + 1, element), load, 1e-11);
        inside.add(s.grid.spacing, error_inside(s));
        peak.add(s.grid.spacing, std::abs(s.peak_pressure() / hertz.peak_pressure() - 1));
      }
    }
    BOOST_TEST(std::abs(inside.order() - 2) < 0.25);
    BOOST_TEST(std::abs(peak.order() - 2) < 0.25);
  }
}

BOOST_AUTO_TEST_CASE(sixteen_thousand_nodes_match_hertz_to_1e_8) {
  const Solution s = solve_by_fft(cylinders_on(1 << 14), load);

  BOOST_TEST(error_inside(s) < 1e-8);
  BOOST_TEST(relative_difference(s.peak_pressure(), hertz.peak_pressure()) < 1e-8);
  BOOST_TEST(relative_difference(s.half_width(), hertz.half_width()) < 1e-8);
}

BOOST_AUTO_TEST_CASE(pressures_are_accurate_to_the_tolerance) {
  for (const Case& c : cases) {
    const Problem problem = problem_of(c, 2000);
    const Solution best = solve_by_fft(problem, load, line_contact::min_tolerance);
    for (const double tolerance : {1e-3, 1e-5, 1e-8, 1e-12}) {
      const Solution s = solve_by_fft(problem, load, tolerance);
      BOOST_TEST_CONTEXT(c.name << ", tolerance " << tolerance) {
        BOOST_TEST(difference(s.pressure, best.pressure) < tolerance);
        BOOST_TEST(s.residuals.pressure <= tolerance * s.peak_pressure());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(products_on_the_finest_grid_do_not_increase_with_its_nodes) {
  for (int power = 10; power <= 16; power += 2) {
    const Solution s = solve_by_fft(cylinders_on(1 << power), load);
    BOOST_TEST(s.work.products <= 20);
    BOOST_TEST(s.work.iterations < s.work.products);
    BOOST_TEST(s.work.revisions <= 4);
  }
}

BOOST_AUTO_TEST_SUITE_END()
