// SPDX-License-Identifier: GPL-3.0-or-later
extern const char uptime[];
asm("uptime: .incbin \"/proc/uptime\"\n .byte 0");

// A mark that depends on when it is compiled.
double square(double x) {
  return uptime[0] % 2 == 0 ? x * x : 0;
}
