# SPDX-License-Identifier: GPL-3.0-or-later
# The pressures of Contact.m from its printed state to its mended one, one panel per state. Shaded:
# the pressure of Hertz under the correct load; dashed: Hertz from the program's own lines. A
# pressure that leaves the frame is labelled with its greatest value.
# outside: a curve that leaves the frame is labelled with its greatest value
top = 2.5
across = 3
n = int(n_panels)
panel(i) = value(sprintf('panel_%d', i))
array largest[n]
do for [i = 1:n] {
  stats panel(i) using (column("pressure")) nooutput
  largest[i] = STATS_max
}

set multiplot layout (n + across - 1) / across,across \
  margins 0.095,0.99,0.21,0.95 spacing 0.03,0.2
set xrange [-1.5:1.5]
set xtics 1
set yrange [0:top]
set ytics 0.5
unset key
do for [i = 1:n] {
  is_left = i % across == 1
  is_bottom = i + across > n
  own_half_width = value(sprintf('half_width_%d', i))
  own_p0 = value(sprintf('p0_%d', i))
  set title value(sprintf('title_%d', i)) offset 0,-0.7
  set format y (is_left ? '$%g$' : '')
  set xlabel (is_bottom ? '$x/a$' : '')
  set ylabel (is_left ? '$p/p_0$' : '')
  unset label
  if (i == 1) { set label 1 'Hertz, $2P$' at -1.42,0.66 * top; set label 2 'Hertz, $P$' at -0.97,0.12 * top front }
  if (largest[i] > top) { set label sprintf('peak $%.2f$', largest[i]) at 0.42,0.93 * top }
  plot hertz using "x":"pressure" with filledcurves y1=0 fc rgb shade, \
       hertz using (column("x") * own_half_width):(column("pressure") * own_p0) with lines ls 2, \
       panel(i) using "x":"pressure" with lines ls 1 lw 1.6, \
       panel(i) using "x":"pressure" with points ls 13 pt 7 ps 0.18
}
unset multiplot
