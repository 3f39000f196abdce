// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/contact_m.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>

#include "contact/contact_search.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/methods.hpp"
#include "numbers.hpp"

BOOST_AUTO_TEST_SUITE(contact_m_test)

using elasticity::Material;
using paper::ContactM;
using paper::ContactMInput;
using paper::ContactMRepairs;
using paper::run_contact_m;
using tolerance::relative_difference;

namespace {

constexpr ContactMInput papers{.n_nodes = 36, .spacing = 0.0005, .zero_node = 9, .step = 1e-7};
constexpr ContactMRepairs every{true, true, true, true, true, true};

// The system's coefficients contain the distant datum, which costs a few digits.
constexpr double solved = 1e-11;

parameters::ContactCase cylinders_of(const Material& material1, const Material& material2) {
  const auto radius1 = line_contact::Radius::of_cylinder("radius1", 1);
  const auto radius2 = line_contact::Radius::of_cylinder("radius2", 3);
  return {{material1, radius1},
          {material2, radius2},
          {material1, radius1, material2, radius2},
          2500,
          1,
          91};
}

parameters::ContactCase papers_contact() {
  const Material steel(30e6, 0.3);
  return cylinders_of(steel, steel);
}

line_contact::Hertz hertz_of(const parameters::ContactCase& contact, double line_load) {
  return {contact.cylinders, line_load};
}

double sum(const ContactM& program) {
  return std::accumulate(program.pressure.begin(), program.pressure.end(), 0.0);
}

double largest_difference(const ContactM& a, const ContactM& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    largest = std::max(largest, std::abs(a.pressure[i] - b.pressure[i]));
  }
  return largest;
}

// With every repair, on a grid n times as fine.
ContactM mended_on_finer_grid(Eigen::Index n) {
  ContactMInput input = papers;
  input.n_nodes *= n;
  input.spacing /= static_cast<double>(n);
  return run_contact_m(papers_contact(), input, every);
}

}  // namespace

BOOST_AUTO_TEST_CASE(as_printed_it_has_the_pressures_that_octave_computes) {
  // GNU Octave 7.3.0, report/octave/contact_m.m: fprintf('%.12g ', p(1:8))
  const double octave[] = {226926.783038, 99689.7576795, 96626.2199066, 84246.3639513,
                           74734.779840,  63351.6039095, 50117.0700538, 18593.1359069};

  const ContactM program = run_contact_m(papers_contact(), papers);

  for (std::size_t i = 0; i < 8; ++i) {
    BOOST_TEST(relative_difference(program.pressure[i], octave[i]) < 1e-9);
  }
  for (std::size_t i = 8; i < 36; ++i) BOOST_TEST(program.pressure[i] == 0);
}

BOOST_AUTO_TEST_CASE(as_printed_it_carries_the_load_over_aa_minus_two) {
  ContactMInput input = papers;
  for (const Eigen::Index zero_node : {9, 20}) {
    input.zero_node = zero_node;
    const ContactM program = run_contact_m(papers_contact(), input);
    const double load = 2500 / static_cast<double>(zero_node - 2);
    BOOST_TEST(relative_difference(program.line_load, load) < 1e-12);
    BOOST_TEST(relative_difference(program.line_load, 0.0005 * sum(program)) < 1e-14);
    BOOST_TEST(program.zero_node == zero_node);
    BOOST_TEST(!program.has_mirror_images);
  }
}

BOOST_AUTO_TEST_CASE(the_limits_change_little) {
  const auto contact = papers_contact();
  const ContactM limits = run_contact_m(contact, papers, {.limits = true});
  const double change = largest_difference(run_contact_m(contact, papers), limits);

  BOOST_TEST(change > 1e-5 * limits.hertz_peak_pressure);
  BOOST_TEST(change < 1e-3 * limits.hertz_peak_pressure);
}

BOOST_AUTO_TEST_CASE(as_printed_it_ignores_the_second_body) {
  const auto steel = papers_contact();
  const auto rubber = cylinders_of({30e6, 0.3}, {300, 0.49});

  BOOST_TEST(largest_difference(run_contact_m(steel, papers), run_contact_m(rubber, papers)) == 0);
}

