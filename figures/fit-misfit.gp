# SPDX-License-Identifier: GPL-3.0-or-later
# The largest relative misfit of the printed displacements over the exponent m of the fall, with the best peak and
# edge pressure for each; dashed what the run's own convergence allows.
set logscale xy
set format y '%g'
set xrange [0.3:4]
set xtics (0.3, 0.5, 1, 2, 4)
set xlabel 'exponent $m$ of the fall'
set ylabel 'largest misfit, \%'
set yrange [0.05:*]
set ytics (0.05, 0.1, 0.2, 0.5, 1)
unset key
plot fits using "exponent":(100 * column("misfit")) with lines ls 1, 100 * allowed with lines ls 4
