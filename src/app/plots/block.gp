# SPDX-License-Identifier: GPL-3.0-or-later
# The displacement of the loaded side of the block.
set xlabel sprintf('x (%s)', unit)
set ylabel sprintf('u_z (%s)', unit)
set format y '%.3g'
set key top right
plot surface using "x":"u_z" with lines ls 1 title 'u_z of the loaded side'
