# SPDX-License-Identifier: GPL-3.0-or-later
# What the same load does to the surface as a force, a uniform pressure and a triangle, against x/c and
# all dimensionless: displacements on the left, gradients on the right.
# outside: a force has no finite displacement
stats displacement using (column("x")) nooutput
set multiplot layout 1,2 margins 0.10,0.985,0.21,0.90 spacing 0.14
set xrange [STATS_min:STATS_max]
set xtics 1
set xlabel '$x/c$'

set yrange [-1.2:4.2]
set ylabel 'displacement' offset 1
unset key
plot displacement using "x":"point" with lines ls 3 title 'force', \
     displacement using "x":"uniform" with lines ls 2 title 'uniform', \
     displacement using "x":"triangular" with lines ls 1 title 'triangle'

set ylabel 'gradient' offset 0
set ytics 2
set yrange [-4.5:4.5]
set key top right samplen 1.5
plot gradient using "x":"point" with lines ls 3 title 'force', \
     gradient using "x":"uniform" with lines ls 2 title 'uniform', \
     gradient using "x":"triangular" with lines ls 1 title 'triangle'
unset multiplot
