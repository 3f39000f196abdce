// SPDX-License-Identifier: GPL-3.0-or-later
// The block in another program: CalculiX, Debian package calculix-ccx.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "block/exports.hpp"
#include "block/paper_block.hpp"
#include "needed_tool.hpp"
#include "system/require.hpp"
#include "temporary_folder.hpp"

namespace {

// Not every suite of Debian has it.
void need_calculix() {
  need_tool("ccx", "the block was not compared with CalculiX");
}

}  // namespace

BOOST_AUTO_TEST_SUITE(calculix_test, *boost::unit_test::fixture(&need_calculix))

namespace {

std::vector<double> printed_points() {
  return paper_block::measure_options().surface_points;
}

// Runs a deck and reads the displacements (x, y) it prints, by node.
std::map<block::Index, Eigen::Vector2d> run_calculix(const std::string& deck) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "block.inp") << deck;
  const std::string command =
      "cd '" + folder.path().string() + "' && OMP_NUM_THREADS=1 ccx -i block >log 2>&1";
  BOOST_REQUIRE_MESSAGE(std::system(command.c_str()) == 0, "ccx rejected the deck");

  std::map<block::Index, Eigen::Vector2d> displacements;
  std::ifstream results(folder.path() / "block.dat");
  for (std::string line; std::getline(results, line);) {
    std::istringstream fields(line);
    block::Index node = 0;
    Eigen::Vector2d u;
    if (fields >> node >> u.x() >> u.y()) displacements[node] = u;
  }
  return displacements;
}

void compare(const elasticity::Load& load, const block::Supports& supports) {
  const block::Analysis analysis(paper_block::rectangle, paper_block::material, {load});
  const block::RefinedSolution solution = analysis.on(supports).solve(load);
  const block::Mesh mesh = block::calculix_mesh(analysis.fine()->mesh(), printed_points());

  std::ostringstream deck;
  block::write_calculix_deck(deck, mesh, paper_block::material, supports, load, printed_points());
  const auto displacements = run_calculix(deck.str());

  BOOST_REQUIRE(displacements.size() == printed_points().size());
  for (const double x : printed_points()) {
    const Eigen::Vector2d u = displacements.at(block::calculix_node(mesh, x));
    BOOST_CHECK_CLOSE(-u.y(), solution.displacement_z(x, 0).value, 0.1);
    // u_x to the same amount, a tenth of a percent of u_z: it is zero in the middle
    BOOST_TEST(std::abs(u.x() - solution.fine().displacement(x, 0).x()) < 1e-3 * -u.y());
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(calculix_agrees_on_the_eleven_displacements) {
  for (const auto sides : {block::Support::clamped, block::Support::roller, block::Support::free}) {
    compare(elasticity::linear_fall(1000, 0.6, 0.01), block::with_sides(sides));
  }
}

BOOST_AUTO_TEST_CASE(calculix_agrees_under_pressure_and_shear) {
  const auto skew =
      elasticity::distributed_load([](double x) { return 800 + 3e4 * x; },
                                   [](double x) { return 100 + 1e4 * x; }, {-0.02, 0.013});
  compare(skew, block::with_sides(block::Support::clamped));
}

BOOST_AUTO_TEST_CASE(every_field_of_the_deck_fits_what_calculix_reads) {
  const auto load = elasticity::linear_fall(1000, 0.6, 0.01);
  const block::Mesh graded = block::graded_mesh(paper_block::rectangle, {load}, {});
  std::ostringstream deck;
  block::write_calculix_deck(deck, block::calculix_mesh(graded, printed_points()),
                             paper_block::material, block::with_sides(block::Support::clamped),
                             load, printed_points());

  std::istringstream lines(deck.str());
  for (std::string line; std::getline(lines, line);) {
    if (line.front() == '*' || line.front() == 'R') continue;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) {
      const std::size_t n_blanks = field.front() == ' ' ? 1 : 0;
      BOOST_REQUIRE(field.size() - n_blanks <= 20);
    }
  }
}

BOOST_AUTO_TEST_CASE(decks_that_cannot_be_written_are_refused) {
  const auto load = elasticity::linear_fall(1000, 0.6, 0.01);
  const block::Mesh graded = block::graded_mesh(paper_block::rectangle, {load}, {});
  const block::Mesh quadratic = block::calculix_mesh(graded, {});
  std::ostringstream deck;

  BOOST_CHECK_THROW(block::calculix_mesh(graded, {1.5}), sys::InvalidQuantity);
  BOOST_CHECK_THROW(block::write_calculix_deck(deck, graded, paper_block::material, {}, load, {}),
                    sys::InvalidQuantity);
  BOOST_CHECK_THROW(
      block::write_calculix_deck(deck, quadratic, paper_block::material, {}, load, {0.01234}),
      sys::InvalidQuantity);
  BOOST_TEST(deck.str().find("*STEP") == std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
