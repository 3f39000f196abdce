# SPDX-License-Identifier: GPL-3.0-or-later
# ∂u_z/∂x under three loads of equal resultant, in units of K/a. Only the triangle gives a finite
# slope.
# outside: a force has no finite gradient
set xlabel '$x/a$'
set ylabel '$(\partial u_z/\partial x)\,/\,(K/a)$'
set xrange [-3:3]
set yrange [-3.2:3.2]
set xtics 1
set ytics 1
unset key
set label 'concentrated' at -0.2,2.6 left
set label 'uniform' at -1.15,2.6 right
set label 'triangular' at 0.05,1.3 left
plot loads using "x":"concentrated" with lines ls 3, \
     loads using "x":"uniform" with lines ls 2, \
     loads using "x":"triangular" with lines ls 1
