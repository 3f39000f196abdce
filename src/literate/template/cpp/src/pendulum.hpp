#pragma once

#include "numerics/estimate.hpp"

/// Returns the period of a pendulum with amplitude `angle` (radians, below π) over that of small
/// swings: T/T₀ = (2/π) ∫₀^{π/2} dφ/√(1 − sin²(angle/2) sin²φ). Its error bound is the difference
/// from half as many points plus rounding.
numerics::Estimate relative_period(double angle);

/// Returns the first two terms of its series in the angle: 1 + angle²/16.
double short_series(double angle);
