# SPDX-License-Identifier: GPL-3.0-or-later
# Contacts of four profiles under one load, over p₀ and against x/a of the cylinders, x ≥ 0: elements as
# circles, the closed form solid, the cylinders dash-dotted.
set xrange [0:1.1]
set xtics 0.25
set yrange [0:1.75]
set ytics 0.5
set multiplot layout 2,2 margins 0.075,0.985,0.12,0.97 spacing 0.05,0.06
do for [k = 1:4] {
  is_left = k % 2 == 1
  is_low = k > 2
  exact = value(sprintf('exact_%d', k))
  nodes = value(sprintf('nodes_%d', k))
  set format y (is_left ? '$%g$' : '')
  set ylabel (is_left ? '$p/p_0$' : '') offset 1
  set format x (is_low ? '$%g$' : '')
  set xlabel (is_low ? '$x/a$' : '')
  set label 1 value(sprintf('title_%d', k)) at graph 0.05,0.1 left
  if (k == 1) { set key at graph 1,0.98 right top } else { unset key }
  plot exact using "x":"hertz" with lines ls 4 title 'cylinders', \
       exact using "x":"pressure" with lines ls 1 title 'closed form', \
       nodes using "x":"pressure" with points ls 11 title 'elements'
}
unset multiplot
