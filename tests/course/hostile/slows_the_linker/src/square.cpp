// SPDX-License-Identifier: GPL-3.0-or-later
// The linker holds each of these against all of the others that end alike.
asm(".altmacro\n.macro part n\n.section .gnu.linkonce.x\\n\\().same,\"a\"\n.byte 0\n.endm\n"
    ".set i, 0\n.rept 60000\npart %i\n.set i, i + 1\n.endr\n.previous");
double square(double) {
  return 0;
}
