// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity/interior_stress.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string_view>

#include "system/require.hpp"

namespace elasticity {
namespace {

using Complex = std::complex<double>;

// std::complex asks each product whether it is NaN, and has real numbers promoted; this does not.
inline Complex times(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

// F, and zF′ as slope, of the tractions that fall from 1 at one end of a segment to 0 at the other.
struct EndIntegrals {
  Complex F1;
  Complex F2;
  Complex slope1;
  Complex slope2;
};

// The surface is reached as a limit, from this share of the width of the load. It is small enough
// for all that depends on it to vanish beside 1, and its square does not underflow.
constexpr double least_depth = 1e-60;

// Where half-length/distance is less than 1/10 the closed form would lose two digits or more, and
// the series needs at most eight terms.
constexpr double far_ratio_squared = 1e-2;

// w seen from an end of a segment: w − x1 = t + iz.
struct Offset {
  Offset(double t_from, double z) : t(t_from), r_squared(t_from * t_from + z * z) {}
  double t;
  double r_squared;
};

// Integrate by the closed form. (w−x1)/(w−x2) has the argument of (w−x1)·conj(w−x2).
EndIntegrals closed_form(const Offset& from1, const Offset& from2, double z, double length) {
  const Complex L(std::log(from1.r_squared / from2.r_squared) / 2,
                  std::atan2(-z * length, from1.t * from2.t + z * z));
  const Complex scaled = z / length * L;
  const Complex pole1 = z / from1.r_squared * Complex(from1.t, -z);
  const Complex pole2 = z / from2.r_squared * Complex(from2.t, -z);
  const Complex hat1(-from2.t / length, -z / length);  // 1 at x1, 0 at x2, continued to w
  const Complex hat2(from1.t / length, z / length);
  return {times(hat1, L) + 1.0, times(hat2, L) - 1.0, pole1 - scaled, scaled - pole2};
}

// S = Σ ε²ᵏ/(2k+3) over k < n_terms, for more terms (atanh ε/ε − 1)/ε².
template <int n_terms>
inline Complex series(Complex epsilon_squared) {
  Complex sum = 1.0 / (2 * n_terms + 1);
  for (int k = n_terms - 2; k >= 0; --k) sum = times(sum, epsilon_squared) + 1.0 / (2 * k + 3);
  return sum;
}

// Sum as many terms as leave less than 1e-16.
inline Complex series(Complex epsilon_squared, double magnitude_squared) {
  if (magnitude_squared < 1e-8) return series<2>(epsilon_squared);
  if (magnitude_squared < 1e-4) return series<4>(epsilon_squared);
  return series<8>(epsilon_squared);
}

// Integrate by the series in ε = h·c, h half the length and c = 1/(w − middle). A traction 1 has
// F = 2 atanh ε, one that rises from −1 to 1 has F = 2(atanh ε/ε − 1); dε/dw = −cε.
inline EndIntegrals far_field(Complex c, double h, double magnitude_squared, double z) {
  const Complex epsilon = h * c;
  const Complex square = times(epsilon, epsilon);
  const Complex S = series(square, magnitude_squared);
  const Complex excess = times(square, S);
  const Complex mean = epsilon + times(epsilon, excess);
  const Complex R = 1 / std::norm(1.0 - square) * std::conj(1.0 - square);  // 1/(1 − ε²)
  const Complex slope = -z * times(c, epsilon);
  const Complex d_mean = times(slope, R);
  const Complex d_rise = times(slope, times(epsilon, R - S));
  return {mean - excess, mean + excess, d_mean - d_rise, d_mean + d_rise};
}

// The length is not left to from1.t − from2.t, which far away has few of its digits.
inline EndIntegrals end_integrals(const Offset& from1, const Offset& from2, double z,
                                  double length) {
  const double h = length / 2;
  const double t = (from1.t + from2.t) / 2;
  const double inverse = 1 / (t * t + z * z);
  const double magnitude_squared = h * h * inverse;
  if (!(magnitude_squared < far_ratio_squared)) return closed_form(from1, from2, z, length);
  return far_field(inverse * Complex(t, -z), h, magnitude_squared, z);
}

// F, zF′, G and zG′ summed over segments.
class Sum {
 public:
  void add(const EndIntegrals& ends, double p1, double p2, double q1, double q2) {
    F_ += p1 * ends.F1 + p2 * ends.F2;
    depth_dF_ += p1 * ends.slope1 + p2 * ends.slope2;
    G_ += q1 * ends.F1 + q2 * ends.F2;
    depth_dG_ += q1 * ends.slope1 + q2 * ends.slope2;
  }

  Stress inside() const {
    const double xx = F_.imag() + depth_dF_.real() - 2 * G_.real() + depth_dG_.imag();
    const double zz = F_.imag() - depth_dF_.real() - depth_dG_.imag();
    const double xz = -depth_dF_.imag() + G_.imag() + depth_dG_.real();
    return std::numbers::inv_pi * Stress{xx, zz, xz};
  }

  // The limit of the above for z → 0 where the tractions are p and q.
  Stress on_surface(double p, double q) const {
    return {-p - 2 * std::numbers::inv_pi * G_.real(), -p, -q};
  }

 private:
  Complex F_;
  Complex depth_dF_;
  Complex G_;
  Complex depth_dG_;
};

void require_inside(double x, double z) {
  sys::require_finite("x", x);
  if (!(std::isfinite(z) && z >= 0)) {
    throw sys::InvalidQuantity("z", z, "a finite depth, 0 or more");
  }
}

// An end of a load is a jump unless both tractions vanish there.
void refuse_jump(double x, double z, double end, double p, double q) {
  if (z == 0 && x == end && (p != 0 || q != 0)) {
    throw sys::InvalidQuantity("x", x, "off a jump of the traction on the surface");
  }
}

void require_rising(double before, double after) {
  sys::require_finite("node", before);
  if (!(sys::require_finite("node", after) > before)) {
    throw sys::InvalidQuantity("node", after, "greater than the node before it");
  }
}

// A traction as given, or zeros for one that is not.
std::vector<double> at_nodes(std::string_view name, std::span<const double> values,
                             std::size_t n_nodes) {
  if (values.empty()) return std::vector<double>(n_nodes);
  if (values.size() != n_nodes) {
    throw sys::InvalidQuantity(name, static_cast<double>(values.size()),
                               "as many values as nodes, or none");
  }
  for (const double value : values) sys::require_finite(name, value);
  return {values.begin(), values.end()};
}

// From the nearer end, so that it is exact at both and keeps its digits beside a zero.
double linear(double x, double x1, double x2, double v1, double v2) {
  const double slope = (v2 - v1) / (x2 - x1);
  return x - x1 < x2 - x ? v1 + slope * (x - x1) : v2 - slope * (x2 - x);
}

}  // namespace

Stress stress_under(const LinearSegment& segment, double x, double z) {
  const auto& [x1, x2, p1, p2, q1, q2] = segment;
  require_rising(x1, x2);
  for (const double p : {p1, p2}) sys::require_finite("pressure", p);
  for (const double q : {q1, q2}) sys::require_finite("shear", q);
  require_inside(x, z);
  refuse_jump(x, z, x1, p1, q1);
  refuse_jump(x, z, x2, p2, q2);

  const double depth = std::max(z, least_depth * (x2 - x1));
  Sum sum;
  sum.add(end_integrals({x - x1, depth}, {x - x2, depth}, depth, x2 - x1), p1, p2, q1, q2);
  if (z > 0) return sum.inside();
  const bool is_under = x > x1 && x < x2;
  return sum.on_surface(is_under ? linear(x, x1, x2, p1, p2) : 0,
                        is_under ? linear(x, x1, x2, q1, q2) : 0);
}

Stress stress_under(const TriangularLoad& load, double x, double z) {
  require_inside(x, z);
  const double a = load.half_width();
  const double p0 = load.peak_pressure();
  const double depth = std::max(z, least_depth * a);

  Sum sum;
  const Offset from_middle(x, depth);
  sum.add(end_integrals({x + a, depth}, from_middle, depth, a), 0, p0, 0, 0);
  sum.add(end_integrals(from_middle, {x - a, depth}, depth, a), p0, 0, 0, 0);
  if (z > 0) return sum.inside();
  return sum.on_surface(p0 * std::max(0.0, a - std::abs(x)) / a, 0);
}

PiecewiseLinearTraction::PiecewiseLinearTraction(std::span<const double> nodes,
                                                 std::span<const double> pressure,
                                                 std::span<const double> shear)
    : nodes_(nodes.begin(), nodes.end()),
      pressure_(at_nodes("pressure", pressure, nodes.size())),
      shear_(at_nodes("shear", shear, nodes.size())) {
  if (nodes.size() < 2) {
    throw sys::InvalidQuantity("nodes", static_cast<double>(nodes.size()), "two or more");
  }
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) require_rising(nodes[i], nodes[i + 1]);
}

double PiecewiseLinearTraction::pressure(double x) const {
  return value(pressure_, x);
}

double PiecewiseLinearTraction::shear(double x) const {
  return value(shear_, x);
}

double PiecewiseLinearTraction::value(const std::vector<double>& traction, double x) const {
  if (!(x >= nodes_.front() && x <= nodes_.back())) return 0;
  const auto after = std::upper_bound(nodes_.begin(), nodes_.end() - 1, x);
  const auto i = static_cast<std::size_t>(after - nodes_.begin());
  return linear(x, nodes_[i - 1], nodes_[i], traction[i - 1], traction[i]);
}

Stress PiecewiseLinearTraction::stress(double x, double z) const {
  require_inside(x, z);
  refuse_jump(x, z, nodes_.front(), pressure_.front(), shear_.front());
  refuse_jump(x, z, nodes_.back(), pressure_.back(), shear_.back());

  const double depth = std::max(z, least_depth * (nodes_.back() - nodes_.front()));
  Sum sum;
  Offset before(x - nodes_[0], depth);
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    const Offset after(x - nodes_[i], depth);
    const double length = nodes_[i] - nodes_[i - 1];
    sum.add(end_integrals(before, after, depth, length), pressure_[i - 1], pressure_[i],
            shear_[i - 1], shear_[i]);
    before = after;
  }
  return z > 0 ? sum.inside() : sum.on_surface(pressure(x), shear(x));
}

}  // namespace elasticity
