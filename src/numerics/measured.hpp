// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with standard uncertainties.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "numerics/estimate.hpp"

namespace numerics {

/// A number with a standard uncertainty, a sum over sources that have names, and with a bound.
///
/// The law of propagation: with the sensitivity cᵢ = ∂f/∂xᵢ to what the source i leaves uncertain
/// by u(xᵢ), the combined standard uncertainty is u = √Σ (cᵢ u(xᵢ))² (JCGM 100:2008, the GUM,
/// eq. (10)). Sources are independent of one another, and one name is one source: numbers that
/// have a name in common are correlated by it, so that x − x has no uncertainty (of numbers that
/// differ, what is left has the bound of their rounding to doubles), and two
/// weights from one balance that shows too much are both too great. What a name begins with, up to
/// a solidus, is its kind: "statistics/first run".
///
/// What is bounded and not distributed, such as rounding or an error of quadrature, stays apart:
/// the true number lies within the bound of a number that the sources spread about value().
///
/// The law is linear. neglected() says how much of the next order it leaves out.
class Measured {
 public:
  /// An exact number.
  Measured(double exact);  // NOLINT(google-explicit-constructor): as an Estimate's factors are

  /// A number that one source leaves uncertain by `standard` ≥ 0. Throws InvalidQuantity for other
  /// numbers, and for a name that is empty.
  Measured(double value, double standard, std::string_view source);

  /// A number with a bound and no standard uncertainty. It is said and not converted, since a
  /// bound is no standard deviation.
  static Measured bounded(Estimate number);

  double value() const { return bounded_.value; }

  /// The number with the bound alone.
  Estimate bounded() const { return bounded_; }

  /// u, in the unit of value().
  double standard() const;

  /// What the sources of each kind add to it, such as "statistics".
  std::map<std::string, double> kinds() const;

  /// cᵢ u(xᵢ) by the names of the sources, in the unit of value(); none is 0.
  const std::map<std::string, double>& components() const { return components_; }

  /// No less than the terms of second order that the law leaves out, in the unit of value():
  /// ½ |f″| u² of each step. Where it is not small beside standard(), the law does not hold.
  double neglected() const { return neglected_; }

 private:
  friend class Propagation;
  Measured() = default;

  Estimate bounded_;
  std::map<std::string, double> components_;
  double neglected_ = 0;
};

/// The covariance of two numbers, Σ (cᵢ u)(c'ᵢ u) over the sources that they have in common.
double covariance(const Measured& a, const Measured& b);

/// Their covariance over both standard uncertainties. Throws InvalidQuantity where one has none.
double correlation(const Measured& a, const Measured& b);

/// The first number, if the second is found to be exactly `known`: a − cov(a, b)/u²(b) (b − known).
/// Of coefficients of a linear fit it is that of the fit with b held there. Throws InvalidQuantity
/// for a b without standard uncertainty.
Measured given(const Measured& a, const Measured& b, double known);

Measured operator-(const Measured& a);
Measured operator+(const Measured& a, const Measured& b);
Measured operator-(const Measured& a, const Measured& b);
Measured operator*(const Measured& a, const Measured& b);

/// a/b. Throws InvalidQuantity where zero is no farther from b than its bound and its standard
/// uncertainty together.
Measured operator/(const Measured& a, const Measured& b);

/// Throws InvalidQuantity where a is not above zero by more than its bound and its standard
/// uncertainty, as log does.
Measured sqrt(const Measured& a);
Measured log(const Measured& a);

Measured exp(const Measured& a);

}  // namespace numerics
