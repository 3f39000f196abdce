#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""colours_test.py SOURCE_DIR: readers without red or green cones tell the curves of a new paper, and of this report, apart by their colours."""

import itertools
import pathlib
import re
import sys

from claims import claim, finish

# What is left of linear red, green and blue (G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, A physiologically-based
# model for simulation of color vision deficiency, IEEE TVCG 15, 2009, severity 1.0).
SIGHTS = {
    "all cones": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "no red cones": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
    "no green cones": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
}


def times(matrix, vector):
    return [sum(a * b for a, b in zip(row, vector)) for row in matrix]


def lab(linear):
    """CIE L*a*b* of linear sRGB under D65 (IEC 61966-2-1, CIE 15)."""
    to_xyz = ((0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505))
    white = (0.9505, 1.0, 1.089)
    x, y, z = (t ** (1 / 3) if t > 0.008856 else 7.787 * t + 16 / 116
               for t in (max(c, 0) / w for c, w in zip(times(to_xyz, linear), white)))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def linear_of(colour):
    parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    return [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]


# Ten times the difference that is just noticed beside one another (CIE 1976), since curves lie apart.
FAR = 23


def tell_apart(figures, pattern, n):
    colours = re.findall(pattern, (pathlib.Path(sys.argv[1]) / figures / "style.gp").read_text(), re.M)
    claim(f"{n} curves of {figures} have a colour each", len(set(colours)) == len(colours) == n)
    for sight, matrix in SIGHTS.items():
        seen = [lab(times(matrix, linear_of(colour))) for colour in colours]
        for (one, a), (other, b) in itertools.combinations(zip(colours, seen), 2):
            distance = sum((p - q) ** 2 for p, q in zip(a, b)) ** 0.5
            claim(f"{one} and {other} of {figures} differ with {sight}, {distance:.0f}", distance >= FAR)


tell_apart("src/literate/template/figures", r"^set linetype \d lc rgb '(#[0-9a-f]{6})'", 5)
tell_apart("figures", r"^(?:ink|rust|blue|grey) = '(#[0-9a-f]{6})'", 4)
finish()
