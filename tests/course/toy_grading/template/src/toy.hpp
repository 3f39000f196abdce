// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

/// x times x.
double square(double x);

/// The sum of all numbers; zero of none.
double sum(const std::vector<double>& numbers);
