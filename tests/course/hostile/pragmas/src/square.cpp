// SPDX-License-Identifier: GPL-3.0-or-later
#pragma GCC pch_preprocess "/etc/passwd"
#pragma GCC dependency "/etc/shadow"
#include <toy.hpp>
double square(double) {
  return 0;
}
