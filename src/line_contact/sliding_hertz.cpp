// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_contact/sliding_hertz.hpp"

#include <cmath>
#include <complex>

#include "system/require.hpp"

namespace line_contact {

SlidingHertz::SlidingHertz(const Hertz& hertz, double friction)
    : half_width_(hertz.half_width()),
      peak_pressure_(hertz.peak_pressure()),
      friction_(sys::require_finite("friction", friction)) {}

elasticity::Stress SlidingHertz::stress(double x, double z) const {
  sys::require_finite("x", x);
  sys::require_positive("z", z);
  const double a = half_width_;
  const double p = peak_pressure_;
  const double mu = friction_;
  const std::complex<double> w(x, z);
  const std::complex<double> root = std::sqrt(w - a) * std::sqrt(w + a);
  const std::complex<double> f = p / a * (w - root);             // F/π
  const std::complex<double> zf = z * p / a * (1.0 - w / root);  // zF′/π
  return {f.imag() + zf.real() - 2 * mu * f.real() + mu * zf.imag(),
          f.imag() - zf.real() - mu * zf.imag(), -zf.imag() + mu * (f.imag() + zf.real())};
}

}  // namespace line_contact
