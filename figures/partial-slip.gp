# SPDX-License-Identifier: GPL-3.0-or-later
# The shear traction under three tangential loads, q over μp₀ against x/a: lines for the closed form,
# points for the elements, bars below, with the loads, for the strips that stick. Dash-dotted: the bodies slide.
set xrange [-1.1:1.1]
set xtics 0.5
set yrange [-0.56:1.05]
set ytics 0,0.25
set xlabel '$x/a$'
set ylabel '$q/(\mu p_0)$'
set key outside right center reverse Left

do for [k = 1:3] {
  stick = value(sprintf('stick_%d', k))
  level = 0.02 - 0.16 * k
  set arrow from -stick,level to stick,level nohead ls k lw 4 dt solid
  set label sprintf('\scriptsize $%g\,\mu P$', value(sprintf('share_%d', k))) at -1.08,level left
}

load_of(k) = sprintf('$Q = %g\,\mu P$', value(sprintf('share_%d', k)))
plot sliding using "x":"shear" with lines ls 4 title 'sliding', \
     curve_1 using "x":"shear" with lines ls 1 notitle, \
     nodes_1 using "x":"shear" every 2 with points ls 1 lw 1.4 pt 6 ps 0.65 notitle, \
     keyentry with linespoints ls 1 pt 6 ps 0.65 title load_of(1), \
     curve_2 using "x":"shear" with lines ls 2 notitle, \
     nodes_2 using "x":"shear" every 2 with points ls 2 lw 1.4 dt solid pt 4 ps 0.75 notitle, \
     keyentry with linespoints ls 2 pt 4 ps 0.75 title load_of(2), \
     curve_3 using "x":"shear" with lines ls 3 notitle, \
     nodes_3 using "x":"shear" every 2 with points ls 3 lw 1.4 dt solid pt 2 ps 0.5 notitle, \
     keyentry with linespoints ls 3 pt 2 ps 0.5 title load_of(3)
