# SPDX-License-Identifier: GPL-3.0-or-later
# The common style of all figures, read before each script. All colours are defined here.

# From dark to light, so that they remain distinct in grey and for colour-blind readers.
ink = '#1b1b3a'
rust = '#c1440e'
blue = '#2a84a6'
plum = '#8e4585'
dim = '#6e6e6e'
grey = '#9a9a9a'
shade = '#dcdcdc'
set palette maxcolors 10 defined (0 '#f7f4e9', 0.5 '#5fa8a8', 1 '#1b1b3a')

# Lines: solid, dashed, dotted, dash-dotted. Points: circles, squares, crosses.
set style line 1 lc rgb ink lw 2.2 dt solid
set style line 2 lc rgb rust lw 2.2 dt (9,5)
set style line 3 lc rgb blue lw 2.6 dt (2,3)
set style line 4 lc rgb grey lw 1.8 dt (9,3,2,3)
set style line 11 lc rgb rust lw 1.8 pt 6 ps 0.65
set style line 12 lc rgb blue lw 1.8 pt 4 ps 0.85
set style line 13 lc rgb ink lw 1.6 pt 2 ps 0.5

# Arrows of schematic figures: a length, an axis, a level.
set style arrow 1 heads filled size graph 0.012,18 lc rgb ink lw 1
set style arrow 2 head filled size graph 0.012,18 lc rgb ink lw 1
set style arrow 3 nohead lc rgb grey lw 0.8 dt (4,3)

# Axes only on the left and below, with tics outside, and a faint grid.
set border 3 lw 0.8
set tics nomirror out scale 0.6
set grid lw 0.4 lc rgb '#dddddd' dt solid
set key spacing 1.25 samplen 2.6 width -2

# A schematic figure has neither axes nor tics: `eval schematic`.
schematic = "unset border; unset tics; unset grid; unset key; \
  set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0"

# An axis whose numbers reach `largest` is scaled by a power of ten: by 1 from 0.01 to 1000, else by
# an exponent that is a multiple of three. Multiply data by factor_of; unit_of is the resulting
# unit, such as $10^{-6}$\,in.
exponent_of(largest) = largest == 0 || (largest >= 0.01 && largest < 1000) ? 0 \
  : 3 * int(floor(log10(largest) / 3))
factor_of(largest) = 10.0**(-exponent_of(largest))
unit_of(largest, unit) = exponent_of(largest) == 0 ? unit \
  : sprintf("$10^{%d}$\\,%s", exponent_of(largest), unit)

# The tick spacing, 1, 2 or 5 times a power of ten, that puts two to four ticks on an axis from 0 to
# `largest`.
decade_of(largest) = 10.0**floor(log10(largest))
tick_step(largest) = largest == 0 ? 1 \
  : largest < 2 * decade_of(largest) ? decade_of(largest) / 2 \
  : largest < 5 * decade_of(largest) ? decade_of(largest) : 2 * decade_of(largest)
