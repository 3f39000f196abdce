// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/contact_m.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>
#include <vector>

#include "contact/contact_search.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/dense_methods.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(contact_m_test)

using config::PrintedNumber;
using elasticity::Material;
using paper::ContactM;
using paper::ContactMInput;
using paper::ContactMRepairs;
using paper::run_contact_m;
using tolerance::relative_difference;

namespace {

constexpr ContactMInput papers{.n_nodes = 36, .spacing = 0.0005, .zero_node = 9, .step = 1e-7};
constexpr ContactMRepairs every{true, true, true, true, true, true};

// The solve of a system whose coefficients hold the distant datum: a few digits less than all.
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

// The displacement that the triangles give a body's surface at x; those at −x too if has_images.
double displacement(const Material& material, const ContactM& program, double x, bool has_images) {
  const elasticity::TriangularLoad unit(1, program.x[1]);
  double u = 0;
  for (std::size_t j = 0; j < program.x.size(); ++j) {
    u += program.pressure[j] * normal_displacement(material, unit, x - program.x[j], 1);
    if (has_images && j > 0) {
      u += program.pressure[j] * normal_displacement(material, unit, x + program.x[j], 1);
    }
  }
  return u;
}

// The program's rows: displacement at node 1 less that at node i is the gap there, x²/(2R).
void check_level(const parameters::ContactCase& contact, const ContactM& program, bool has_images,
                 bool both) {
  const auto u = [&](double x) {
    const double u1 = displacement(contact.body1.material, program, x, has_images);
    return both ? u1 + displacement(contact.body2.material, program, x, has_images) : u1;
  };
  for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(program.zero_node); ++i) {
    const double x = program.x[i];
    BOOST_TEST(relative_difference(u(0) - u(x), contact.cylinders.profile().gap(x)) < 1e-9);
  }
}

// Every repair, on a grid n times as fine.
ContactM mended_on_finer_grid(Eigen::Index n) {
  ContactMInput input = papers;
  input.n_nodes *= n;
  input.spacing /= static_cast<double>(n);
  return run_contact_m(papers_contact(), input, every);
}

}  // namespace

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

BOOST_AUTO_TEST_CASE(its_pressure_is_zero_from_the_typed_node_on) {
  const ContactM program = run_contact_m(papers_contact(), papers);

  BOOST_TEST(program.pressure.size() == 36U);
  for (std::size_t i = 0; i < 36; ++i) BOOST_TEST((program.pressure[i] > 0) == (i < 8));
  for (std::size_t i = 8; i < 36; ++i) BOOST_TEST(program.pressure[i] == 0);
  BOOST_TEST(program.x[8] == 0.004);
}

BOOST_AUTO_TEST_CASE(the_listing_is_read_from_what_is_printed) {
  const paper::PrintedData printed{
      {},
      {"", {}, PrintedNumber("0.0000001")},
      {"", {PrintedNumber("1"), PrintedNumber("1")}, {}, {}, {}},
      {"", PrintedNumber("0.0005"), PrintedNumber("37"), PrintedNumber("9")}};
  const ContactMInput input = paper::as_printed(printed);

  BOOST_TEST(input.n_nodes == 36);
  BOOST_TEST(input.spacing == 0.0005);
  BOOST_TEST(input.zero_node == 9);
  BOOST_TEST(input.step == 1e-7);
}

