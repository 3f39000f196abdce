// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/nested_grids.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "contact/accuracy.hpp"
#include "contact/contact_search.hpp"
#include "line_contact/projected_cg.hpp"
#include "line_contact/solution.hpp"
#include "system/require.hpp"

namespace line_contact {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Interpolates between nodes i and i+1, both in contact, at the fraction t of the way.
double between(const VectorXd& p, Index i, double t) {
  const bool is_inside = i > 0 && i + 2 < p.size() && p[i - 1] > 0 && p[i + 2] > 0;
  if (!is_inside) return p[i] + t * (p[i + 1] - p[i]);
  const double linear = p[i] + t * (p[i + 1] - p[i]);
  const double left = p[i - 1] - 2 * p[i] + p[i + 1];
  const double right = p[i] - 2 * p[i + 1] + p[i + 2];
  return linear - t * (1 - t) / 6 * ((2 - t) * left + (1 + t) * right);
}

// A region of the coarse grid: its edges, and its first and last node.
struct Stretch {
  double begin, end;
  Index first, last;
};

// The square root of the fraction of the way from the edge to the end node; 1 if they coincide.
double rise_from_edge(double way, double whole) {
  return whole > 0 ? std::sqrt(std::clamp(way / whole, 0.0, 1.0)) : 1;
}

double pressure_at(const Grid& coarse, const VectorXd& p, const Stretch& stretch, double x) {
  const double position = (x - coarse.x(0)) / coarse.spacing;
  if (position < static_cast<double>(stretch.first)) {
    const double end_node = coarse.x(stretch.first);
    return p[stretch.first] * rise_from_edge(x - stretch.begin, end_node - stretch.begin);
  }
  if (position >= static_cast<double>(stretch.last)) {
    const double end_node = coarse.x(stretch.last);
    return p[stretch.last] * rise_from_edge(stretch.end - x, stretch.end - end_node);
  }
  const auto i = static_cast<Index>(position);
  return between(p, i, position - static_cast<double>(i));
}

}  // namespace

VectorXd prolongate(const Grid& coarse, const VectorXd& pressure, const Grid& fine) {
  VectorXd result = VectorXd::Zero(fine.n_nodes);
  for (const Region& region : regions_in_contact(coarse, pressure)) {
    const double middle = (region.begin + region.end) / 2;
    auto first = static_cast<Index>(std::lround((middle - coarse.x(0)) / coarse.spacing));
    first = std::clamp<Index>(first, 0, coarse.n_nodes - 1);
    Index last = first;
    while (first > 0 && pressure[first - 1] > 0) --first;
    while (last + 1 < coarse.n_nodes && pressure[last + 1] > 0) ++last;
    const Stretch stretch{region.begin, region.end, first, last};

    const auto index_at = [&](double x) { return (x - fine.x(0)) / fine.spacing; };
    const auto from = static_cast<Index>(std::ceil(std::max(0.0, index_at(region.begin))));
    const auto to = static_cast<Index>(
        std::floor(std::min(static_cast<double>(fine.n_nodes - 1), index_at(region.end))));
    for (Index i = from; i <= to; ++i)
      result[i] = pressure_at(coarse, pressure, stretch, fine.x(i));
  }
  return result;
}

namespace {

// One grid of the sequence, with its nodal loads and the gap that they leave.
struct Level {
  Grid grid;
  VectorXd phi;
  VectorXd gap = {};
  double error = 0;
  contact::Work work = {};
};

// The load of a node that has just entered the contact: almost nothing.
constexpr double touching = 1e-300;

VectorXd rises_of(const Profile& profile, const Grid& grid, Index first, Index n) {
  return VectorXd::NullaryExpr(
      n - 1, [&](Index i) { return profile.rise(grid.x(first + i), grid.x(first + i + 1)); });
}

// A window leaves room on either side of the contact, because the contact from the coarser grid is
// wrong by a few nodes, more the wider it is. Too little room costs a second search, too much makes
// every transform longer.
constexpr Index least_room = 8;            // nodes
constexpr Index nodes_per_room_node = 64;  // nodes in contact per further node of room

// The coarsest grid has at most this many nodes. Starting from a uniform pressure, it takes
// microseconds and a few revisions of the contact.
constexpr Index most_nodes_of_coarsest = 128;

// The part of a grid that contains all contact, with room for it to grow.
struct Window {
  Index first;
  Index n;
};

Window window_around(const VectorXd& phi) {
  Index first = 0;
  Index last = phi.size() - 1;
  while (phi[first] == 0) ++first;
  while (phi[last] == 0) --last;
  const Index margin = least_room + (last - first) / nodes_per_room_node;
  first = std::max<Index>(0, first - margin);
  last = std::min(phi.size() - 1, last + margin);
  return {first, last - first + 1};
}

class LevelSolver {
 public:
  // looks_everywhere: whether to satisfy eq. (1b) on the whole grid, or only around the contact.
  LevelSolver(const Problem& problem, double tolerance, bool looks_everywhere)
      : problem_(problem), tolerance_(tolerance), looks_everywhere_(looks_everywhere) {}

