// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <limits>

#include "block/paper_block.hpp"
#include "elasticity/loads.hpp"
#include "refused.hpp"

BOOST_AUTO_TEST_SUITE(refusals_test)

using block::Support;

namespace {

const elasticity::Load load = elasticity::LinearFall(1000, 0.6, 0.01);

elasticity::Load between(double begin, double end) {
  return elasticity::distributed_load([](double) { return 1.0; }, {begin, end});
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_block_rejects_invalid_input) {
  const auto analyse = [](const elasticity::Load& what, block::Discretization how = {}) {
    return block::Analysis(paper_block::rectangle, paper_block::material, {what}, how);
  };
  const block::Analysis analysis = analyse(load, {4, 1});
  const block::RefinedSolution solution = analysis.on({}).solve(load);
  const double infinity = std::numeric_limits<double>::infinity();
  check_refused({
      {"width = 0", [&] { block::Rectangle(0, 1); }},
      {"height = -1", [&] { block::Rectangle(2, -1); }},
      {"height = inf", [&] { block::Rectangle(2, infinity); }},
      {"width = nan", [&] { block::Rectangle(std::nan(""), 1); }},
      {"density = 0",
       [&] {
         block::mass_properties({2, 1}, 0);
       }},
      {"begin of the load = -1.01", [&] { analyse(between(-1.01, 0)); }},
      {"end of the load = 1.01", [&] { analyse(between(0, 1.01)); }},
      {"end of the load = 1.01", [&] { analysis.on({}).solve(between(0, 1.01)); }},
      {"concentrated force = 10", [&] { analyse(elasticity::ConcentratedLoad(10)); }},
      {"number of loads = 1", [&] { analyse({}); }},
      {"order = 3: must be 4 to 10",
       [&] {
         analyse(load, {3, 1});
       }},
      {"order = 11",
       [&] {
         analyse(load, {11, 1});
       }},
      {"refine = 0: must be 1 to 4",
       [&] {
         analyse(load, {7, 0});
       }},
      {"refine = 5",
       [&] {
         analyse(load, {7, 5});
       }},
      {"x = 1.2: must be inside the block", [&] { solution.displacement_z(1.2, 0); }},
      {"z = 1.001", [&] { solution.fine().at(0, 1.001); }},
      {"x = nan", [&] { solution.measures({std::nan("")}); }},
  });
  BOOST_CHECK_THROW(analysis.on({.bottom = Support::free}).solve(load), block::FactorizationError);
  BOOST_CHECK_NO_THROW(analysis.on({.left = Support::roller, .bottom = Support::roller}));
  BOOST_CHECK_NO_THROW(analysis.on({.right = Support::clamped, .bottom = Support::free}));
  BOOST_CHECK_NO_THROW(analyse(between(-1, 1)).on({}).solve(between(-1, 1)));
}

BOOST_AUTO_TEST_CASE(a_stiffness_beyond_doubles_is_an_exception) {
  // Practically incompressible: λ/μ exceeds 1/ε, so the shear stiffness is lost
  const elasticity::Material rubber(1, 0.5 - 1e-16);
  const auto solve = [&] {
    const block::Analysis analysis(paper_block::rectangle, rubber, {load}, {4, 1});
    analysis.on(block::with_sides(Support::clamped)).solve(load);
  };
  BOOST_CHECK_THROW(solve(), block::FactorizationError);
}

BOOST_AUTO_TEST_SUITE_END()
