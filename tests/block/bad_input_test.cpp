// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that an analysis refuses, with the quantity its message names.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "block/element_stiffness.hpp"
#include "block/paper_block.hpp"
#include "elasticity/concentrated_load.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(bad_input_test)

namespace {

const elasticity::Load load = elasticity::LinearFall(1000, 0.6, 0.01);

auto names(const std::string& quantity) {
  return [quantity](const sys::InvalidQuantity& e) { return e.quantity() == quantity; };
}

block::Analysis analyse(const elasticity::Load& what, const block::Discretization& how = {}) {
  return {paper_block::rectangle, paper_block::material, {what}, how};
}

}  // namespace

BOOST_AUTO_TEST_CASE(load_outside_the_block_is_refused) {
  const auto reaching = [](double begin, double end) {
    return elasticity::distributed_load([](double) { return 1.0; }, nullptr, {begin, end});
  };
  const auto shear = elasticity::distributed_load(nullptr, [](double) { return 1.0; }, {0.9, 1.1});

  BOOST_CHECK_EXCEPTION(analyse(reaching(-1.01, 0)), sys::InvalidQuantity,
                        names("begin of the load"));
  BOOST_CHECK_EXCEPTION(analyse(reaching(0, 1.01)), sys::InvalidQuantity, names("end of the load"));
  BOOST_CHECK_EXCEPTION(analyse(shear), sys::InvalidQuantity, names("end of the load"));
  BOOST_CHECK_EXCEPTION(
      analyse(load).on(block::with_sides(block::Support::free)).solve(reaching(0, 1.01)),
      sys::InvalidQuantity, names("end of the load"));
}

BOOST_AUTO_TEST_CASE(load_on_the_whole_top_is_accepted) {
  const auto whole = elasticity::distributed_load([](double) { return 1.0; }, nullptr, {-1, 1});

  const auto solution = analyse(whole, {.order = 4, .refine = 0})
                            .on(block::with_sides(block::Support::free))
                            .solve(whole);

  BOOST_CHECK_CLOSE(solution.fine().applied().force.y(), 2.0, 1e-10);
}

BOOST_AUTO_TEST_CASE(concentrated_and_absent_loads_are_refused) {
  BOOST_CHECK_EXCEPTION(analyse(elasticity::ConcentratedLoad(10)), sys::InvalidQuantity,
                        names("concentrated force"));
  BOOST_CHECK_EXCEPTION(analyse({}), sys::InvalidQuantity, names("number of loads"));
}

BOOST_AUTO_TEST_CASE(sizes_orders_and_levels_out_of_range_are_refused) {
  for (const double size : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    BOOST_CHECK_EXCEPTION(block::Rectangle(size, 1), sys::InvalidQuantity, names("width"));
    BOOST_CHECK_EXCEPTION(block::Rectangle(2, size), sys::InvalidQuantity, names("height"));
  }
  for (const int order : {-1, 0, 1, 11}) {
    BOOST_CHECK_EXCEPTION(analyse(load, {.order = order}), sys::InvalidQuantity, names("order"));
  }
  for (const int refine : {-1, 7}) {
    BOOST_CHECK_EXCEPTION(analyse(load, {.refine = refine}), sys::InvalidQuantity, names("refine"));
  }
  for (const double nu : {-1.0, 0.5, 0.7}) {
    BOOST_CHECK_EXCEPTION(elasticity::Material(30e6, nu), sys::InvalidQuantity, names("poisson"));
  }
}

BOOST_AUTO_TEST_CASE(mesh_too_large_for_memory_is_refused_with_the_estimate) {
  BOOST_CHECK_EXCEPTION(analyse(load, {.order = 10, .refine = 6}), sys::InvalidQuantity,
                        names("estimated memory in megabytes"));
  BOOST_CHECK_EXCEPTION(analyse(load, {.max_megabytes = 20}), sys::InvalidQuantity,
                        names("estimated memory in megabytes"));
  BOOST_CHECK_EXCEPTION(analyse(load, {.max_megabytes = 0}), sys::InvalidQuantity,
                        names("max_megabytes"));
}

BOOST_AUTO_TEST_CASE(supports_that_leave_a_rigid_motion_are_refused) {
  using block::Support;
  const block::Analysis analysis = analyse(load, {.order = 2, .refine = 0});
  const auto motions = names("number of rigid motions the supports prevent");

  BOOST_CHECK_EXCEPTION(analysis.on({.bottom = Support::free}), sys::InvalidQuantity, motions);
  BOOST_CHECK_EXCEPTION(analysis.on({.bottom = Support::roller}), sys::InvalidQuantity, motions);
  BOOST_CHECK_EXCEPTION(analysis.on({.left = Support::roller, .bottom = Support::free}),
                        sys::InvalidQuantity, motions);
  BOOST_CHECK_NO_THROW(analysis.on({.left = Support::roller, .bottom = Support::roller}));
  BOOST_CHECK_NO_THROW(analysis.on({.right = Support::clamped, .bottom = Support::free}));
}

BOOST_AUTO_TEST_CASE(failing_factorisation_is_an_exception) {
  // As good as incompressible: λ/μ exceeds 1/ε, and nothing is left of the shear stiffness
  const elasticity::Material rubber(1, 0.5 - 1e-16);

  const auto solve = [&] {
    const block::Analysis analysis(paper_block::rectangle, rubber, {load},
                                   {.order = 3, .refine = 0});
    analysis.on(block::with_sides(block::Support::clamped)).solve(load);
  };

  BOOST_CHECK_THROW(solve(), block::FactorizationError);
}

BOOST_AUTO_TEST_CASE(measures_off_the_block_are_refused) {
  const auto solution = analyse(load, {.order = 2, .refine = 0})
                            .on(block::with_sides(block::Support::free))
                            .solve(load);

  BOOST_CHECK_EXCEPTION(solution.measures({.surface_points = {1.2}}), sys::InvalidQuantity,
                        names("x"));
  BOOST_CHECK_EXCEPTION(solution.measures({.plotting_grid = 0}), sys::InvalidQuantity,
                        names("plotting_grid"));
}

BOOST_AUTO_TEST_SUITE_END()
