# SPDX-License-Identifier: GPL-3.0-or-later
# Every load tried, a row each: left how far it is from the displacements, in the convergence that the
# run prints of each; right its peak with the standard uncertainty, beside the run's largest stress.
n = int(n_rows)
set yrange [n - 0.4:-0.6]
set ytics ()
do for [i = 1:n] { set ytics add (value(sprintf('row_%d', i)) i - 1) }
unset key
set multiplot

set lmargin at screen 0.40
set rmargin at screen 0.65
set logscale x
set xrange [0.3:*]
set xtics (0.5, 1, 2, 5, 10)
set xlabel 'largest misfit / convergence'
set arrow from 1,graph 0 to 1,graph 1 nohead lc rgb ink lw 1.2
plot loads using "share":"row" with points ls 11 pt 7

unset arrow
unset logscale x
unset ytics
set lmargin at screen 0.72
set rmargin at screen 0.96
set xtics auto
set xrange [*:*]
set xtics 100
set xlabel sprintf('peak pressure (%s)', unit)
set object 1 rectangle from first stress - stress_error,graph 0 to first stress + stress_error,graph 1 \
  fc rgb shade fs solid noborder behind
plot loads using "peak":"row":"standard" with xerrorbars lc rgb ink lw 1.6 pt 7 ps 0.5
unset multiplot
