// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/contact_m.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "contact/hertz.hpp"
#include "tolerances.hpp"

using parameters::PrintedNumber;

namespace {

parameters::ContactCase papers_contact() {
  const elasticity::Material steel(30e6, 0.3);
  const auto radius1 = contact::Radius::of_cylinder("radius1", 1);
  const auto radius2 = contact::Radius::of_cylinder("radius2", 3);
  return {{steel, radius1}, {steel, radius2}, {steel, radius1, steel, radius2}, 2500, 1, 91};
}

parameters::PrintedContactM printed(const char* zero_node) {
  return {"", PrintedNumber("0.0005"), PrintedNumber("37"), PrintedNumber(zero_node)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_listed_program_carries_the_load_over_aa_minus_two) {
  const auto contact = papers_contact();
  for (const auto& [zero_node, weight] : {std::pair{"9", 7.0}, {"20", 18.0}}) {
    const paper::ContactM listed = paper::run_contact_m(contact, printed(zero_node));
    BOOST_TEST(tolerance::relative_difference(listed.line_load, 2500 / weight) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(its_pressure_is_zero_from_the_typed_node_on) {
  const paper::ContactM listed = paper::run_contact_m(papers_contact(), printed("9"));

  BOOST_TEST(listed.pressure.size() == 36U);
  for (std::size_t i = 8; i < listed.pressure.size(); ++i) BOOST_TEST(listed.pressure[i] == 0);
  BOOST_TEST(listed.pressure[0] > 0);
  BOOST_TEST(listed.x[8] == 0.004);
}

BOOST_AUTO_TEST_CASE(its_rows_make_one_body_level_on_the_side_that_exists) {
  // B p = h: the displacement of body 1 at node 0 less that at node i is the gap there, x²/(2R).
  const auto contact = papers_contact();
  const paper::ContactM listed = paper::run_contact_m(contact, printed("9"));
  const elasticity::TriangularLoad unit(1, 0.0005);
  const auto displacement = [&](double x) {
    double sum = 0;
    for (std::size_t j = 0; j < listed.x.size(); ++j) {
      sum += listed.pressure[j] *
             normal_displacement(contact.body1.material, unit, x - listed.x[j], contact.datum);
    }
    return sum;
  };
  for (std::size_t i = 1; i < 8; ++i) {
    const double x = listed.x[i];
    const double gap = contact.cylinders.initial_gap(x);
    BOOST_TEST(tolerance::relative_difference(displacement(0) - displacement(x), gap) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(its_hertz_has_twice_the_load) {
  const auto contact = papers_contact();
  const paper::ContactM listed = paper::run_contact_m(contact, printed("9"));
  const contact::Hertz hertz(contact.cylinders, 2500);

  BOOST_TEST(tolerance::relative_difference(listed.hertz_half_width,
                                            std::sqrt(2.0) * hertz.half_width()) < 1e-14);
  BOOST_TEST(tolerance::relative_difference(listed.hertz_peak_pressure,
                                            std::sqrt(2.0) * hertz.peak_pressure()) < 1e-14);
}
