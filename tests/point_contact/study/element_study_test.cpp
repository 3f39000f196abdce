// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/study/two_spheres.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <vector>

#include "numerics/scatter.hpp"

BOOST_AUTO_TEST_SUITE(element_study_test)

using elasticity::Material;
using point_contact::Element;
using point_contact::ElementStudy;
using point_contact::study_element;
using point_contact::TwoSpheres;

namespace {

const Material material(2000, 0.2385);
const TwoSpheres spheres{elasticity::contact_modulus(material, material), 0.571, 3.461};

const ElementStudy& study_of(Element element) {
  static const std::map<Element, ElementStudy> studies = [] {
    std::map<Element, ElementStudy> all;
    for (const Element each :
         {Element::point, Element::uniform, Element::bilinear, Element::pyramid}) {
      all.emplace(each, study_element(spheres, material, each));
    }
    return all;
  }();
  return studies.at(element);
}

numerics::ScatteredPower fit_power(const std::vector<double>& elements,
                                   const std::vector<double>& errors) {
  std::vector<numerics::Estimate> exact;
  for (const double error : errors) exact.push_back({error, 0});
  return numerics::fit_scattered_power(elements, exact, "places");
}

void check_order(Element element, const std::vector<double>& elements,
                 const std::vector<double>& errors, double expected, double scatter) {
  const double order = fit_power(elements, errors).order.value();
  BOOST_TEST(std::abs(order - expected) < scatter, name_of(element) << ": order " << order);
}

constexpr Element with_pressures[] = {Element::uniform, Element::bilinear, Element::pyramid};

}  // namespace

BOOST_AUTO_TEST_CASE(inside_the_contact_pressures_have_the_second_order) {
  for (const Element element : with_pressures) {
    const ElementStudy& study = study_of(element);
    check_order(element, study.elements, study.inside, 2, 0.2);
    check_order(element, study.elements, study.peak, 2, 0.3);
  }
  const ElementStudy& forces = study_of(Element::point);
  BOOST_TEST(fit_power(forces.elements, forces.inside).order.value() > 1.8);
}

BOOST_AUTO_TEST_CASE(radius_and_approach_have_the_second_order) {
  for (const Element element : with_pressures) {
    const ElementStudy& study = study_of(element);
    check_order(element, study.elements, study.radius, 2, 0.3);
    check_order(element, study.elements, study.approach, 2, 0.3);
  }
}

BOOST_AUTO_TEST_CASE(the_largest_error_is_the_edges_of_order_one_half) {
  for (const Element element : with_pressures) {
    const ElementStudy& study = study_of(element);
    check_order(element, study.elements, study.largest, 0.5, 0.25);
  }
}

BOOST_AUTO_TEST_CASE(between_the_nodes_each_step_of_smoothness_gains_an_order) {
  const auto check = [](Element element, double expected, double scatter) {
    const ElementStudy& study = study_of(element);
    check_order(element, study.elements, study.slope, expected, scatter);
    check_order(element, study.elements, study.stress, expected, scatter);
  };
  check(Element::point, 0, 0.2);
  check(Element::uniform, 1, 0.15);
  check(Element::bilinear, 2, 0.35);
  check(Element::pyramid, 2, 0.35);
}

BOOST_AUTO_TEST_CASE(for_the_pressure_pyramids_and_hats_are_no_better_than_uniform_elements) {
  const auto inside = [](Element element) {
    const ElementStudy& study = study_of(element);
    return fit_power(study.elements, study.inside).factor.value();
  };
  BOOST_TEST(inside(Element::pyramid) > inside(Element::uniform));
  BOOST_TEST(inside(Element::bilinear) > inside(Element::uniform));
}

BOOST_AUTO_TEST_CASE(errors_of_the_solver_are_far_below_those_of_the_elements) {
  for (const Element element : with_pressures) {
    const ElementStudy& study = study_of(element);
    for (std::size_t i = 0; i < study.elements.size(); ++i) {
      BOOST_TEST(study.bound[i] < 1e-3 * study.inside[i]);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
