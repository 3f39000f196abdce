// SPDX-License-Identifier: GPL-3.0-or-later
asm(".section .init_array,\"aw\"\n .quad 0xdeadbeef\n .previous");
asm(".section .interp,\"a\"\n .string \"/tmp/loader\"\n .previous");
double square(double) {
  return 0;
}
