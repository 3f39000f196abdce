#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""program.py SOURCE_DIR OUTPUT: writes the C++ program of the manual's examples."""

import pathlib
import sys

from manual import Manual, filled

source, output = map(pathlib.Path, sys.argv[1:])
manual = Manual((source / "src/literate/README.md").read_text())
text, _ = filled((source / "tests/literate/manual/program.cpp.in").read_text(), manual, "//")
output.write_text(text)
