# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of the pressure over p₀ against the number of elements over the half-width: a band between the least and the
# greatest error at each spacing of uniform grids, and the graded grid; lines of slope −½ and −2.
set logscale xy
set format y '$10^{%T}$'
set xrange [10:500]
set xtics (10, 20, 50, 100, 200, 500)
set yrange [1e-8:3]
set ytics 1e-8,100
set xlabel 'elements over the half-width, $a/c$'
set ylabel 'error of $p/p_0$'
set lmargin at screen 0.11
set rmargin at screen 0.98
unset key
set label 'order $\tfrac12$' at 20,0.5 left
set label 'order 2' at 290,1.4e-4 left
set label 'uniform grids, largest' at 480,0.2 right
set label 'uniform grids, inside (rms)' at 12,1e-6 left
set label 'graded grid, largest' at 11,6e-5 left
plot largest using "elements":"least":"greatest" with filledcurves fs solid 0.18 noborder lc rgb rust title 'uniform grid, largest', \
     for [bound in "least greatest"] largest using "elements":bound with lines lw 1 lc rgb rust notitle, \
     inside using "elements":"least":"greatest" with filledcurves fs solid 0.45 noborder lc rgb blue title 'uniform grid, rms inside', \
     graded using "elements":"largest" with linespoints ls 1 pt 7 ps 0.6 lw 1.2 title 'graded grid, largest', \
     0.5*x**-0.5 with lines ls 1 lw 0.7 notitle, 2.5*x**-2 with lines ls 1 lw 0.7 notitle
