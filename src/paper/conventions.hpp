// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "literate/claims/criterion.hpp"

namespace paper {

/// What one would not see in a plot: a hundredth of what it shows.
inline literate::Limit less_than_a_plot_shows() {
  return {literate::LimitKind::convention, 1e-2, "less than a plot shows"};
}

/// What the paper calls nearly identical, or negligible, of curves that its Fig. 4 compares.
inline literate::Limit nearly_identical() {
  return {literate::LimitKind::convention, 3e-2, "the height of two marks in the paper's Fig. 4"};
}

}  // namespace paper
