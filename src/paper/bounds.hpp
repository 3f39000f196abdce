// SPDX-License-Identifier: GPL-3.0-or-later
// How wrong what the report prints may be: each bound with where it comes from.
#pragma once

#include "line_contact/solution.hpp"
#include "paper/prelude.hpp"

namespace paper {

/// What a closed form of some operations without cancellation may lose: eight roundings of x. For
/// |ν| ≤ 0.95, beyond which 1 − ν² cancels.
double rounded(double x);

/// The same with x itself.
Estimate closed_form(double x);

/// The same of what depends on the cylinders' relative curvature, where 1/R₁ + 1/R₂ cancels if one
/// body lies in a hollow of the other.
double rounded(const ContactCase& c, double x);

/// a/b − 1, in per cent: how far the computed number a is off the printed one.
Estimate percent_off(Estimate a, const PrintedNumber& b);

/// √(magnitude² − component²), the other component of a displacement of which two printed numbers
/// are known, as far as their last places leave it open.
Estimate other_component(const PrintedNumber& magnitude, const PrintedNumber& component);

/// A printed number: half a unit of its last place.
Estimate as_estimate(const PrintedNumber& number);

/// u_z by eq. (3) and its derivative, with the accuracy that elasticity/triangular_load.hpp states.
Estimate displacement(const HalfSpaceCase& c, double x);
Estimate gradient(const HalfSpaceCase& c, double x);

/// How wrong the nodal pressures may be as the solution of the discrete equations, over their peak:
/// four times what the method's residual stands for, and rounding that the residual does not see.
double pressure_error(const line_contact::Solution& solution);

/// The same of Solution::half_width(), relative. With δ the error of the pressures over their peak,
/// ∫px² of Hertz's pressure moves by (16/3π)δ of itself at most and ∫p by (4/π)δ, and the root of
/// their ratio by half of both.
double half_width_error(const line_contact::Solution& solution);

/// How wrong the place of an edge of contact may be as that of the discrete solution: p² is
/// extrapolated from the last nodes, whose pressures are wrong by δp₀ each. A length, at most one
/// spacing.
double edge_error(const line_contact::Solution& solution);

/// How wrong the results of a point contact may be, relatively, when its nodal pressures are wrong
/// by δ of the peak. Of the radius, half of what the second moment, 15/8 δ, and the load, 3/2 δ,
/// may be wrong by; of the approach 4/π δ.
double bound_of_radius(double of_pressure);
double bound_of_approach(double of_pressure);

}  // namespace paper
