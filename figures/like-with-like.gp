# SPDX-License-Identifier: GPL-3.0-or-later
# u_z of the half-space, of the block under the stated and the fitted load, and as printed.
stats curves using (column("x")) nooutput
x_unit = unit_of(STATS_max, unit)
x_factor = factor_of(STATS_max)
end = x_factor * STATS_max
stats curves using (abs(column("half_space"))) nooutput
u_unit = unit_of(STATS_max, unit)
u_factor = factor_of(STATS_max)

set xlabel sprintf('$x$ (%s)', x_unit)
set ylabel sprintf('$u_z$ (%s)', u_unit)
set xrange [0:end]
set yrange [0:*]
set ytics tick_step(u_factor * STATS_max)
set key outside right center reverse Left
x_of(x) = x_factor * x
u_of(u) = u_factor * u
plot curves using (x_of(column("x"))):(u_of(column("half_space"))) with lines ls 1 \
       title 'half-space, triangle', \
     curves using (x_of(column("x"))):(u_of(column("block_stated"))) with lines ls 4 \
       title 'block, triangle', \
     curves using (x_of(column("x"))):(u_of(column("block_fitted"))) with lines ls 2 \
       title 'block, fitted load', \
     printed using (x_of(column("x"))):(u_of(column("u_z"))) with points ls 11 \
       title 'printed, FEA $z$', \
     printed using (x_of(column("x"))):(u_of(column("magnitude"))) with points ls 12 \
       title 'printed, FEA magnitude', \
     printed using (x_of(column("x"))):(u_of(column("analytical"))) with points ls 13 \
       title 'printed, analytical'
