// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/mesh.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "block/discretization.hpp"
#include "elasticity/load_shapes.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(mesh_test)

BOOST_AUTO_TEST_CASE(graded_lines_reach_the_smallest_size_and_grow_by_the_ratio_at_most) {
  const auto lines = block::graded_lines({{-1, 0.2}, {0.1, 0.003}, {0.7, 0.05}}, 0.3);

  BOOST_TEST(lines.front() == -1.0);
  BOOST_TEST(lines.back() == 0.7);
  BOOST_TEST(std::is_sorted(lines.begin(), lines.end()));
  const auto kink = std::find(lines.begin(), lines.end(), 0.1);
  BOOST_REQUIRE(kink != lines.end());
  BOOST_TEST(*(kink + 1) - 0.1 == 0.003, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(0.1 - *(kink - 1) == 0.003, boost::test_tools::tolerance(1e-10));
  for (auto line = kink + 1; *(line + 1) < 0.4; ++line) {
    BOOST_TEST((*(line + 1) - 0.1) / (*line - 0.1) <= 1 / 0.3 + 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(every_kink_of_every_load_is_a_line_of_the_mesh) {
  const block::Rectangle rectangle(2, 1);
  const auto flat =
      elasticity::distributed_load([](double) { return 3.0; }, nullptr, {-0.1, -0.06, 0.06, 0.1});
  const auto triangle = elasticity::LinearFall(3, 0, 0.1);

  const block::Mesh mesh = block::graded_mesh(rectangle, {flat, triangle}, {});

  for (const double kink : {-1.0, -0.1, -0.06, 0.0, 0.06, 0.1, 1.0}) {
    BOOST_TEST(std::count(mesh.x_lines().begin(), mesh.x_lines().end(), kink) == 1);
  }
}

BOOST_AUTO_TEST_CASE(kinks_that_rounding_set_apart_are_one) {
  const double next = std::nextafter(0.1, 1);
  const auto one = elasticity::LinearFall(3, 0, 0.1);
  const auto other = elasticity::LinearFall(3, 0, next);
  const auto whole = elasticity::LinearFall(3, 0, std::nextafter(1.0, 0));

  BOOST_TEST(block::kinks_of({one, other}).size() == 3U);
  const block::Mesh mesh = block::graded_mesh({2, 1}, {one, other, whole}, {});
  for (std::size_t i = 1; i < mesh.x_lines().size(); ++i) {
    BOOST_TEST(mesh.x_lines()[i] - mesh.x_lines()[i - 1] > 1e-4);
  }
  BOOST_TEST(mesh.x_lines().front() == -1.0);
  BOOST_TEST(mesh.x_lines().back() == 1.0);
}

BOOST_AUTO_TEST_CASE(each_level_of_refinement_adds_elements) {
  const auto load = elasticity::LinearFall(3, 0.6, 0.1);
  block::Index last = 0;

  for (int refine = 0; refine <= 6; ++refine) {
    const auto mesh = block::graded_mesh({2, 1}, {load}, {.order = 2, .refine = refine});
    BOOST_TEST(mesh.n_elements() > last);
    last = mesh.n_elements();
  }
}

BOOST_AUTO_TEST_CASE(locate_finds_the_element_of_every_node) {
  const block::Mesh mesh(3, {-1, -0.25, 0.5, 2}, {0, 0.125, 1});

  for (block::Index e = 0; e < mesh.n_elements(); ++e) {
    const block::Element element = mesh.element(e);
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        const Eigen::Vector2d position = mesh.position(mesh.node(element, i, j));
        const block::LocalPoint local = mesh.locate(position.x(), position.y());
        BOOST_TEST(local.element == e);
        BOOST_TEST(std::abs(element.x0 + element.width() * (1 + local.xi) / 2 - position.x()) <
                   1e-15);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(points_outside_and_lines_out_of_order_are_refused) {
  const block::Mesh mesh(2, {-1, 1}, {0, 1});

  BOOST_CHECK_THROW(mesh.locate(1.0001, 0.5), sys::InvalidQuantity);
  BOOST_CHECK_THROW(mesh.locate(0, -0.0001), sys::InvalidQuantity);
  BOOST_CHECK_THROW(mesh.locate(std::nan(""), 0), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::Mesh(0, {-1, 1}, {0, 1}), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::Mesh(2, {-1}, {0, 1}), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::Mesh(2, {-1, 1}, {0, 1, 1}), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
