# SPDX-License-Identifier: GPL-3.0-or-later
# A displacement of the surface: the closed form, or else the quadrature, as a line, and the points
# that were asked for.
set xlabel sprintf('x (%s)', unit)
set ylabel sprintf('%s (%s)', component, unit)
set format y '%.3g'
set key top right
plot curve using "x":"u" with lines ls 1 title line, \
     points using "x":"u" with points ls 11 title 'quadrature at the points'
