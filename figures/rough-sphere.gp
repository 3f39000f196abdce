# SPDX-License-Identifier: GPL-3.0-or-later
# The pressure between a smooth and a rough sphere over p₀ of smooth ones: as a map, with the edge of
# Hertz's contact, and along the middle row of nodes. Lengths over a.
stats row using (column("pressure")) nooutput
set multiplot
set tmargin at screen 0.96
set bmargin at screen 0.27
set lmargin at screen 0.09
set rmargin at screen 0.38
set xrange [-half_side:half_side]
set yrange [-half_side:half_side]
set size ratio -1
set xtics 1
set ytics 1
set xlabel '$x/a$'
set ylabel '$y/a$'
set cbrange [0:*]
set cbtics 1
set cblabel '$p/p_0$' offset 2,0
unset grid
unset key
set parametric
set trange [0:2*pi]
plot map using "x":"y":"pressure" with image, cos(t), sin(t) with lines ls 2 lw 1.2
unset parametric

set size noratio
set grid
set lmargin at screen 0.60
set rmargin at screen 0.84
set yrange [0:1.05 * STATS_max]
set ytics 1
set ylabel '$p/p_0$' offset -0.5,0
set key at screen 0.99,0.92 top right reverse Left samplen 1.6
plot smooth using "x":"pressure" with lines ls 2 lw 1.4 title 'smooth', \
     row using "x":"pressure" with lines ls 1 lw 1.4 title 'rough'
unset multiplot
