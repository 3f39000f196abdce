// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace point_contact {

/// A count that is never negative, as the standard library and FFTW take it.
inline std::size_t size_of(Eigen::Index n) {
  return static_cast<std::size_t>(n);
}

}  // namespace point_contact
