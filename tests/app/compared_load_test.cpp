// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compared_load.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(compared_load_test)

using app::compare_at;
using app::compared_load;
using app::ComparedLoad;
using app::Component;
using app::difference_over_error;
using app::DisplacementRow;

namespace {

const elasticity::Material steel(207e3, 0.29);
constexpr double datum = 7.7;

app::LoadChoice shape(const std::string& name) {
  return {.shape = name, .peak_pressure = 2.385, .half_width = 0.75, .line_load = 1.7, .kinks = {}};
}

std::string refusal_of(const app::LoadChoice& choice) {
  return message_of<sys::InputError>([&] { compared_load(choice, steel, datum); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_closed_form_agrees_with_its_integral_inside_and_at_kinks) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("load.csv", "x,pressure\n-1,0\n-0.2,3\n0.1,0.5\n0.7,0.5\n2,0\n").string();
  for (const std::string& name : {std::string("triangular"), std::string("elliptic"),
                                  std::string("parabolic"), "file:" + file}) {
    const ComparedLoad compared = compared_load(shape(name), steel, datum);
    const elasticity::SurfaceQuadrature surface(steel, compared.load, datum);
    BOOST_TEST(!compared.normal_source.empty());
    BOOST_TEST(compared.key_points.size() >= 5U);
    for (const Component component : {Component::normal, Component::tangential}) {
      for (const double x : compared.key_points) {
        const DisplacementRow row = compare_at(compared, surface, component, x);
        BOOST_TEST_CONTEXT(name << ", x = " << x) {
          BOOST_TEST(difference_over_error(row.gradient_quadrature,
                                           row.gradient_closed_form.value()) <= 1);
          BOOST_TEST(difference_over_error(row.displacement_quadrature,
                                           row.displacement_closed_form.value()) <= 1);
          BOOST_TEST(row.n_evaluations > 0);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_formula_of_a_parabola_has_the_integrals_of_the_parabola) {
  const ComparedLoad formula = compared_load(shape("expression:p0*(1-(x/a)^2)"), steel, datum);
  const ComparedLoad parabola = compared_load(shape("parabolic"), steel, datum);
  const elasticity::SurfaceQuadrature surface(steel, formula.load, datum);
  for (const double x : {-2.0, -0.75, -0.3, 0.0, 0.5, 0.75, 1.1}) {
    const DisplacementRow row = compare_at(formula, surface, Component::normal, x);
    BOOST_TEST(!row.gradient_closed_form.has_value());
    BOOST_TEST(difference_over_error(row.gradient_quadrature, parabola.normal_gradient(x)) <= 1);
    BOOST_TEST(
        difference_over_error(row.displacement_quadrature, parabola.normal_displacement(x)) <= 1);
  }
}

BOOST_AUTO_TEST_CASE(an_expression_is_split_at_its_kinks) {
  app::LoadChoice choice = shape("expression:p0*max(0, 1-abs(x)/0.3)");
  choice.kinks = {-0.3, 0.3};
  const ComparedLoad compared = compared_load(choice, steel, datum);

  BOOST_TEST(compared.load.normal.pieces().size() == 4U);
  choice.kinks = {0.75};
  BOOST_TEST(refusal_of(choice).find("--kinks: 0.75 does not lie under the load") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_is_missing_or_wrong_is_named) {
  app::LoadChoice choice = shape("parabolic");
  choice.peak_pressure.reset();
  BOOST_TEST(refusal_of(choice).find("--peak-pressure is missing") != std::string::npos);
  choice = shape("expression:1");
  choice.half_width.reset();
  BOOST_TEST(refusal_of(choice).find("--half-width is missing") != std::string::npos);
  choice = shape("expression:p0*x");
  choice.peak_pressure.reset();
  BOOST_TEST(refusal_of(choice).find("column 1") != std::string::npos, refusal_of(choice));
  BOOST_TEST(refusal_of(shape("square")).find("--shape: \"square\" must be triangular") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(files_that_are_no_load_are_refused_by_file_and_line) {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& text, const std::string& reason) {
    const std::string file = folder.write("load.csv", text).string();
    const std::string refusal = refusal_of(shape("file:" + file));
    BOOST_TEST(refusal.find(file + reason) != std::string::npos, refusal);
  };
  check("x,pressure\n0,1\n1,2\n0.5,1\n", ":4: x = 0.5: must be greater than the one before, 1");
  check("x,pressure\n0,1\n", ": holds 1 points, 2 or more are needed");
  check("x,pressure\n0,1\n1,high\n", ":3: pressure");
  check("x,p\n0,1\n1,2\n", ":1: the heading must be x,pressure");
}

BOOST_AUTO_TEST_SUITE_END()
