#pragma once

#include <vector>

/// The square root of x > 0.
double root(double x);

/// The arithmetic mean of at least one number.
double mean(const std::vector<double>& numbers);
