# SPDX-License-Identifier: GPL-3.0-or-later
# The pressure between two cylinders, over p₀ and against x/a of Hertz: above it, and below its
# difference from Hertz at the nodes.
stats nodes using (abs(column("difference"))) nooutput
largest = STATS_max
factor = factor_of(largest)
set xrange [-1.2:1.2]
set xtics 0.4
set multiplot

set lmargin at screen 0.17
set rmargin at screen 0.98
set tmargin at screen 0.97
set bmargin at screen 0.49
set format x ''
set yrange [0:1.05]
set ytics 0.25
set ylabel '$p/p_0$'
set key at graph 0.5,0.35 center
plot hertz using "x":"pressure" with lines ls 1 title 'Hertz', \
     nodes using "x":"pressure" with points ls 11 title 'triangular elements'

set tmargin at screen 0.43
set bmargin at screen 0.19
set format x '$%g$'
set xlabel '$x/a$'
set yrange [*:*]
set ytics tick_step(largest * factor)
set mytics 1
set ylabel '$\Delta p/p_0$' . (factor == 1 ? '' : sprintf(' (%s)', unit_of(largest, '')))
unset key
plot nodes using "x":(factor * column("difference")) with impulses ls 1 lw 1.2, \
     nodes using "x":(factor * column("difference")) with points ls 11
unset multiplot