BOOST_AUTO_TEST_CASE(the_typed_node_is_where_the_printed_program_finds_its_free_edge) {
  ContactMInput input = papers;
  input.zero_node = 20;  // not used
  const ContactM found = run_contact_m(papers_contact(), input, {.free_edge = true});
  const ContactM typed = run_contact_m(papers_contact(), papers);

  BOOST_TEST(found.zero_node == 9);
  BOOST_TEST(largest_difference(found, typed) == 0);
  BOOST_TEST(relative_difference(found.line_load, 2500.0 / 7) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_free_edge_has_no_tension_but_one_more_node_would) {
  ContactMRepairs mended = every;
  const ContactM found = run_contact_m(papers_contact(), papers, mended);
  mended.free_edge = false;
  ContactMInput wider = papers;
  wider.zero_node = found.zero_node + 1;
  const ContactM one_more = run_contact_m(papers_contact(), wider, mended);

  BOOST_TEST(found.zero_node == 26);
  for (std::size_t i = 0; i < 36; ++i) BOOST_TEST((found.pressure[i] > 0) == (i < 25));
  BOOST_TEST(one_more.pressure[25] < 0);
}

BOOST_AUTO_TEST_CASE(its_hertz_has_twice_the_load_until_mended) {
  const auto contact = papers_contact();
  const ContactM listed = run_contact_m(contact, papers);
  const ContactM mended = run_contact_m(contact, papers, {.hertz_load = true});
  const line_contact::Hertz hertz = hertz_of(contact, 2500);
  const double root = std::sqrt(2.0);

  BOOST_TEST(relative_difference(listed.hertz_half_width, root * hertz.half_width()) < 1e-14);
  BOOST_TEST(relative_difference(listed.hertz_peak_pressure, root * hertz.peak_pressure()) < 1e-14);
  BOOST_TEST(mended.hertz_half_width == hertz.half_width());
  BOOST_TEST(mended.hertz_peak_pressure == hertz.peak_pressure());
  BOOST_TEST(largest_difference(listed, mended) == 0);
}

BOOST_AUTO_TEST_CASE(without_the_repair_of_both_bodies_the_second_is_rigid) {
  // Hertz with E* = E/(1 − ν²): a/√2 and p₀√2 for two like bodies.
  const auto contact = papers_contact();
  ContactMRepairs mended = every;
  mended.both_bodies = false;
  const ContactM program = run_contact_m(contact, papers, mended);
  const double peak = std::sqrt(2.0) * hertz_of(contact, 2500).peak_pressure();

  BOOST_TEST(relative_difference(program.pressure[0], peak) < 1e-3);
}

BOOST_AUTO_TEST_CASE(with_every_repair_it_is_the_matrix_inversion_on_both_sides) {
  const auto contact = papers_contact();
  const ContactM program = run_contact_m(contact, papers, every);
  const line_contact::Solution both_sides =
      line_contact::solve_by_matrix_inversion({contact.cylinders.profile(),
                                               contact.cylinders.contact_modulus(),
                                               {.n_nodes = 71, .spacing = 0.0005}},
                                              2500);

  for (std::size_t i = 0; i < 36; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    for (const Eigen::Index node : {35 - k, 35 + k}) {
      BOOST_TEST(std::abs(program.pressure[i] - both_sides.pressure[node]) <
                 solved * both_sides.peak_pressure());
    }
  }
}

BOOST_AUTO_TEST_CASE(with_every_repair_it_converges_to_hertz_to_second_order) {
  // Error·(a/c)² varies with the position of the edge between nodes but stays below 0.25, as the
  // solver's.
  const line_contact::Hertz hertz = hertz_of(papers_contact(), 2500);
  for (const Eigen::Index n : {1, 2, 4, 8}) {
    const ContactM program = mended_on_finer_grid(n);
    const double error = program.pressure[0] / hertz.peak_pressure() - 1;
    const double c = 0.0005 / static_cast<double>(n);
    BOOST_TEST(std::abs(error) < 0.25 * std::pow(c / hertz.half_width(), 2), "n = " << n);
    const double edge = c * static_cast<double>(program.zero_node - 1);
    BOOST_TEST(std::abs(edge - hertz.half_width()) < c);
  }
}

BOOST_AUTO_TEST_CASE(rejects_an_edge_with_fewer_than_two_nodes_inside_or_none_beyond) {
  ContactMInput input = papers;
  for (const Eigen::Index zero_node : {1, 2, 37}) {
    input.zero_node = zero_node;
    BOOST_CHECK_THROW(run_contact_m(papers_contact(), input), contact::ContactError);
  }
  ContactMInput small = papers;
  small.n_nodes = 20;  // ends at 0.0095 in, within the contact
  BOOST_CHECK_THROW(run_contact_m(papers_contact(), small, every), contact::ContactError);
  ContactMInput coarse = papers;
  coarse.spacing = 0.03;  // an element wider than the contact
  BOOST_CHECK_THROW(run_contact_m(papers_contact(), coarse, every), contact::ContactError);
  BOOST_CHECK_THROW(run_contact_m(papers_contact(), coarse, {.free_edge = true}),
                    contact::ContactError);
}

BOOST_AUTO_TEST_SUITE_END()
