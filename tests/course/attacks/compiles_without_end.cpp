// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: a template that never finishes compiling
#include "assignment.hpp"
template <unsigned N, unsigned M>
struct Bomb {
  static constexpr unsigned value = Bomb<N - 1, 2 * M>::value ^ Bomb<N - 1, 2 * M + 1>::value;
};
template <unsigned M>
struct Bomb<0, M> {
  static constexpr unsigned value = M;
};
double square(double) {
  return Bomb<28, 1>::value;
}
