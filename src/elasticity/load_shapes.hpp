// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes of a pressure on |x| ≤ a, and the table in which every load has its name. (The paper's
// triangle, a concentrated force and a pressure given at points have files of their own.)
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elasticity/load.hpp"
#include "elasticity/material.hpp"

namespace elasticity {

/// The uniform pressure p(x) = p₀ for |x| ≤ a.
class UniformLoad : public PeakedLoad {
 public:
  using PeakedLoad::PeakedLoad;

  /// The resultant 2p₀a, force per unit length.
  double line_load() const { return 2 * peak_pressure() * half_width(); }

  operator Load() const;  // NOLINT(google-explicit-constructor): a uniform load is a load
};

/// ∂u_z/∂x = −2(1−ν²)p₀/(πE) ln|(x + a)/(x − a)| under a uniform load (eq. 2; Johnson, section 2.5
/// derived).
///
/// Dimensionless. Throws InvalidQuantity at x = ±a, where the gradient is infinite: the step in
/// traction that the paper holds against uniform elements. Accuracy: 1e-14 relative.
double normal_gradient(const Material& material, const UniformLoad& load, double x);

/// u_z = −(1−ν²)p₀/(πE) [(x+a) ln((x+a)/a)² − (x−a) ln((x−a)/a)²] + C with u_z(datum) = 0 (Johnson,
/// section 2.5). A length, positive into the body; any finite x and datum.
///
/// Accuracy: 1e-14·K·(1 + ln(datum/a)) absolute, K = 4(1−ν²)p₀a/(πE).
double normal_displacement(const Material& material, const UniformLoad& load, double x,
                           double datum);

/// u_x = −[(1−2ν)(1+ν)/E] p₀ x under the load, outside as at the edge: Johnson (2.24a) with q = 0.
/// A length, positive along x; any finite x.
double tangential_displacement(const Material& material, const UniformLoad& load, double x);

/// Hertz's pressure p(x) = p₀ √(1 − x²/a²) for |x| ≤ a.
class EllipticLoad : public PeakedLoad {
 public:
  using PeakedLoad::PeakedLoad;

  /// The resultant ½πp₀a, force per unit length.
  double line_load() const;

  operator Load() const;  // NOLINT(google-explicit-constructor): an elliptic load is a load
};

/// ∂u_z/∂x = −[2(1−ν²)p₀/E] ξ inside, ξ = x/a, and with ξ ∓ √(ξ²−1) in place of ξ outside (Johnson
/// 4.47, 4.48 derived). Dimensionless; any finite x. Accuracy: 1e-15 relative.
double normal_gradient(const Material& material, const EllipticLoad& load, double x);

/// u_z = −[(1−ν²)p₀a/E] [B(ξ) − B(datum/a)], B = ξ² inside and ξ/(ξ+s) + ln(ξ+s), s = √(ξ²−1),
/// outside, where ξ = |x|/a. A length, positive into the body; any finite x and datum. Accuracy:
/// 1e-15 of the two terms.
double normal_displacement(const Material& material, const EllipticLoad& load, double x,
                           double datum);

/// u_x = −[(1−2ν)(1+ν)/(2E)] p₀a [ξ √(1−ξ²) + arcsin ξ], Johnson (2.24a) with q = 0; outside as at
/// the edge. A length, positive along x.
double tangential_displacement(const Material& material, const EllipticLoad& load, double x);

/// The parabolic pressure p(x) = p₀ (1 − x²/a²) for |x| ≤ a.
class ParabolicLoad : public PeakedLoad {
 public:
  using PeakedLoad::PeakedLoad;

  /// The resultant 4p₀a/3, force per unit length.
  double line_load() const { return 4 * peak_pressure() * half_width() / 3; }

