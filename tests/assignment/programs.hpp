// SPDX-License-Identifier: GPL-3.0-or-later
// Programs as students write them: this project's own functions answer the tasks, rightly or with a
// planted mistake.
#pragma once

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <span>
#include <stdexcept>
#include <string>

#include "assignment/assignment.hpp"
#include "assignment/given/shapes.hpp"
#include "course/assignment/assignment.hpp"
#include "course/assignment/check.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "elasticity/triangular_load.hpp"
#include "line_contact/cylinders.hpp"
#include "line_contact/dense_methods.hpp"
#include "line_contact/element.hpp"

namespace programs {

using course::Numbers;
using course::Program;

inline course::Assignment assignment() {
  return course::read_assignment(HALFSPACE_SOURCE_DIR "/report/assignment");
}

/// The nominal variant and those of some students.
inline std::vector<course::Variant> variants() {
  const course::Assignment description = assignment();
  std::vector<course::Variant> list = {course::nominal_variant(description)};
  for (const char* student : {"ada", "emmy", "sofja"}) {
    list.push_back(course::variant_of(description, student, "a seed", assignment::is_valid));
  }
  return list;
}

inline Numbers gradient(const Numbers& in) {
  Numbers out;
  for (const double x : std::span(in).subspan(4)) {
    out.push_back(elasticity::normal_gradient({in[0], in[1]}, {in[2], in[3]}, x));
  }
  return out;
}

/// The load with this shape, p₀ and a.
inline elasticity::Load load_of(double shape, double unit_pressure, double half_width) {
  const auto pressure = [=](double s) {
    return assignment::pressure(shape, unit_pressure, half_width, s);
  };
  return elasticity::distributed_load(pressure, {-half_width, 0, half_width});
}

inline Numbers quadrature(const Numbers& in) {
  const elasticity::SurfaceQuadrature surface({in[0], in[1]}, load_of(in[2], in[3], in[4]),
                                              10 * in[4]);
  Numbers out;
  for (const double x : std::span(in).subspan(5)) {
    const numerics::Estimate found = surface.normal_gradient(x);
    out.insert(out.end(), {found.value, found.abs_error});
  }
  return out;
}

inline Numbers displacement(const Numbers& in) {
  const elasticity::SurfaceQuadrature surface({in[0], in[1]}, load_of(in[2], in[3], in[4]), in[5]);
  Numbers out;
  for (const double x : std::span(in).subspan(6)) {
    out.push_back(surface.normal_displacement(x).value);
  }
  return out;
}

inline Numbers influence(const Numbers& in) {
  const auto unit = [](double k) {
    return line_contact::influence_coefficient(line_contact::Element::triangular, k);
  };
  Numbers out;
  for (const double k : std::span(in).subspan(3)) {
    out.push_back(-2 * in[1] / (std::numbers::pi * in[0]) * (unit(k) - unit(in[2] / in[1])));
  }
  return out;
}

inline Numbers contact_of(const Numbers& in) {
  using line_contact::Radius;
  const line_contact::CylinderPair pair({in[0], in[1]}, Radius::of_cylinder("R1", in[2]),
                                        {in[3], in[4]}, Radius::of_cylinder("R2", in[5]));
  const line_contact::Solution solution = line_contact::solve_by_matrix_inversion(
      {pair.profile(), pair.contact_modulus(), {std::lround(in[8]), in[7]}}, in[6]);
  const double to_datum =
      line_contact::influence_coefficient(line_contact::Element::triangular, in[9] / in[7]);
  const double total_phi = 2 * in[6] / (std::numbers::pi * pair.contact_modulus());
  Numbers out = {solution.approach_at_spacing + total_phi * to_datum, solution.half_width()};
  out.insert(out.end(), solution.pressure.begin(), solution.pressure.end());
  return out;
}

/// The right program, by this project's functions.
inline Numbers right(const std::string& task, const Numbers& in) {
  if (task == "gradient") return gradient(in);
  if (task == "gradient_by_quadrature") return quadrature(in);
  if (task == "displacement") return displacement(in);
  if (task == "influence") return influence(in);
  if (task == "contact") return contact_of(in);
  throw std::logic_error("no task " + task);
}

/// The right program, except that `spoil` changes the answer of one task.
inline Program spoiled(const std::string& task, const std::function<void(Numbers&)>& spoil) {
  return [=](const std::string& asked, const Numbers& in) {
    Numbers out = right(asked, in);
    if (asked == task) spoil(out);
    return out;
  };
}

/// The right program, except that one task is given other inputs.
inline Program misled(const std::string& task, const std::function<void(Numbers&)>& mislead) {
  return [=](const std::string& asked, Numbers in) {
    if (asked == task) mislead(in);
    return right(asked, in);
  };
}

/// The task's answers times a factor.
inline Program scaled(const std::string& task, double factor) {
  return spoiled(task, [=](Numbers& out) {
    for (double& number : out) number *= factor;
  });
}

/// The variant with the nominal numbers.
inline const course::Variant nominal = course::nominal_variant(assignment());

/// The checks that a program does not pass in full.
inline std::set<std::string> failed(const course::Checks& checks, const Program& program) {
  std::set<std::string> ids;
  for (const auto& [id, check] : checks) {
    const course::Outcome outcome = check(program, nominal);
    BOOST_TEST((outcome.share == 1) == outcome.message.empty(), id);
    if (outcome.share < 1) ids.insert(id);
  }
  return ids;
}

/// That a right program passes all of these checks, whatever the numbers are.
inline void check_right(const course::Checks& checks) {
  for (const course::Variant& variant : variants()) {
    for (const auto& [id, check] : checks) {
      const course::Outcome outcome = check(right, variant);
      BOOST_TEST(outcome.share == 1, variant.student << ' ' << id << ": " << outcome.message);
    }
  }
}

}  // namespace programs
