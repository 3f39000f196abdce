// SPDX-License-Identifier: GPL-3.0-or-later
// A compiler's message shows the line that it does not understand, and this one is never the same.
#include "/proc/uptime"
double square(double) {
  return 0;
}
