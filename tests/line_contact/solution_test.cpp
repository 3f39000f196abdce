// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/solution.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <vector>

#include "system/require.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(solution_test)

using Eigen::VectorXd;
using line_contact::Element;
using line_contact::ElementLoads;
using line_contact::Grid;
using line_contact::influence_coefficient;
using line_contact::Problem;
using line_contact::Profile;
using line_contact::Region;
using line_contact::Solution;
using sys::InvalidQuantity;
using tolerance::relative_difference;

namespace {

constexpr Element elements[] = {Element::point, Element::uniform, Element::triangular};
constexpr double c = 0.3;

VectorXd vector(std::initializer_list<double> values) {
  VectorXd result(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

Solution with_pressures(std::initializer_list<double> pressures, Grid grid = {}) {
  Solution s{};
  s.element = Element::triangular;
  s.pressure = vector(pressures);
  s.grid = grid;
  s.grid.n_nodes = s.pressure.size();
  s.grid.spacing = c;
  s.pressure_per_phi = 1;
  return s;
}

const Grid one_sided{.n_nodes = 0, .spacing = 0, .is_one_sided = true};

// ⟨s²⟩ of an element about its node, in units of c²: ∫ s² ds and ∫ s²(1−|s|) ds.
double own_moment(Element element) {
  return element == Element::point ? 0 : element == Element::uniform ? 1. / 12 : 1. / 6;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_load_is_the_sum_of_the_elements_with_mirror_images) {
  BOOST_TEST(relative_difference(with_pressures({0, 1, 2.385, 0.5, 0}).line_load(), c * 3.885) <
             1e-15);
  BOOST_TEST(relative_difference(with_pressures({2.385, 1, 0.5, 0, 0}, one_sided).line_load(),
                                 c * (2.385 + 3)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(the_peak_is_the_greatest_pressure) {
  BOOST_TEST(with_pressures({0, 1, 2.385, 0.5, 0}).peak_pressure() == 2.385);
}

BOOST_AUTO_TEST_CASE(nodes_with_pressure_are_in_contact) {
  BOOST_TEST(with_pressures({0, 1, 0, 1e-300, 0}).n_in_contact() == 2);
}

BOOST_AUTO_TEST_CASE(the_half_width_counts_the_width_of_the_elements_themselves) {
  for (const Element element : elements) {
    Solution one = with_pressures({0, 0, 7, 0, 0});
    Solution two = with_pressures({0, 7, 0, 0, 7, 0});  // at ±3c/2
    one.element = two.element = element;

    BOOST_TEST(std::abs(one.half_width() - 2 * c * std::sqrt(own_moment(element))) < 1e-15);
    BOOST_TEST(relative_difference(two.half_width(),
                                   2 * c * std::sqrt(2.25 + own_moment(element))) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(the_half_width_does_not_depend_on_where_the_contact_lies) {
  const double expected = with_pressures({0, 0, 1, 2, 1, 0, 0}).half_width();
  Solution aside = with_pressures({0, 0, 0, 1, 2, 1, 0});
  aside.grid.centre = -23.85;

  BOOST_TEST(relative_difference(aside.half_width(), expected) < 1e-14);
}

BOOST_AUTO_TEST_CASE(the_half_width_of_one_side_is_that_of_both) {
  for (const Element element : elements) {
    Solution both = with_pressures({0, 1, 2.385, 3, 2.385, 1, 0});
    Solution half = with_pressures({3, 2.385, 1, 0}, one_sided);
    both.element = half.element = element;

    BOOST_TEST(relative_difference(half.half_width(), both.half_width()) < 1e-15);
    BOOST_TEST(relative_difference(half.half_width_by_count(), both.half_width_by_count()) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(the_half_width_by_count_is_half_the_nodes_in_contact) {
  BOOST_TEST(relative_difference(with_pressures({0, 1, 2, 0.1, 0}).half_width_by_count(), 1.5 * c) <
             1e-15);
  BOOST_TEST(relative_difference(with_pressures({1, 2, 0, 0.1, 0}, one_sided).half_width_by_count(),
                                 2.5 * c) < 1e-15);
}

BOOST_AUTO_TEST_CASE(the_square_of_the_pressure_is_extrapolated_to_the_edges) {
  // p² = 9, 5, 1 falls by 4 a node: 0 a quarter of c beyond the last. On the left 0, 4, 9: 4/5 c.
  const Solution s = with_pressures({0, 2, 3, std::sqrt(5.), 1, 0});
  const std::vector<Region> regions = s.regions();

  BOOST_REQUIRE(regions.size() == 1);
  BOOST_TEST(relative_difference(regions[0].begin, s.grid.x(1) - 0.8 * c) < 1e-14);
  BOOST_TEST(relative_difference(regions[0].end, s.grid.x(4) + 0.25 * c) < 1e-14);
  BOOST_TEST(regions[0].n_nodes == 4);
  BOOST_TEST(relative_difference(regions[0].load, s.line_load()) < 1e-15);
}

BOOST_AUTO_TEST_CASE(edges_of_an_ellipse_are_found_to_a_few_hundredths_of_the_spacing) {
  // p² is a parabola of curvature 2/a²: extrapolated by a straight line it misses up to c²/a² of
  // p², and its slope is 2/a, so that the edge is missed by up to c²/(2a)·2.
  for (const double a : {10.1, 10.385, 10.77}) {
    Solution s = with_pressures({});
    s.grid.n_nodes = 93;
    s.pressure = s.grid.nodes().unaryExpr(
        [a](double x) { return std::sqrt(std::max(0., 1 - x * x / (a * a))); });
    const std::vector<Region> regions = s.regions();

    BOOST_REQUIRE(regions.size() == 1);
    BOOST_TEST(std::abs(regions[0].end - a) < c * c / a);
    BOOST_TEST(std::abs(regions[0].begin + a) < c * c / a);
  }
}

BOOST_AUTO_TEST_CASE(an_edge_lies_within_a_spacing_of_the_last_node) {
  // p² falls too slowly to be zero there, or not at all: half a spacing.
  const Solution slow = with_pressures({0, 2, 2.1, 2, 0});
  BOOST_TEST(relative_difference(slow.regions()[0].end, slow.grid.x(3) + c) < 1e-14);
  BOOST_TEST(relative_difference(slow.regions()[0].begin, slow.grid.x(1) - c) < 1e-14);

  const Solution single = with_pressures({0, 0, 2.385, 0, 0});
  BOOST_TEST(relative_difference(single.regions()[0].end, c / 2) < 1e-14);
  BOOST_TEST(relative_difference(single.regions()[0].begin, -c / 2) < 1e-14);

  const Solution rising = with_pressures({0, 3, 2, 3, 0});
  BOOST_TEST(relative_difference(rising.regions()[0].end, rising.grid.x(3) + c / 2) < 1e-14);
}

BOOST_AUTO_TEST_CASE(regions_are_told_apart_from_left_to_right) {
  const Solution s = with_pressures({1, 0, 2.385, 2.385, 0, 0, 3});
  const std::vector<Region> regions = s.regions();

  BOOST_REQUIRE(regions.size() == 3);
  BOOST_TEST(regions[0].n_nodes == 1);
  BOOST_TEST(regions[1].n_nodes == 2);
  BOOST_TEST(regions[2].n_nodes == 1);
  BOOST_TEST(relative_difference(regions[1].load, 2 * c * 2.385) < 1e-15);
  BOOST_TEST(regions[0].end < regions[1].begin);
  BOOST_TEST(regions[1].end < regions[2].begin);
  double load = 0;
  for (const Region& region : regions) load += region.load;
  BOOST_TEST(relative_difference(load, s.line_load()) < 1e-15);
}

BOOST_AUTO_TEST_CASE(without_contact_there_are_no_regions) {
  BOOST_TEST(with_pressures({0, 0, 0, 0, 0}).regions().empty());
}

BOOST_AUTO_TEST_CASE(the_first_region_of_one_side_has_its_mirror_image_if_it_begins_at_the_middle) {
  const Solution middle = with_pressures({3, 2, 0, 1, 1, 0}, one_sided);
  const std::vector<Region> regions = middle.regions();

  BOOST_REQUIRE(regions.size() == 2);
  BOOST_TEST(regions[0].begin == -regions[0].end);
  BOOST_TEST(relative_difference(regions[0].end, c + 0.8 * c) < 1e-15);
  BOOST_TEST(relative_difference(regions[0].load, c * (3 + 2 * 2)) < 1e-15);
  BOOST_TEST(regions[1].begin > 2 * c);
  BOOST_TEST(relative_difference(regions[0].load + regions[1].load, middle.line_load()) < 1e-15);

  const Solution aside = with_pressures({0, 0, 1, 1, 0, 0}, one_sided);
  BOOST_REQUIRE(aside.regions().size() == 1);
  BOOST_TEST(aside.regions()[0].begin > c);
}

BOOST_AUTO_TEST_CASE(the_approach_is_taken_on_the_side_of_the_datum) {
  // One element off the middle: its displacement at the datum is that of its distance from it.
  for (const Element element : elements) {
    Solution s = with_pressures({0, 0, 0, 0, 2.385});
    s.element = element;
    s.pressure_per_phi = 0.57;
    s.approach_at_spacing = 0.7;
    const auto approach_from = [&](double distance) {
      return 0.7 + 2.385 / 0.57 * influence_coefficient(element, distance / c);
    };

    BOOST_TEST(relative_difference(s.approach(5), approach_from(4.4)) < 1e-14);
    BOOST_TEST(relative_difference(s.approach(-5), approach_from(5.6)) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(the_approach_of_one_side_is_that_of_both) {
  Solution both = with_pressures({0, 1, 2.385, 3, 2.385, 1, 0});
  Solution half = with_pressures({3, 2.385, 1, 0}, one_sided);
  both.approach_at_spacing = half.approach_at_spacing = -0.1;

  for (const double datum : {-1.06, 1.06, 5.0, -2385.0}) {
    BOOST_TEST(relative_difference(half.approach(datum), both.approach(datum)) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(a_datum_in_the_contact_is_refused) {
  const Solution s = with_pressures({0, 1, 2.385, 1, 0});  // its edges 1.21 spacings out
  const double infinity = std::numeric_limits<double>::infinity();

  for (const double datum : {0.0, 1.2 * c, -1.2 * c, double(NAN), infinity, -infinity}) {
    BOOST_CHECK_EXCEPTION(s.approach(datum), InvalidQuantity,
                          [](const InvalidQuantity& e) { return e.quantity() == "datum"; });
  }
  BOOST_CHECK_NO_THROW(s.approach(1.22 * c));
  BOOST_CHECK_NO_THROW(s.approach(-1.22 * c));
}

BOOST_AUTO_TEST_CASE(element_loads_become_pressures_with_the_residuals_of_their_gaps) {
  // φ = 2c p/(πE*).
  const Problem problem{Profile::parabola(1), 2.385, {5, c}, Element::uniform};
  const double unit = std::numbers::pi * 2.385 / (2 * c);
  const ElementLoads loads{vector({0, 1, 2, 1.5, 0}),
                           vector({0.2, -0.03, 0.01, 0.02, -0.05}),
                           0.7,
                           1e-3,
                           {.revisions = 3, .iterations = 5, .products = 7}};

  const Solution s = to_solution(problem, 4.5 * c * unit + 0.25, loads);

  BOOST_TEST(relative_difference(s.pressure_per_phi, unit) < 1e-15);
  BOOST_TEST(relative_difference(s.pressure[2], 2 * unit) < 1e-15);
  BOOST_TEST((s.gap == loads.gap));
  BOOST_TEST((s.element == Element::uniform));
  BOOST_TEST(s.grid.spacing == c);
  BOOST_TEST(s.approach_at_spacing == 0.7);
  BOOST_TEST(s.residuals.gap == 0.03);
  BOOST_TEST(s.residuals.separation == 0.05);
  BOOST_TEST(relative_difference(s.residuals.pressure, 2e-3 * unit) < 1e-14);
  BOOST_TEST(relative_difference(s.residuals.load, 0.25) < 1e-13);
  BOOST_TEST(s.work.revisions == 3);
  BOOST_TEST(s.work.iterations == 5);
  BOOST_TEST(s.work.products == 7);
}

BOOST_AUTO_TEST_CASE(where_nothing_penetrates_the_separation_has_no_residual) {
  const Problem problem{Profile::parabola(1), 1, {5, c}};
  const ElementLoads loads{vector({0, 1, 1, 1, 0}), vector({0.2, 0, 0, 0, 0.1}), 0, 0, {}};

  BOOST_TEST(to_solution(problem, 1, loads).residuals.separation == 0);
}

BOOST_AUTO_TEST_SUITE_END()
