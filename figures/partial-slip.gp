# SPDX-License-Identifier: GPL-3.0-or-later
# The shear traction under three tangential loads, q over μp₀ against x/a: lines for the closed form, points for the
# elements, each labelled with its load in the middle; above them the traction of bodies that slide.
set xrange [-1.05:1.05]
set xtics 0.5
set yrange [0:1.12]
set ytics 0,0.25
set xlabel '$x/a$'
set ylabel '$q/(\mu p_0)$'
unset key
load_of(k) = sprintf('$Q = %g\,\mu P$', value(sprintf('share_%d', k)))

# The closed form is lowest in the middle: 1 less the half-width of the strip that sticks.
do for [k = 1:3] {
  set label k load_of(k) at 0,(1 - value(sprintf('stick_%d', k)) + 0.1) center
}
set label 4 'sliding' at 0,1.06 center
plot sliding using "x":"shear" with lines ls 1 lw 0.7 title 'sliding', \
     curve_1 using "x":"shear" with lines ls 1 title load_of(1), \
     nodes_1 using "x":"shear" every 2 with points ls 1 lw 1.4 pt 6 ps 0.65, \
     curve_2 using "x":"shear" with lines ls 2 title load_of(2), \
     nodes_2 using "x":"shear" every 2 with points ls 2 lw 1.4 dt solid pt 4 ps 0.75, \
     curve_3 using "x":"shear" with lines ls 3 title load_of(3), \
     nodes_3 using "x":"shear" every 2 with points ls 3 lw 1.4 dt solid pt 2 ps 0.5
