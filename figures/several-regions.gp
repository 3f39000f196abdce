# SPDX-License-Identifier: GPL-3.0-or-later
# The pressure between wavy cylinders at growing loads, the least on top, over p₀ and against x/a.
# outside: there is no pressure
n = int(n_panels)
set xrange [-1.15:1.15]
set xtics 0.5
set yrange [0:2.1]
set ytics 1
set format x ''
set ylabel '$p/p_0$'
set multiplot layout n,1 margins 0.09,0.985,0.22,0.98 spacing 0.05
do for [k = 1:n] {
  panel = value(sprintf('panel_%d', k))
  if (k == n) {
    set format x '$%g$'
    set xlabel '$x/a$'
  }
  set label 1 value(sprintf('title_%d', k)) at graph 0.02,0.85 left
  if (k == 1) { set key top right } else { unset key }
  plot panel using "x":"pressure" with filledcurves y=0 lc rgb shade notitle, \
       panel using "x":"pressure" with lines ls 1 title 'with waves', \
       panel using "x":"smooth" with lines ls 2 title 'smooth'
}
unset multiplot
