# SPDX-License-Identifier: GPL-3.0-or-later
# The pressure of a point contact: over the surface, and along both axes with the closed form where
# there is one. In a terminal the axes alone.
set xlabel sprintf('x, y (%s)', unit)
set ylabel sprintf('pressure (%s)', stress_unit)
set key outside top center horizontal
if (exists('in_terminal')) {
  in_panels = 0
} else {
  in_panels = 1
  set multiplot
  set tmargin at screen 0.88
  set bmargin at screen 0.15
  set lmargin at screen 0.09
  set rmargin at screen 0.38
  set size ratio -1
  set xtics 2 * tick_step(half_x)
  set ytics tick_step(half_y)
  unset grid
  unset key
  set xlabel sprintf('x (%s)', unit)
  set ylabel sprintf('y (%s)', unit)
  set cblabel sprintf('pressure (%s)', stress_unit) offset 1
  set xrange [-half_x:half_x]
  set yrange [-half_y:half_y]
  plot surface using "x":"y":"pressure" with image notitle
  set lmargin at screen 0.63
  set rmargin at screen 0.97
  set size noratio
  set grid
  set ytics autofreq
  set key at screen 0.8,0.99 top center horizontal maxcols 2
  set xrange [*:*]
  set yrange [*:*]
  set xlabel sprintf('x, y (%s)', unit)
  set ylabel sprintf('pressure (%s)', stress_unit)
}
if (exists('closed_x')) {
  plot closed_x using "s":"pressure" with lines ls 1 title 'closed form, x', \
       closed_y using "s":"pressure" with lines ls 2 title 'closed form, y', \
       along_x using "s":"pressure" with points ls 13 notitle, \
       along_y using "s":"pressure" with points ls 11 title 'elements'
} else {
  plot along_x using "s":"pressure" with lines ls 1 title 'along x', \
       along_y using "s":"pressure" with lines ls 2 title 'along y'
}
if (in_panels) { unset multiplot }
