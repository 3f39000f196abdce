# SPDX-License-Identifier: GPL-3.0-or-later
# What the same load does to the surface as a force, a uniform pressure and a triangle, against x/c and
# all dimensionless: displacements on the left, gradients on the right.
stats displacement using (column("x")) nooutput
set multiplot layout 1,2 margins 0.08,0.985,0.17,0.90 spacing 0.10
set xrange [STATS_min:STATS_max]
set xtics 1
set xlabel '$x/c$'

set title 'displacement' offset 0,-0.6
set yrange [-1.2:3.2]
set key top right
plot displacement using "x":"point" with lines ls 3 title 'force', \
     displacement using "x":"uniform" with lines ls 2 title 'uniform', \
     displacement using "x":"triangular" with lines ls 1 title 'triangle'

set title 'gradient' offset 0,-0.6
set yrange [-4.5:4.5]
unset key
plot gradient using "x":"point" with lines ls 3, \
     gradient using "x":"uniform" with lines ls 2, \
     gradient using "x":"triangular" with lines ls 1
unset multiplot
