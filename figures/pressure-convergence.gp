# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of the pressure over p₀ against the number of elements over the half-width: a band between the least and the
# greatest error on neighbouring uniform grids, and the graded grid; lines of slope −½ and −2.
set logscale xy
set format y '$10^{%T}$'
set xrange [8:1000]
set xtics (10, 20, 50, 100, 200, 500, 1000)
set yrange [1e-8:0.5]
set ytics 1e-7,10
set xlabel 'elements over the half-width'
set ylabel 'error of $p/p_0$'
set style fill solid 0.45 noborder
set lmargin at screen 0.13
set rmargin at screen 0.62
set key at screen 0.99,0.9 top right reverse Left samplen 1.2 spacing 1.5
set label 'order $\tfrac12$' at 90,0.12
set label 'order 2' at 300,8e-5
plot largest using "elements":"least":"greatest" with filledcurves fs solid 0.18 noborder lc rgb rust title 'uniform grid, largest', \
     for [bound in "least greatest"] largest using "elements":bound with lines lw 1 lc rgb rust notitle, \
     inside using "elements":"least":"greatest" with filledcurves lc rgb blue title 'uniform grid, rms inside', \
     graded using "elements":"largest" with linespoints ls 1 pt 7 ps 0.6 lw 1.2 title 'graded grid, largest', \
     0.4*x**-0.5 with lines ls 4 lw 1 notitle, 1.2*x**-2 with lines ls 4 lw 1 notitle
