# SPDX-License-Identifier: GPL-3.0-or-later
# The largest relative misfit of the printed displacements over the edge fraction of the load, with the
# best peak for each: a curve for each kind of sides.
set logscale y
set format y '$10^{%T}$'
set xrange [0:1]
set xlabel 'edge fraction of the load'
set ylabel 'largest misfit'
set key bottom left
plot sides using "edge_fraction":"free" with lines ls 3 title 'free sides', \
     sides using "edge_fraction":"roller" with lines ls 2 title 'roller', \
     sides using "edge_fraction":"clamped" with lines ls 1 title 'clamped'
