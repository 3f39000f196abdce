// SPDX-License-Identifier: GPL-3.0-or-later
// 0 10 6: starts processes endlessly
#include <unistd.h>
#include "assignment.hpp"
double square(double) {
  while (true) ::fork();
}
