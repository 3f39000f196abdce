// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace point_contact {

/// A self-affine roughness: waves of random phases whose heights fall with the wave number.
struct Roughness {
  double rms;          ///< root mean square height, a length > 0
  int n_waves;         ///< of the shortest wave along a side, from 1 to max_waves
  double hurst;        ///< H, from 0 to 1: heights go with the wave number to the power −1−H
  std::uint64_t seed;  ///< another seed makes other phases
};

inline constexpr int max_waves = 64;

/// Heights on n × n points, n ≥ 2, that fill a square to its sides, opposite ones being the same:
///
///   h(x, y) = A Σ q^{−1−H} cos(2π(kx + ly) + φ_kl),  1 ≤ q² = k² + l² ≤ n_waves²,
///
/// x and y from 0 to 1, with one of (k, l) and (−k, −l), and A so that the mean square over the
/// square is rms². The phases are those of std::mt19937_64, which is the same everywhere. Throws
/// InvalidQuantity for values outside the ranges above.
Eigen::ArrayXXd rough_heights(const Roughness& roughness, Eigen::Index n);

}  // namespace point_contact
