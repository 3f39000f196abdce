// SPDX-License-Identifier: GPL-3.0-or-later
#include "../provided/answers.hpp"
double square(double) {
  return 0;
}
