# SPDX-License-Identifier: GPL-3.0-or-later
# Left: a pyramid on the square lattice with one of its neighbours, in perspective. Middle: p/p₀
# between two spheres over x/a of Hertz, along the middle row of nodes. Right: its difference from
# Hertz at the nodes in contact, over r/a.
across(x, y) = 0.94 * x + 0.34 * y
up(x, y, z) = 0.42 * y - 0.16 * x + 0.9 * z

set multiplot
set lmargin at screen 0.0
set rmargin at screen 0.27
set tmargin at screen 0.98
set bmargin at screen 0.10
set border 0
unset tics
unset grid
unset key
set size ratio -1
set label 1 '$p$' at across(0, 0) - 0.06,up(0, 0, 1) + 0.17 center
plot base using (across(column("x"), column("y"))):(up(column("x"), column("y"), column("z"))) \
       with lines lc rgb grey lw 0.8, \
     neighbour using (across(column("x"), column("y"))):(up(column("x"), column("y"), column("z"))) \
       with lines ls 2 lw 1.3, \
     pyramid using (across(column("x"), column("y"))):(up(column("x"), column("y"), column("z"))) \
       with lines ls 1
unset label 1
set size noratio

set border 3
set grid
set tmargin at screen 0.96
set bmargin at screen 0.23
set lmargin at screen 0.36
set rmargin at screen 0.63
set xrange [-shown:shown]
set xtics 0.6 nomirror out scale 0.6
set xlabel '$x/a$'
set yrange [0:1.05]
set ytics 0.25 nomirror out scale 0.6
set ylabel '$p/p_0$' offset 1,0
set label 1 'Hertz (line),' at 0,0.35 center
set label 2 'pyramids (circles)' at 0,0.2 center
plot hertz using "x":"pressure" with lines ls 1 title 'Hertz', \
     row using "x":"pressure" every 2 with points ls 11 title 'pyramids' # outside: only every second one is legible
unset label 1
unset label 2

set lmargin at screen 0.77
set rmargin at screen 0.985
set xrange [0:shown]
set xtics 0.4
set xlabel '$r/a$'
set logscale y
set yrange [1e-6:0.1]
set ytics 1e-6,10
set format y '$10^{%T}$'
set ylabel '$|\Delta p|/p_0$' offset -1.2,0
plot nodes using "r":"difference" with points ls 11 pt 7 ps 0.12 notitle
unset multiplot
