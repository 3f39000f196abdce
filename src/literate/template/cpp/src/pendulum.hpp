#pragma once

#include "numerics/estimate.hpp"

/// The period of a pendulum that swings to `angle` (radians, below π), over that of small swings:
/// T/T₀ = (2/π) ∫₀^{π/2} dφ/√(1 − sin²(angle/2) sin²φ). Its error bound is the difference from half
/// as many points, and rounding.
numerics::Estimate relative_period(double angle);

/// The first two terms of its series in the angle: 1 + angle²/16.
double short_series(double angle);
