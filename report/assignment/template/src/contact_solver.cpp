// SPDX-License-Identifier: GPL-3.0-or-later
// Exercise 5: two cylinders pressed together.
#include <cmath>
#include <limits>
#include <vector>

#include "assignment/given/student_functions.hpp"

namespace exercise {
namespace {

// BEGIN SOLUTION
double contact_modulus(const Cylinders& c) {
  const auto compliance = [](const Material& m) { return (1 - m.poisson * m.poisson) / m.young; };
  return 1 / (compliance(c.material1) + compliance(c.material2));
}

// The data that stay the same during the search for the nodes in contact.
struct Problem {
  Grid grid;
  double line_load;
  std::vector<double> influence;    // A_0, A_1, …
  std::vector<double> initial_gap;  // h_i

  double coefficient(int i, int j) const {
    return influence[static_cast<std::size_t>(std::abs(i - j))];
  }
};

Problem assemble(const Cylinders& cylinders, const Grid& grid, double datum, double line_load) {
  Problem problem{grid, line_load, {}, {}};
  const double modulus = contact_modulus(cylinders);
  const double curvature = 1 / cylinders.radius1 + 1 / cylinders.radius2;
  for (int i = 0; i < grid.n_nodes; ++i) {
    problem.influence.push_back(influence_coefficient(modulus, grid.spacing, datum, i));
    problem.initial_gap.push_back(curvature * grid.x(i) * grid.x(i) / 2);
  }
  return problem;
}

// Solves for the pressures at the touching nodes and, as the last unknown, δ. The unit of the
// pressures is 1/A_0, so that all entries of the matrix have the same magnitude.
std::vector<double> solve_touching(const Problem& problem, const std::vector<int>& touching) {
  const std::size_t n = touching.size();
  const double unit = problem.influence[0];
  std::vector<std::vector<double>> matrix(n + 1, std::vector<double>(n + 1));
  std::vector<double> right_side(n + 1);
  for (std::size_t row = 0; row < n; ++row) {
    const int i = touching[row];
    for (std::size_t column = 0; column < n; ++column) {
      matrix[row][column] = problem.coefficient(i, touching[column]) / unit;
    }
    matrix[row][n] = -1;
    matrix[n][row] = 1;
    right_side[row] = -problem.initial_gap[static_cast<std::size_t>(i)];
  }
  right_side[n] = problem.line_load / problem.grid.spacing * unit;
  std::vector<double> unknowns = solve_linear_equations(matrix, right_side);
  for (std::size_t row = 0; row < n; ++row) unknowns[row] /= unit;
  return unknowns;
}

double half_width(const Grid& grid, const std::vector<double>& pressure) {
  double sum = 0;
  double moment = 0;
  for (int i = 0; i < grid.n_nodes; ++i) {
    const double p = pressure[static_cast<std::size_t>(i)];
    sum += p;
    moment += p * (grid.x(i) * grid.x(i) + grid.spacing * grid.spacing / 6);
  }
  return 2 * std::sqrt(moment / sum);
}

// Finds the touching nodes of the next pass: those with positive pressure and those that penetrate.
std::vector<int> revise(const Problem& problem, const Contact& contact) {
  std::vector<int> touching;
  for (int i = 0; i < problem.grid.n_nodes; ++i) {
    double gap = problem.initial_gap[static_cast<std::size_t>(i)] - contact.approach;
    for (int j = 0; j < problem.grid.n_nodes; ++j) {
      gap += problem.coefficient(i, j) * contact.pressure[static_cast<std::size_t>(j)];
    }
    const double pressure = contact.pressure[static_cast<std::size_t>(i)];
    if (pressure > 0 || (pressure == 0 && gap < 0)) touching.push_back(i);
  }
  return touching;
}
// END SOLUTION

}  // namespace

Contact solve_contact(const Cylinders& cylinders, const Grid& grid, double datum,
                      double line_load) {
  // BEGIN SOLUTION
  // STUB: const double unknown = std::numeric_limits<double>::quiet_NaN();
  // STUB: return {unknown, unknown, {}};
  const Problem problem = assemble(cylinders, grid, datum, line_load);
  std::vector<int> touching;
  for (int i = 0; i < grid.n_nodes; ++i) touching.push_back(i);
  Contact contact{};
  for (int pass = 0; pass < 100; ++pass) {
    const std::vector<double> unknowns = solve_touching(problem, touching);
    contact.approach = unknowns.back();
    contact.pressure.assign(static_cast<std::size_t>(grid.n_nodes), 0);
    for (std::size_t k = 0; k < touching.size(); ++k) {
      contact.pressure[static_cast<std::size_t>(touching[k])] = unknowns[k];
    }
    std::vector<int> revised = revise(problem, contact);
    if (revised == touching) break;
    touching = revised;
  }
  contact.half_width = half_width(grid, contact.pressure);
  return contact;
  // END SOLUTION
}

}  // namespace exercise
