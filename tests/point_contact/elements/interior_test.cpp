// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_contact/elements/interior.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "numerics/quadrature.hpp"
#include "point_contact/elements/element.hpp"
#include "system/require.hpp"

BOOST_AUTO_TEST_SUITE(interior_test)

using Eigen::Matrix3d;
using Eigen::Vector3d;
using elasticity::Material;
using point_contact::cross;
using point_contact::interior_field;
using point_contact::InteriorField;
using point_contact::Patch;
using point_contact::Vector2;

namespace {

const std::array<Vector2, 3> triangle = {Vector2(0.1, -0.3), Vector2(1.7, 0.2),
                                         Vector2(0.6, 1.385)};
const std::array<double, 3> values = {0.7, -0.4, 1.9};
const Material material(2.5, 0.2385);
const double shear_modulus = 2.5 / (2 * 1.2385);
constexpr double nu = 0.2385;

InteriorField field(const Vector3d& at) {
  return interior_field(Patch::triangle(triangle, values), material, at);
}

// A rectangle that lies askew, with a bilinear pressure.
const Vector2 side1(1.2, 0.5);
const Vector2 side2(-0.35, 0.84);
const std::array<Vector2, 4> rectangle = {Vector2(0.1, -0.3), Vector2(0.1, -0.3) + side1,
                                          Vector2(0.1, -0.3) + side1 + side2,
                                          Vector2(0.1, -0.3) + side2};
const std::array<double, 4> four_values = {0.7, -0.4, 2.2, 1.9};

InteriorField bilinear_field(const Vector3d& at) {
  return interior_field(Patch::bilinear(rectangle, four_values), material, at);
}

// Boussinesq's force 1 at the origin (Johnson 3.18, 3.19).
InteriorField boussinesq(const Vector3d& d) {
  const double x = d.x();
  const double y = d.y();
  const double z = d.z();
  const double r = d.norm();
  const double q = r + z;
  const double pi = std::numbers::pi;
  InteriorField f;
  f.displacement = Vector3d(x * z / std::pow(r, 3) - (1 - 2 * nu) * x / (r * q),
                            y * z / std::pow(r, 3) - (1 - 2 * nu) * y / (r * q),
                            z * z / std::pow(r, 3) + 2 * (1 - nu) / r) /
                   (4 * pi * shear_modulus);
  // σ_xx = (1/2π) {(1−2ν) [z/r³ − 1/(r q) + x²(2r+z)/(r³q²)] − 3x²z/r⁵}
  const auto in_plane = [&](double a) {
    return (1 - 2 * nu) *
               (z / std::pow(r, 3) - 1 / (r * q) + a * a * (2 * r + z) / (std::pow(r, 3) * q * q)) -
           3 * a * a * z / std::pow(r, 5);
  };
  const double xy = (1 - 2 * nu) * x * y * (2 * r + z) / (std::pow(r, 3) * q * q) -
                    3 * x * y * z / std::pow(r, 5);
  const double xz = -3 * x * z * z / std::pow(r, 5);
  const double yz = -3 * y * z * z / std::pow(r, 5);
  f.stress << in_plane(x), xy, xz, xy, in_plane(y), yz, xz, yz, -3 * z * z * z / std::pow(r, 5);
  f.stress /= 2 * pi;
  return f;
}

// One number of a field, numbered: three displacements, then six stresses.
double part(const InteriorField& f, int which) {
  if (which < 3) return f.displacement[which];
  constexpr std::array<std::array<int, 2>, 6> stresses = {
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  const auto& [i, j] = stresses[static_cast<std::size_t>(which - 3)];
  return f.stress(i, j);
}

// Boussinesq's forces added up over the triangle by quadrature, Q = A + u (B−A) + v (C−A).
double by_quadrature(const Vector3d& at, int which) {
  numerics::Quadrature outer, inner;
  const Vector2 b = triangle[1] - triangle[0];
  const Vector2 c = triangle[2] - triangle[0];
  const double area = cross(b, c);
  const auto over_v = [&](double u) {
    const auto at_v = [&](double v) {
      const Vector2 q = triangle[0] + u * b + v * c;
      const double p = values[0] + u * (values[1] - values[0]) + v * (values[2] - values[0]);
      return p * area * part(boussinesq(at - Vector3d(q.x(), q.y(), 0)), which);
    };
    return inner.smooth(at_v, 0, 1 - u, 1e-11, {"a strip", u}).value;
  };
  return outer.smooth(over_v, 0, 1, 1e-10, {"the triangle", 0}).value;
}

// The same over the rectangle, Q = A + u side1 + v side2.
double bilinear_by_quadrature(const Vector3d& at, int which) {
  numerics::Quadrature outer, inner;
  const auto over_v = [&](double u) {
    const auto at_v = [&](double v) {
      const Vector2 q = rectangle[0] + u * side1 + v * side2;
      const double p = (1 - u) * ((1 - v) * four_values[0] + v * four_values[3]) +
                       u * ((1 - v) * four_values[1] + v * four_values[2]);
      return p * cross(side1, side2) * part(boussinesq(at - Vector3d(q.x(), q.y(), 0)), which);
    };
    return inner.smooth(at_v, 0, 1, 1e-11, {"a strip", u}).value;
  };
  return outer.smooth(over_v, 0, 1, 1e-10, {"the rectangle", 0}).value;
}

}  // namespace

BOOST_AUTO_TEST_CASE(displacements_and_stresses_are_sums_of_boussinesqs_forces) {
  // beneath the triangle, beneath its edge and its corner, beside it, and above its edge's line
  const Vector2 edge = 0.3 * triangle[0] + 0.7 * triangle[1];
  const Vector2 line = 1.6 * triangle[1] - 0.6 * triangle[0];
  for (const Vector3d& at :
       {Vector3d(0.7, 0.4, 0.3), Vector3d(edge.x(), edge.y(), 0.5),
        Vector3d(triangle[2].x(), triangle[2].y(), 0.4), Vector3d(line.x(), line.y(), 0.2),
        Vector3d(-0.9, 1.1, 0.05), Vector3d(0.2, -0.6, 3)}) {
    const InteriorField f = field(at);
    for (int which = 0; which < 9; ++which) {
      BOOST_TEST(std::abs(part(f, which) - by_quadrature(at, which)) < 1e-9,
                 "number " << which << " at " << at.transpose());
    }
  }
}

BOOST_AUTO_TEST_CASE(those_of_a_bilinear_pressure_are_sums_of_forces_too) {
  const Vector2 edge = 0.3 * rectangle[0] + 0.7 * rectangle[1];
  const Vector2 line = 1.6 * rectangle[1] - 0.6 * rectangle[0];
  for (const Vector3d& at :
       {Vector3d(0.4, 0.4, 0.3), Vector3d(edge.x(), edge.y(), 0.5),
        Vector3d(rectangle[2].x(), rectangle[2].y(), 0.4), Vector3d(line.x(), line.y(), 0.2),
        Vector3d(-0.9, 1.1, 0.05), Vector3d(0.2, -0.6, 3)}) {
    const InteriorField f = bilinear_field(at);
    for (int which = 0; which < 9; ++which) {
      BOOST_TEST(std::abs(part(f, which) - bilinear_by_quadrature(at, which)) < 1e-9,
                 "number " << which << " at " << at.transpose());
    }
  }
}

BOOST_AUTO_TEST_CASE(a_bilinear_pressure_without_a_twist_is_linear) {
  const std::array<double, 4> plane = {0.7, -0.4, 0.8, 1.9};
  const Vector3d at(0.9, 0.1, 0.07);
  InteriorField triangles = interior_field(
      Patch::triangle({rectangle[0], rectangle[1], rectangle[2]}, {plane[0], plane[1], plane[2]}),
      material, at);
  triangles += interior_field(
      Patch::triangle({rectangle[0], rectangle[2], rectangle[3]}, {plane[0], plane[2], plane[3]}),
      material, at);
  const InteriorField whole = interior_field(Patch::bilinear(rectangle, plane), material, at);
  for (int which = 0; which < 9; ++which) {
    BOOST_TEST(std::abs(part(triangles, which) - part(whole, which)) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(stresses_are_symmetric_and_follow_from_the_displacements) {
  // Hooke's law with strains by central differences.
  const double step = 1e-4;
  for (const Vector3d& at : {Vector3d(0.7, 0.4, 0.3), Vector3d(-0.4, 0.2, 0.8)}) {
    Matrix3d gradient;
    for (int j = 0; j < 3; ++j) {
      Vector3d d = Vector3d::Zero();
      d[j] = step;
      gradient.col(j) = (field(at + d).displacement - field(at - d).displacement) / (2 * step);
    }
    const Matrix3d strain = (gradient + gradient.transpose()) / 2;
    const Matrix3d stress =
        2 * shear_modulus * (strain + nu / (1 - 2 * nu) * strain.trace() * Matrix3d::Identity());
    BOOST_TEST((field(at).stress - stress).cwiseAbs().maxCoeff() < 1e-6);
    BOOST_TEST((field(at).stress - field(at).stress.transpose()).cwiseAbs().maxCoeff() < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(just_beneath_the_surface_the_pressure_and_its_displacement_are_met) {
  const Vector2 at(0.7, 0.4);
  const InteriorField f = field({at.x(), at.y(), 1e-9});
  const double displacement = (1 - nu * nu) / (std::numbers::pi * 2.5) *
                              point_contact::linear_potential(triangle, values, at);
  // the pressure there, by the plane through the three values
  const Vector2 b = triangle[1] - triangle[0];
  const Vector2 c = triangle[2] - triangle[0];
  const double u = cross(at - triangle[0], c) / cross(b, c);
  const double v = cross(b, at - triangle[0]) / cross(b, c);
  const double pressure = values[0] + u * (values[1] - values[0]) + v * (values[2] - values[0]);

  BOOST_TEST(std::abs(f.displacement.z() - displacement) < 1e-8);
  BOOST_TEST(std::abs(f.stress(2, 2) + pressure) < 1e-7);
  BOOST_TEST(std::abs(f.stress(0, 2)) < 1e-7);
}

BOOST_AUTO_TEST_CASE(parts_add_up_to_the_whole) {
  const Vector2 middle = (triangle[1] + triangle[2]) / 2;
  const double in_the_middle = (values[1] + values[2]) / 2;
  const Vector3d at(0.9, 0.1, 0.02);
  InteriorField sum = interior_field(
      Patch::triangle({triangle[0], triangle[1], middle}, {values[0], values[1], in_the_middle}),
      material, at);
  sum += interior_field(
      Patch::triangle({triangle[0], middle, triangle[2]}, {values[0], in_the_middle, values[2]}),
      material, at);

  for (int which = 0; which < 9; ++which) {
    BOOST_TEST(std::abs(part(sum, which) - part(field(at), which)) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(the_surface_itself_is_refused) {
  BOOST_CHECK_THROW(field({0.5, 0.5, 0}), sys::InvalidQuantity);
  BOOST_CHECK_THROW(field({0.5, 0.5, -1}), sys::InvalidQuantity);
  BOOST_CHECK_THROW(field({0.5, 0.5, std::nan("")}), sys::InvalidQuantity);
}

BOOST_AUTO_TEST_SUITE_END()