  operator Load() const;  // NOLINT(google-explicit-constructor): a parabolic load is a load
};

/// ∂u_z/∂x = −[2(1−ν²)p₀/(πE)] [2ξ + (1−ξ²) ln|(ξ+1)/(ξ−1)|], ξ = x/a (eq. 2), for |ξ| > 2 as the
/// series 4 Σ ξ^{−2k−1}/((2k+1)(2k+3)). Dimensionless; any finite x, ±a included. Accuracy: 1e-15
/// relative.
double normal_gradient(const Material& material, const ParabolicLoad& load, double x);

/// u_z = −[2(1−ν²)p₀a/(πE)] [Φ(x) − Φ(datum)], Φ(x) = ∫ (1−σ²) ln|ξ−σ| dσ from −1 to 1
/// (element_potential). A length, positive into the body; any finite x and datum. Accuracy: 1e-14
/// of the two terms.
double normal_displacement(const Material& material, const ParabolicLoad& load, double x,
                           double datum);

/// u_x = −[(1−2ν)(1+ν)/(2E)] p₀a (2ξ − ⅔ξ³), Johnson (2.24a) with q = 0; outside as at the edge. A
/// length, positive along x.
double tangential_displacement(const Material& material, const ParabolicLoad& load, double x);

/// p(x) = p₀·[1 − (1 − edge_fraction)|x|/a]: a pressure that falls linearly from its peak in the
/// middle to edge_fraction·p₀ at the ends. 0 is the triangle of eq. (4), 1 uniform.
///
/// p₀ (stress) and a (length) > 0, edge_fraction ≥ 0; InvalidQuantity otherwise.
Load linear_fall(double peak_pressure, double edge_fraction, double half_width);

/// p(x) = p₀·(1 − |x/a|ᵐ), m > 0: the triangle for m = 1, a parabola for 2, the quartic for 4.
/// Resultant 2m/(m + 1)·p₀·a. Unless m is an even number the middle counts as a kink.
Load power_fall(double peak_pressure, double exponent, double half_width);

/// p(x) = p₀·(1 + cos(πx/a))/2: a fall that is steepest at a/2 and level in the middle and at the
/// ends. Resultant p₀·a.
Load cosine_fall(double peak_pressure, double half_width);

/// The numbers that may describe a load; a shape takes those that it needs.
struct LoadNumbers {
  std::optional<double> peak_pressure;  ///< p₀, a stress
  std::optional<double> half_width;     ///< a, a length
  std::optional<double> line_load;      ///< P, force per unit length
  std::optional<double> parameter;      ///< of the shape, such as an exponent
};

/// One of them: its name, such as "peak-pressure", and what it is.
struct LoadNumber {
  std::string name;
  std::string meaning;
  std::optional<double> LoadNumbers::*number;
};

/// All but the parameter.
const std::vector<LoadNumber>& load_numbers();

/// The surface of a half-space under a load in closed form, functions of x; each is empty where no
/// closed form is known.
struct ClosedSurface {
  std::function<double(double)> normal_gradient, normal_displacement;
  std::function<double(double)> tangential_gradient, tangential_displacement;
};

/// A load and, if that is known, the surface beneath it with u_z(datum) = 0.
struct KnownLoad {
  Load load;
  std::function<ClosedSurface(const Material&, double datum)> surface = nullptr;
};

/// The closed forms of a load such as TriangularLoad: its functions of this namespace.
template <class Shape>
std::function<ClosedSurface(const Material&, double)> closed_surface_of(const Shape& load) {
  return [load](const Material& material, double datum) {
    ClosedSurface surface;
    surface.normal_gradient = [=](double x) { return normal_gradient(material, load, x); };
    surface.normal_displacement = [=](double x) {
      return normal_displacement(material, load, x, datum);
    };
    if constexpr (requires { tangential_displacement(material, load, 0.0); }) {
      surface.tangential_gradient = [=, any = Load(load)](double x) {
        return tangential_gradient(material, any, x);
      };
      surface.tangential_displacement = [=](double x) {
        return tangential_displacement(material, load, x);
      };
    }
    return surface;
  };
}

/// A load that has a name.
struct LoadShape {
  std::string name;       ///< such as "uniform"
  std::string parameter;  ///< what LoadNumbers::parameter is, such as "EXPONENT"; empty for none
  std::vector<std::string> numbers;  ///< the names of the others that it needs
  std::string source;                ///< of the closed forms, such as "eq. (3)"; empty without them
  std::function<KnownLoad(const LoadNumbers&)> make;  ///< throws InvalidQuantity
};

/// All of them. What names, asks for or lists a load follows from this table.
const std::vector<LoadShape>& load_shapes();

}  // namespace elasticity
