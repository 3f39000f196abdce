// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: a forgotten main()
#include "assignment.hpp"
double square(double x) {
  return x * x;
}
int main() {
  return 0;
}
