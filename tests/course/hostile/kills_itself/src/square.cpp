// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>

// The signal that ends what takes too long.
double square(double) {
  return std::raise(SIGKILL);
}
