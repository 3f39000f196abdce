# SPDX-License-Identifier: GPL-3.0-or-later
# Contacts of four profiles under one load, over p₀ and against x/a of the cylinders, x ≥ 0: elements as
# circles, the closed form solid, the cylinders dotted.
# outside: a closed form is infinite at its corner
set xrange [0:1.1]
set yrange [0:2.1]
set ytics 0.5
unset key
set multiplot layout 1,4 margins 0.09,0.99,0.25,0.97 spacing 0.02,0.06
do for [k = 1:4] {
  is_left = k == 1
  exact = value(sprintf('exact_%d', k))
  nodes = value(sprintf('nodes_%d', k))
  set format y (is_left ? '$%g$' : '')
  set ylabel (is_left ? '$p/p_0$' : '')
  set xlabel '$x/a$'
  # a 0 would touch the 1 of the panel before
  least_tic = is_left ? 0 : 0.5
  set xtics least_tic,0.5
  set label 1 value(sprintf('title_%d', k)) at graph 0.5,0.94 center
  plot exact using "x":"hertz" with lines ls 3 title 'cylinders', \
       exact using "x":"pressure" with lines ls 1 title 'closed form', \
       nodes using "x":"pressure" with points ls 11 title 'elements'
}
unset multiplot