BOOST_AUTO_TEST_CASE(its_step_moves_the_displacement_at_and_beside_a_node_and_nowhere_else) {
  // B p = h with B(i,j) = f(−j) − f(i−j) and f(k) at kc, or at kc + step for |k| ≤ 1.
  const auto contact = papers_contact();
  ContactMInput input = papers;
  input.step = 2e-5;
  const ContactM program = run_contact_m(contact, input);
  const elasticity::TriangularLoad unit(1, 0.0005);
  const auto f = [&](int k) {
    const double x = std::abs(k) <= 1 ? 0.0005 * k + 2e-5 : 0.0005 * k;
    return normal_displacement(contact.body1.material, unit, x, 1);
  };
  for (int i = 1; i < 8; ++i) {
    double level = 0;
    for (int j = 0; j < 8; ++j) {
      level += (f(-j) - f(i - j)) * program.pressure[static_cast<std::size_t>(j)];
    }
    BOOST_TEST(relative_difference(level, contact.cylinders.profile().gap(0.0005 * i)) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(the_limits_make_one_body_level_on_the_side_that_exists) {
  const auto contact = papers_contact();
  check_level(contact, run_contact_m(contact, papers, {.limits = true}), false, false);
}

BOOST_AUTO_TEST_CASE(the_limits_change_little) {
  const auto contact = papers_contact();
  const ContactM limits = run_contact_m(contact, papers, {.limits = true});
  const double change = largest_difference(run_contact_m(contact, papers), limits);

  BOOST_TEST(change > 1e-5 * limits.hertz_peak_pressure);
  BOOST_TEST(change < 1e-3 * limits.hertz_peak_pressure);
}

BOOST_AUTO_TEST_CASE(mirror_images_are_the_same_triangles_on_the_other_side) {
  const auto contact = papers_contact();
  const ContactM program = run_contact_m(contact, papers, {.limits = true, .mirror_images = true});

  check_level(contact, program, true, false);
  BOOST_TEST(program.has_mirror_images);
  BOOST_TEST(relative_difference(sum(program), 2500 / (7 * 0.0005)) < 1e-12);
  const double both_sides = 0.0005 * (2 * sum(program) - program.pressure[0]);
  BOOST_TEST(relative_difference(program.line_load, both_sides) < 1e-14);
}

BOOST_AUTO_TEST_CASE(without_mirror_images_the_first_node_stands_out) {
  const auto contact = papers_contact();
  const auto without = run_contact_m(contact, papers, {.limits = true}).pressure;
  const auto with =
      run_contact_m(contact, papers, {.limits = true, .mirror_images = true}).pressure;

  BOOST_TEST(without[0] > 2 * without[1]);
  BOOST_TEST(with[0] > with[1]);
  BOOST_TEST(with[0] < 1.01 * with[1]);
}

BOOST_AUTO_TEST_CASE(with_both_bodies_their_sum_is_level) {
  const auto contact = cylinders_of({30e6, 0.3}, {10e6, 0.345});
  check_level(contact, run_contact_m(contact, papers, {.limits = true, .both_bodies = true}), false,
              true);
}

BOOST_AUTO_TEST_CASE(as_printed_it_does_not_know_the_second_body) {
  const auto steel = papers_contact();
  const auto rubber = cylinders_of({30e6, 0.3}, {300, 0.49});

  BOOST_TEST(largest_difference(run_contact_m(steel, papers), run_contact_m(rubber, papers)) == 0);
}

BOOST_AUTO_TEST_CASE(with_both_bodies_their_exchange_changes_nothing) {
  const Material steel(30e6, 0.3);
  const Material aluminium(10e6, 0.345);
  const ContactM one = run_contact_m(cylinders_of(steel, aluminium), papers, every);
  const ContactM other = run_contact_m(cylinders_of(aluminium, steel), papers, every);

  BOOST_TEST(one.zero_node == other.zero_node);
  BOOST_TEST(largest_difference(one, other) < solved * one.pressure[0]);
}

BOOST_AUTO_TEST_CASE(the_weight_of_equilibrium_makes_the_load_right) {
  for (const bool mirror_images : {false, true}) {
    const ContactM program = run_contact_m(
        papers_contact(), papers,
        {.limits = true, .mirror_images = mirror_images, .weight_of_equilibrium = true});
    BOOST_TEST(relative_difference(program.line_load, 2500) < 1e-12);
    const double sides = mirror_images ? 2 : 1;
    BOOST_TEST(relative_difference(
                   0.0005 * (sides * sum(program) + (1 - sides) * program.pressure[0]), 2500) <
               1e-12);
  }
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

BOOST_AUTO_TEST_CASE(a_free_edge_has_no_tension_inside_and_one_node_more_would_have) {
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

BOOST_AUTO_TEST_CASE(with_one_body_and_all_else_mended_the_other_is_rigid) {
  // Hertz with E* = E/(1 − ν²): a/√2 and p₀√2 for two like bodies.
  const auto contact = papers_contact();
  ContactMRepairs mended = every;
  mended.both_bodies = false;
  const ContactM program = run_contact_m(contact, papers, mended);
  const double peak = std::sqrt(2.0) * hertz_of(contact, 2500).peak_pressure();

  BOOST_TEST(relative_difference(program.pressure[0], peak) < 1e-3);
}

BOOST_AUTO_TEST_CASE(with_every_repair_it_is_the_matrix_inversion_on_a_one_sided_grid) {
  const auto contact = cylinders_of({30e6, 0.3}, {10e6, 0.345});
  const ContactMInput input{.n_nodes = 47, .spacing = 0.00043, .zero_node = 9, .step = 1e-7};
  const ContactM program = run_contact_m(contact, input, every);
  const line_contact::Solution one_sided = line_contact::solve_by_matrix_inversion(
      {contact.cylinders.profile(),
       contact.cylinders.contact_modulus(),
       {.n_nodes = 47, .spacing = 0.00043, .is_one_sided = true}},
      2500);

  for (Eigen::Index i = 0; i < 47; ++i) {
    BOOST_TEST(std::abs(program.pressure[static_cast<std::size_t>(i)] - one_sided.pressure[i]) <
               solved * one_sided.peak_pressure());
  }
  BOOST_TEST(relative_difference(program.line_load, 2500) < 1e-12);
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
  // Error·(a/c)²: it jumps with where the edge lies between nodes, below 0.25 as the solver's.
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

BOOST_AUTO_TEST_CASE(refuses_an_edge_that_leaves_less_than_two_nodes_or_none_beyond) {
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