  // Improves level.phi, whose positive nodes are the first guess of the contact. Keeps its sum.
  void solve(Level& level) const {
    const double total = level.phi.sum();
    for (bool is_complete = false; !is_complete;) {
      const Window window = window_around(level.phi);
      is_complete =
          search(level, window) && (!looks_everywhere_ || enters_nowhere_else(level, window));
      level.phi *= total / level.phi.sum();
    }
  }

 private:
  // Finds the contact within the window; false if it grew to one of its ends.
  bool search(Level& level, const Window& window) const {
    InfluenceOperator influence(problem_.element, window.n);
    const VectorXd rises = rises_of(problem_.profile, level.grid, window.first, window.n);
    ProjectedCg pressures(influence, rises);
    contact::ContactSearch contact_search;
    auto stretch = level.phi.segment(window.first, window.n);
    VectorXd phi = stretch;
    const double total = phi.sum();
    contact::ContactMask in_contact = phi.array() > 0;
    const bool is_cut_left = window.first > 0;
    const bool is_cut_right = window.first + window.n < level.grid.n_nodes;
    bool settled = false;
    bool has_room = true;
    while (!settled && has_room) {
      // Solve eq. (1a) for the present contact, then revise the contact
      if (++level.work.revisions > contact::max_revisions) {
        throw contact::ContactError(
            fmt::format("the contact did not settle in {} solves", contact::max_revisions));
      }
      pressures.solve(phi, in_contact, tolerance_);
      settled =
          contact_search.revise(in_contact, phi, pressures.gap(), tolerance_ * phi.maxCoeff());

      // Remove tension and the nodes that left the contact, then restore the load
      phi = in_contact.select(phi.cwiseMax(0), 0);
      phi *= total / phi.sum();
      has_room = !(is_cut_left && in_contact[0]) && !(is_cut_right && in_contact[window.n - 1]);
    }
    stretch = in_contact.select(phi.cwiseMax(touching), 0);
    level.error = pressures.error();
    level.work.iterations += pressures.work().iterations;
    level.work.products += pressures.work().products;
    return settled && has_room;
  }

  // Whether eq. (1b) holds on the whole grid; where it does not, puts nodes in contact.
  bool enters_nowhere_else(Level& level, const Window& window) const {
    // Compute the gap g = h − δ − Tφ on the whole grid from its differences
    const Index n = level.grid.n_nodes;
    const VectorXd rises =
        rises_of(problem_.profile, level.grid, 0, n) -
        differences_over_grid(problem_.element, level.phi.segment(window.first, window.n),
                              window.first, n);
    ++level.work.products;
    Index start = 0;
    level.phi.maxCoeff(&start);
    level.gap = added_up(rises, start);
    const contact::ContactMask in_contact = level.phi.array() > 0;
    level.gap.array() -= in_contact.select(level.gap, 0).sum() / in_contact.cast<double>().sum();

    // Put nodes that penetrate outside the window in contact
    const double smallest_gap = tolerance_ * level.phi.maxCoeff();
    bool enters = false;
    for (Index i = 0; i < n; ++i) {
      const bool is_outside = i < window.first || i >= window.first + window.n;
      if (!is_outside || level.gap[i] >= -smallest_gap) continue;
      level.phi[i] = touching;
      enters = true;
    }
    return !enters;
  }

  const Problem& problem_;
  double tolerance_;
  bool looks_everywhere_;
};

// Halves the number of elements over the domain repeatedly; the coarsest grid comes first.
std::vector<Grid> nested_grids(const Grid& finest) {
  std::vector<Grid> grids{finest};
  while (grids.back().n_nodes > most_nodes_of_coarsest) {
    Grid coarser = grids.back();
    coarser.n_nodes = (coarser.n_nodes + 1) / 2;
    coarser.spacing = finest.width() / static_cast<double>(coarser.n_nodes);
    grids.push_back(coarser);
  }
  std::reverse(grids.begin(), grids.end());
  return grids;
}

}  // namespace

double total_phi(const Problem& problem, double line_load) {
  const double total =
      2 * sys::require_positive("load", line_load) / (std::numbers::pi * problem.contact_modulus);
  if (!(total < contact::largest_length)) {
    throw sys::InvalidQuantity(
        "load", line_load,
        fmt::format("less than {:.3g}", line_load / total * contact::largest_length));
  }
  return total;
}

NodalLoads solve_on_nested_grids(const Problem& problem, double line_load, double tolerance) {
  const double total = total_phi(problem, line_load);
  Level level{problem.grid, {}};
  for (const Grid& grid : nested_grids(problem.grid)) {
    VectorXd phi = level.phi.size() == 0 ? VectorXd::Zero(grid.n_nodes)
                                         : prolongate(level.grid, level.phi, grid);
    // A contact of one or two nodes may fall between the nodes of the next grid
    if (!(phi.sum() > 0)) phi.setOnes();
    phi *= total / phi.sum();
    level = {grid, std::move(phi)};
    constexpr double enough_to_start_from = 1e-6;  // less than the interpolation error
    const bool is_finest = grid.n_nodes == problem.grid.n_nodes;
    const double wanted = is_finest ? tolerance : std::max(tolerance, enough_to_start_from);
    LevelSolver(problem, wanted, is_finest).solve(level);
  }
  return {std::move(level.phi), std::move(level.gap), level.error, level.work};
}

}  // namespace line_contact
