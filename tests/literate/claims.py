# SPDX-License-Identifier: GPL-3.0-or-later
"""What a test of the engine in Python finds: claim() tells on standard error what is not so, finish() ends the test."""

import sys

failed = []


def claim(text, holds, said=""):
    if not holds:
        failed.append(text)
        print(f"not so: {text}", *([said] if said else []), sep="\n", file=sys.stderr)


def finish():
    sys.exit(1 if failed else 0)
