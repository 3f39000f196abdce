// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/load_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elasticity/concentrated_load.hpp"
#include "elasticity/piecewise_linear_load.hpp"
#include "elasticity/triangular_load.hpp"
#include "system/require.hpp"

namespace elasticity {
namespace {

// [(ξ+1) ln|ξ+1| − (ξ−1) ln|ξ−1|] for ξ = x/a ≥ 0, outside as 2 ln ξ + [(1+η) ln(1+η) − (1−η)
// ln(1−η)]/η with η = 1/ξ, whose two terms have one sign.
double edge_logarithms(double x, double a) {
  const auto t_log = [](double t) { return t == 0 ? 0 : t * std::log(t); };
  if (x <= a) return t_log((a + x) / a) + t_log((a - x) / a);
  const double eta = a / x;
  const double below = eta < 0.5 ? (1 - eta) * std::log1p(-eta) : t_log((x - a) / x);
  return 2 * std::log(x / a) + ((1 + eta) * std::log1p(eta) - below) / eta;
}

// √(ξ² − 1) for ξ ≥ 1, without the square, which may overflow.
double root_outside(double x, double a) {
  return std::sqrt((x - a) / a) * std::sqrt((x + a) / a);
}

// 2 ∫ of the gradient's ξ or ξ − √(ξ²−1).
double elliptic_bracket(double x, double a) {
  const double xi = x / a;
  if (x <= a) return xi * xi;
  const double sum = xi + root_outside(x, a);
  return xi / sum + std::log(sum);
}

// 2ξ + (1−ξ²) ln|(ξ+1)/(ξ−1)| for ξ = x/a ≥ 0.
double parabolic_bracket(double x, double a) {
  const double xi = x / a;
  if (xi > 2) {
    constexpr double negligible = 1e-17;
    const double eta = a / x;
    double sum = 0;
    double power = 1;
    for (double odd = 1; power > negligible; odd += 2) {
      sum += power / (odd * (odd + 2));
      power *= eta * eta;
    }
    return 4 * eta * sum;
  }
  if (x == a) return 2;
  const double below = (a - x) / a;
  const double logarithm = xi < 0.5 ? 2 * std::atanh(xi) : std::log((1 + xi) / std::abs(below));
  return 2 * xi + below * (1 + xi) * logarithm;
}

double parabolic_potential(double x, double a) {
  return element_potential(-1 - x / a, 1 - x / a).middle;
}

// Returns the pressure peak·shape(|x|/a), which has breakpoints at the given fractions of a on both
// sides.
Load symmetric_load(double peak, double half_width, const std::vector<double>& breakpoints,
                    const std::function<double(double)>& shape) {
  sys::require_positive("peak_pressure", peak);
  sys::require_positive("half_width", half_width);
  std::vector<double> ends;
  for (const double fraction : breakpoints) ends.push_back(fraction * half_width);
  return distributed_load([=](double x) { return peak * shape(std::abs(x) / half_width); }, nullptr,
                          ends);
}

template <class Shape>
LoadShape peaked(std::string name, std::string source) {
  return {.name = std::move(name),
          .parameter = "",
          .numbers = {"peak-pressure", "half-width"},
          .source = std::move(source),
          .make = [](const LoadNumbers& given) -> KnownLoad {
            const Shape load(given.peak_pressure.value(), given.half_width.value());
            return {load, closed_surface_of(load)};
          }};
}

KnownLoad known_linear_fall(const LoadNumbers& given) {
  const double p0 = given.peak_pressure.value();
  const double a = given.half_width.value();
  const double at_edge = given.parameter.value() * p0;
  return {linear_fall(p0, given.parameter.value(), a),
          closed_surface_of(PiecewiseLinearLoad({-a, 0, a}, {at_edge, p0, at_edge}))};
}

KnownLoad known_power_fall(const LoadNumbers& given) {
  return {
      power_fall(given.peak_pressure.value(), given.parameter.value(), given.half_width.value())};
}

KnownLoad known_cosine_fall(const LoadNumbers& given) {
  return {cosine_fall(given.peak_pressure.value(), given.half_width.value())};
}

KnownLoad known_concentrated(const LoadNumbers& given) {
  const ConcentratedLoad load(given.line_load.value());
  return {load, closed_surface_of(load)};
}

}  // namespace

const std::vector<LoadNumber>& load_numbers() {
  static const std::vector<LoadNumber> numbers = {
      {"peak-pressure", "p0, the greatest pressure", &LoadNumbers::peak_pressure},
      {"half-width", "a: the load acts on |x| <= a", &LoadNumbers::half_width},
      {"line-load", "P of a concentrated load", &LoadNumbers::line_load}};
  return numbers;
}

const std::vector<LoadShape>& load_shapes() {
  const std::vector<std::string> peak_and_width = {"peak-pressure", "half-width"};
  static const std::vector<LoadShape> shapes = {
      peaked<TriangularLoad>("triangular", "eq. (3) and its derivative"),
      peaked<UniformLoad>("uniform", "Johnson, section 2.5"),
      peaked<EllipticLoad>("elliptic", "Hertz, Johnson 4.47, 4.48"),
      peaked<ParabolicLoad>("parabolic", "the integral of eq. (2) in logarithms"),
      {"linear", "EDGE_FRACTION", peak_and_width, "a sum of eq. (3) over unequal triangles",
       known_linear_fall},
      {"power", "EXPONENT", peak_and_width, "", known_power_fall},
      {"cosine", "", peak_and_width, "", known_cosine_fall},
      {"concentrated", "", {"line-load"}, "Flamant, Johnson 2.19", known_concentrated}};
  return shapes;
}

UniformLoad::operator Load() const {
  Load load;
  load.normal = numerics::PiecewiseFunction(
      {{-half_width(), half_width(), [p = peak_pressure()](double) { return p; }}});
  return load;
}

double normal_gradient(const Material& material, const UniformLoad& load, double x) {
  const double a = load.half_width();
  const double distance = std::abs(sys::require_finite("x", x));
  if (distance == a) {
    throw sys::InvalidQuantity("x", x, "off the edge of the load, where the gradient is infinite");
  }
  // ln|(x+a)/(x−a)| = 2 atanh of the smaller of x/a and a/x; near the edge the plain form is exact.
  const double ratio = distance < a ? distance / a : a / distance;
  const double logarithm =
      ratio < 0.5 ? 2 * std::atanh(ratio) : std::log((distance + a) / std::abs(distance - a));
  const double magnitude = material.integral_compliance() * load.peak_pressure() * logarithm;
  return x > 0 ? -magnitude : magnitude;
}

double normal_displacement(const Material& material, const UniformLoad& load, double x,
                           double datum) {
  const double a = load.half_width();
  const double scale = material.integral_compliance() * load.peak_pressure() * a;
  const double here = edge_logarithms(std::abs(sys::require_finite("x", x)), a);
  const double there = edge_logarithms(std::abs(sys::require_finite("datum", datum)), a);
  return -scale * (here - there);
}

double tangential_displacement(const Material& material, const UniformLoad& load, double x) {
  const double a = load.half_width();
  return -material.local_compliance() * load.peak_pressure() *
         std::clamp(sys::require_finite("x", x), -a, a);
}

double EllipticLoad::line_load() const {
  return std::numbers::pi / 2 * peak_pressure() * half_width();
}

EllipticLoad::operator Load() const {
  const auto pressure = [p0 = peak_pressure(), a = half_width()](double s) {
    return p0 * std::sqrt(std::max(0.0, (a - s) / a * ((a + s) / a)));
  };
  return distributed_load(pressure, nullptr, {-half_width(), half_width()});
}

double normal_gradient(const Material& material, const EllipticLoad& load, double x) {
  const double a = load.half_width();
  const double distance = std::abs(sys::require_finite("x", x));
  const double scale = std::numbers::pi * material.integral_compliance() * load.peak_pressure();
  const double xi = distance / a;
  const double magnitude = scale * (distance <= a ? xi : 1 / (xi + root_outside(distance, a)));
  return x > 0 ? -magnitude : magnitude;
}

double normal_displacement(const Material& material, const EllipticLoad& load, double x,
                           double datum) {
  const double a = load.half_width();
  const double here = elliptic_bracket(std::abs(sys::require_finite("x", x)), a);
  const double there = elliptic_bracket(std::abs(sys::require_finite("datum", datum)), a);
  return -material.integral_compliance() * load.line_load() * (here - there);
}

double tangential_displacement(const Material& material, const EllipticLoad& load, double x) {
  const double xi = std::min(1.0, std::abs(sys::require_finite("x", x)) / load.half_width());
  const double between = load.peak_pressure() * load.half_width() *
                         (xi * std::sqrt((1 - xi) * (1 + xi)) + std::asin(xi));
  const double magnitude = material.local_compliance() / 2 * between;
  return x > 0 ? -magnitude : magnitude;
}

ParabolicLoad::operator Load() const {
  const auto pressure = [p0 = peak_pressure(), a = half_width()](double s) {
    return p0 * ((a - s) / a) * ((a + s) / a);
  };
  return distributed_load(pressure, nullptr, {-half_width(), half_width()});
}

double normal_gradient(const Material& material, const ParabolicLoad& load, double x) {
  const double bracket =
      parabolic_bracket(std::abs(sys::require_finite("x", x)), load.half_width());
  const double magnitude = material.integral_compliance() * load.peak_pressure() * bracket;
  return x > 0 ? -magnitude : magnitude;
}

double normal_displacement(const Material& material, const ParabolicLoad& load, double x,
                           double datum) {
  const double a = load.half_width();
  const double here = parabolic_potential(std::abs(sys::require_finite("x", x)), a);
  const double there = parabolic_potential(std::abs(sys::require_finite("datum", datum)), a);
  return -material.integral_compliance() * load.peak_pressure() * a * (here - there);
}

double tangential_displacement(const Material& material, const ParabolicLoad& load, double x) {
  const double xi = std::min(1.0, std::abs(sys::require_finite("x", x)) / load.half_width());
  const double between = load.peak_pressure() * load.half_width() * xi * (2 - 2 * xi * xi / 3);
  const double magnitude = material.local_compliance() / 2 * between;
  return x > 0 ? -magnitude : magnitude;
}

Load linear_fall(double peak, double edge_fraction, double half_width) {
  if (!(std::isfinite(edge_fraction) && edge_fraction >= 0)) {
    throw sys::InvalidQuantity("edge_fraction", edge_fraction, "a finite number, 0 or more");
  }
  return symmetric_load(peak, half_width, {-1, 0, 1},
                        [=](double t) { return (1 - t) + edge_fraction * t; });
}

Load power_fall(double peak, double exponent, double half_width) {
  sys::require_positive("exponent", exponent);
  // An even power of |x| is smooth in the middle; any other has a kink or a root there
  const std::vector<double> ends =
      std::fmod(exponent, 2) == 0 ? std::vector<double>{-1, 1} : std::vector<double>{-1, 0, 1};
  return symmetric_load(peak, half_width, ends,
                        [=](double t) { return 1 - std::pow(t, exponent); });
}

Load cosine_fall(double peak, double half_width) {
  return symmetric_load(peak, half_width, {-1, 1},
                        [](double t) { return (1 + std::cos(std::numbers::pi * t)) / 2; });
}

}  // namespace elasticity
