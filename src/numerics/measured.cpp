// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/measured.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "numerics/estimate_algebra.hpp"
#include "system/require.hpp"

namespace numerics {
namespace {

constexpr double half_ulp = std::numeric_limits<double>::epsilon() / 2;  // relative

double require_not_negative(std::string_view quantity, double value) {
  if (std::isfinite(value) && value >= 0) return value;
  throw sys::InvalidQuantity(quantity, value, "a finite number >= 0");
}

}  // namespace

// How one step of a computation carries the uncertainties of its operands.
class Propagation {
 public:
  static Measured known(Estimate number) {
    Measured made;
    made.bounded_ = {sys::require_finite("a number", number.value),
                     require_not_negative("an error bound", number.abs_error)};
    return made;
  }

  static Measured from_source(double value, double standard, std::string_view source) {
    Measured made = known({value, 0});
    require_not_negative("a standard uncertainty", standard);
    if (standard > 0) made.components_.emplace(source, standard);
    return made;
  }

  // f(a) with f′ and f″ at a
  static Measured of(const Measured& a, Estimate f, double slope, double curvature) {
    Measured made = known(f);
    add(made, slope, a);
    const double u = a.standard();
    made.neglected_ += std::abs(curvature) * u * u / 2;
    return finite(made);
  }

  // a + sign b. What a source leaves uncertain may cancel, but not that a and b were rounded to
  // doubles: where one cancels, half a unit of the last place of either counts.
  static Measured sum(const Measured& a, const Measured& b, double sign) {
    Measured made = known(a.bounded() + sign * b.bounded());
    add(made, 1, a);
    add(made, sign, b);
    const std::size_t n_sources = made.components_.size();
    made = finite(made);
    if (made.components_.size() < n_sources && made.value() != 0) {
      made.bounded_.abs_error += half_ulp * (std::abs(a.value()) + std::abs(b.value()));
    }
    return made;
  }

  // f(a, b) with ∂f/∂a and ∂f/∂b; `second_order` bounds the terms of second order
  static Measured of(const Measured& a, const Measured& b, Estimate f, double slope_a,
                     double slope_b, double second_order) {
    Measured made = known(f);
    add(made, slope_a, a);
    add(made, slope_b, b);
    made.neglected_ += second_order;
    return finite(made);
  }

 private:
  // What a source adds twice may cancel; then rounding alone would be left of it.
  static void add(Measured& made, double slope, const Measured& a) {
    constexpr double of_rounding = 64 * half_ulp;
    for (const auto& [source, component] : a.components_) {
      double& sum = made.components_[source];
      const double added = slope * component;
      const double whole = std::abs(sum) + std::abs(added);
      sum += added;
      if (std::abs(sum) <= of_rounding * whole) sum = 0;
    }
    made.neglected_ += std::abs(slope) * a.neglected_;
  }

  // The same without sources that cancel; refuses what overflowed.
  static Measured finite(Measured made) {
    std::erase_if(made.components_, [](const auto& named) { return named.second == 0; });
    sys::require_finite("a standard uncertainty", made.standard());
    sys::require_finite("a term of second order", made.neglected_);
    return made;
  }
};

namespace {

// Throws unless |a| or, if it has to be positive, a is farther from zero than it is uncertain.
void require_away_from_zero(std::string_view quantity, const Measured& a, double distance) {
  const double reach = a.bounded().abs_error + a.standard();
  if (distance > reach) return;
  std::string sources;
  constexpr std::size_t most_named = 3;
  for (const auto& [source, u] : a.components().size() > most_named ? a.kinds() : a.components()) {
    sources += fmt::format("{}'{}'", sources.empty() ? " of " : " and ", source);
  }
  throw sys::InvalidQuantity(
      quantity, a.value(),
      fmt::format("farther from 0 than its bound and its standard uncertainty{}, {}", sources,
                  reach));
}

}  // namespace

Measured::Measured(double exact) : Measured(Propagation::known({exact, 0})) {}

Measured::Measured(double value, double standard, std::string_view source)
    : Measured(Propagation::from_source(value, standard, source)) {
  if (source.empty()) {
    throw sys::InvalidQuantity("length of the name of a source", 0, "1 or more");
  }
}

Measured Measured::bounded(Estimate number) {
  return Propagation::known(number);
}

double Measured::standard() const {
  double u = 0;
  for (const auto& [source, component] : components_) u = std::hypot(u, component);
  return u;
}

std::map<std::string, double> Measured::kinds() const {
  std::map<std::string, double> kinds;
  for (const auto& [source, component] : components_) {
    double& u = kinds[source.substr(0, source.find('/'))];
    u = std::hypot(u, component);
  }
  return kinds;
}

double covariance(const Measured& a, const Measured& b) {
  double sum = 0;
  for (const auto& [source, component] : a.components()) {
    const auto other = b.components().find(source);
    if (other != b.components().end()) sum += component * other->second;
  }
  return sum;
}

double correlation(const Measured& a, const Measured& b) {
  const double u_a = sys::require_positive("standard uncertainty", a.standard());
  const double u_b = sys::require_positive("standard uncertainty", b.standard());
  return covariance(a, b) / u_a / u_b;
}

Measured given(const Measured& a, const Measured& b, double known) {
  const double u_b = sys::require_positive("standard uncertainty", b.standard());
  return a - covariance(a, b) / (u_b * u_b) * (b - known);
}

Measured operator-(const Measured& a) {
  return Propagation::of(a, -a.bounded(), -1, 0);
}

Measured operator+(const Measured& a, const Measured& b) {
  return Propagation::sum(a, b, 1);
}

Measured operator-(const Measured& a, const Measured& b) {
  return Propagation::sum(a, b, -1);
}

Measured operator*(const Measured& a, const Measured& b) {
  return Propagation::of(a, b, a.bounded() * b.bounded(), b.value(), a.value(),
                         a.standard() * b.standard());
}

// With q = a/b: ∂q/∂a = 1/b, ∂q/∂b = −q/b. The terms of second order, −δa δb/b² + q (δb)²/b², are
// −(δb/b) δq with δq = δa/b − q δb/b, that of first order, in which common sources cancel.
Measured operator/(const Measured& a, const Measured& b) {
  require_away_from_zero("divisor", b, std::abs(b.value()));
  const Estimate quotient = a.bounded() / b.bounded();
  const auto with = [&](double second_order) {
    return Propagation::of(a, b, quotient, 1 / b.value(), -quotient.value / b.value(),
                           second_order);
  };
  return with(b.standard() / std::abs(b.value()) * with(0).standard());
}

Measured sqrt(const Measured& a) {
  require_away_from_zero("radicand", a, a.value());
  const Estimate root = sqrt(a.bounded());
  return Propagation::of(a, root, 0.5 / root.value, 0.25 / root.value / a.value());
}

Measured log(const Measured& a) {
  require_away_from_zero("argument of log", a, a.value());
  return Propagation::of(a, log(a.bounded()), 1 / a.value(), 1 / a.value() / a.value());
}

Measured exp(const Measured& a) {
  const Estimate power = exp(a.bounded());
  return Propagation::of(a, power, power.value, power.value);
}

}  // namespace numerics
