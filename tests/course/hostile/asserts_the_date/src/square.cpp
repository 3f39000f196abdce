// SPDX-License-Identifier: GPL-3.0-or-later
static_assert(__DATE__[10] == '0', __FILE__);
double square(double) {
  return nothing;
}
