# SPDX-License-Identifier: GPL-3.0-or-later
# The right half of the mesh, since the left is its mirror image, and what of it lies about the load.
# outside: the right half, and a close-up beside it
set size ratio -1
unset grid
unset key
set clip two
set xlabel sprintf('$x$ (%s)', unit)
set ylabel sprintf('$-z$ (%s)', unit)
set xtics tick_step(right)
set ytics tick_step(right)
set multiplot

set lmargin at screen 0.18
set rmargin at screen 0.50
set xrange [0:right]
plot lines using "x":"y" with lines lc rgb ink lw 0.25

set lmargin at screen 0.70
set rmargin at screen 0.97
set ylabel ''
set xrange [-5 * half_width:5 * half_width]
set yrange [-10 * half_width:0]
set xtics 5 * half_width
set ytics 5 * half_width
plot lines using "x":"y" with lines lc rgb ink lw 0.3
unset multiplot
