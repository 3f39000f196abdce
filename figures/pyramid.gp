# SPDX-License-Identifier: GPL-3.0-or-later
# The pyramid over a lattice of equilateral triangles with one of its neighbours, drawn from above, and
# what it does to the surface beside a uniform square and a force of the same load, against d/c.
# outside: a force has no finite displacement
across(x, y) = 0.94 * x + 0.34 * y
up(x, y, z) = 0.42 * y - 0.16 * x + 0.9 * z

set multiplot
set lmargin at screen 0.0
set rmargin at screen 0.44
set tmargin at screen 0.98
set bmargin at screen 0.02
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
set lmargin at screen 0.54
set rmargin at screen 0.985
set tmargin at screen 0.96
set bmargin at screen 0.27
set border 3
set xtics 0.5 nomirror out scale 0.6
set ytics 1 nomirror out scale 0.6
set grid
set xrange [0:2.5]
set yrange [0:4.2]
set xlabel '$d/c$'
set ylabel '$S$'
set key top right
plot displacement using "d":"force" with lines ls 3 title 'force', \
     displacement using "d":"uniform" with lines ls 2 title 'uniform', \
     displacement using "d":"pyramid" with lines ls 1 title 'pyramid'
unset multiplot
