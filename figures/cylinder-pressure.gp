# SPDX-License-Identifier: GPL-3.0-or-later
# p/p₀ between two cylinders over x/a of Hertz; below, the magnitude of its difference from Hertz at
# the nodes.
set xrange [-1.2:1.2]
set xtics 0.4
set multiplot

set lmargin at screen 0.17
set rmargin at screen 0.98
set tmargin at screen 0.98
set bmargin at screen 0.54
set format x ''
set yrange [0:1.05]
set ytics 0.25
set ylabel '$p/p_0$'
set key at graph 0.5,0.35 center
plot hertz using "x":"pressure" with lines ls 1 title 'Hertz', \
     nodes using "x":"pressure" with points ls 11 title 'triangular elements'

set tmargin at screen 0.49
set bmargin at screen 0.26
set format x '$%g$'
set xlabel '$x/a$'
set logscale y
set yrange [*:*]
set ytics autofreq 100
set format y '$10^{%T}$'
set ylabel '$|\Delta p|/p_0$'
unset key
plot differences using "x":"difference" with points ls 11
unset multiplot
