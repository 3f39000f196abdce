# SPDX-License-Identifier: GPL-3.0-or-later
# The pressure between two spheres over p₀ against x/a of Hertz, along the middle row of nodes; and how
# far it is from Hertz at all nodes, against r/a.
set multiplot
set tmargin at screen 0.96
set bmargin at screen 0.22

set lmargin at screen 0.09
set rmargin at screen 0.46
set xrange [-shown:shown]
set xtics 0.6
set xlabel '$x/a$'
set yrange [0:1.05]
set ytics 0.25
set ylabel '$p/p_0$' offset 1,0
set key at graph 0.5,0.35 center
plot hertz using "x":"pressure" with lines ls 1 title 'Hertz', \
     row using "x":"pressure" every 2 with points ls 11 title 'pyramids'

set lmargin at screen 0.65
set rmargin at screen 0.98
set xrange [0:shown]
set xtics 0.4
set xlabel '$r/a$'
set logscale y
set yrange [1e-6:0.1]
set ytics 1e-6,10
set format y '$10^{%T}$'
set ylabel '$|\Delta p|/p_0$' offset -1.6,0
unset key
plot nodes using "r":"difference" with points ls 11 pt 7 ps 0.12
unset multiplot
