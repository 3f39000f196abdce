// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: a template that never finishes compiling
#include "assignment.hpp"
template <int N, int M>
struct Bomb {
  static constexpr int value = Bomb<N - 1, 2 * M>::value + Bomb<N - 1, 2 * M + 1>::value;
};
template <int M>
struct Bomb<0, M> {
  static constexpr int value = M;
};
double square(double) {
  return Bomb<28, 1>::value;
}
