# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of the pressure over p₀ against the number of elements over the half-width: a point a grid,
# and lines of slope −½ and −2.
set logscale xy
set format y '$10^{%T}$'
set xrange [8:1000]
set xtics (10, 20, 50, 100, 200, 500, 1000)
set yrange [5e-8:0.5]
set ytics 1e-7,10
set xlabel 'elements over the half-width, $a/c$'
set ylabel 'error of $p/p_0$'
set rmargin at screen 0.66
set lmargin at screen 0.12
set key at screen 0.99,0.92 top right reverse Left samplen 1.2 spacing 1.5
set label '$-\tfrac12$' at 560,0.026
set label '$-2$' at 430,1.4e-5
plot even using "elements":"triangular_largest" with points ls 13 title 'largest, triangles', \
     even using "elements":"uniform_largest" with points ls 11 title 'largest, uniform', \
     even using "elements":"triangular_inside" with points ls 13 pt 1 title 'inside, triangles', \
     even using "elements":"uniform_inside" with points ls 12 title 'inside, uniform', \
     graded using "elements":"largest" with linespoints ls 1 pt 7 ps 0.6 lw 1.2 \
       title 'largest, graded grid', \
     0.4*x**-0.5 with lines ls 4 lw 1 notitle, 1.2*x**-2 with lines ls 4 lw 1 notitle
