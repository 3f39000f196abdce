# SPDX-License-Identifier: GPL-3.0-or-later
# Fig. 2 of the paper: one triangle p_j/p₀ per node over x/c, with the nodes c apart, and their sum,
# which is linear between the nodes.
eval schematic
stats nodes using (column("x")) nooutput
first = STATS_min
last = STATS_max
set xrange [first - 0.6:last + 1.2]
set yrange [-0.24:1.3]
set lmargin 1
set rmargin 1
set arrow from first - 0.5,0 to last + 0.9,0 as 2
set label '$x$' at last + 1.0,0
set arrow from 0,0 to 0,1.22 as 2
set label '$p$' at -0.15,1.22 right

# The paper's labels: p₀ in the middle, p_j and c at a node on the right.
set label '$O$' at 0,-0.08 center
set label '$p_0$' at 0.18,1.06 left
set label '$p_j$' at x_j + 0.12,p_j + 0.07
set arrow from x_j,-0.1 to x_j + 1,-0.1 as 1
set label '$c$' at x_j + 0.5,-0.18 center
plot triangles using "x":"height" with filledcurves y=0 fs transparent solid 0.25 lc rgb blue, \
     triangles using "x":"height" with lines lc rgb blue lw 1.2 dt (5,3), \
     nodes using "x":"pressure" with lines ls 1, \
     nodes using "x":"pressure" with points pt 7 ps 0.4 lc rgb ink
