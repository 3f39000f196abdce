# SPDX-License-Identifier: GPL-3.0-or-later
# The pressure between two bodies along a line of the surface, elements as circles and the closed form
# solid where there is one; with friction its shear.
set xlabel sprintf('%s (%s)', axis, length_unit)
set ylabel sprintf('stress (%s)', stress_unit)
set yrange [*:*]
set key outside top center horizontal
if (exists('closed') && exists('shear')) {
  plot closed using "x":"pressure" with lines ls 1 title 'pressure, closed form', \
       nodes using "x":"pressure" with points ls 11 title 'pressure, elements', \
       shear using "x":"shear" with lines ls 3 title 'shear'
} else { if (exists('closed')) {
  plot closed using "x":"pressure" with lines ls 1 title 'pressure, closed form', \
       nodes using "x":"pressure" with points ls 11 title 'pressure, elements'
} else { if (exists('shear')) {
  plot nodes using "x":"pressure" with linespoints ls 11 title 'pressure, elements', \
       shear using "x":"shear" with lines ls 3 title 'shear'
} else {
  plot nodes using "x":"pressure" with linespoints ls 11 title 'pressure, elements'
} } }
