// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "numerics/estimate.hpp"

/// The share of a sample that is left after `time`, both times in seconds.
numerics::Estimate share_left(double time, double half_life);

/// The mean life by the trapezoidal rule over `n_intervals`, with its error; in half-lives.
numerics::Estimate mean_life(int n_intervals);
