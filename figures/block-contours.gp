# SPDX-License-Identifier: GPL-3.0-or-later
# Fig. 3 of the paper: u_z on the deformed block in ten bands, whole and about the load. Each cell of
# the samples is a closed polygon with the mean u_z of its corners.
factor = factor_of(largest)
set cbrange [0:factor * largest]
set size ratio -1
set xtics tick_step(right)
set ytics tick_step(height)
unset grid
unset key
set style fill solid 1 border
set multiplot

set lmargin at screen 0.11
set rmargin at screen 0.50
unset colorbox
set xlabel sprintf('$x$ (%s)', unit)
set ylabel sprintf('$-z$ (%s)', unit)
plot whole using "x":"y":(factor * column("u_z")) with filledcurves closed lc palette lw 0.3

set colorbox
set cbtics tick_step(factor * largest)
set cblabel sprintf('$u_z$ (%s)', unit_of(largest, unit)) offset 1.6,0
set xtics 4 * half_width
set ytics (0, -2 * half_width, -4 * half_width)
set xlabel sprintf('$x$ (%s)', unit)
set xrange [-4.6 * half_width:4.6 * half_width]
set yrange [-5 * half_width:0.5 * half_width]
set lmargin at screen 0.67
set rmargin at screen 0.88
set ylabel sprintf('$-z$ (%s)', unit)
plot close_up using "x":"y":(factor * column("u_z")) with filledcurves closed lc palette lw 0.3
unset multiplot
