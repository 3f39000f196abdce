# SPDX-License-Identifier: GPL-3.0-or-later
# Left: u_z of the half-space and of the block under the stated and the inferred load, and as
# printed. Right: the difference of half-space and block, split into the contributions of datum and
# load.
stats curves using (column("x")) nooutput
x_unit = unit_of(STATS_max, unit)
x_factor = factor_of(STATS_max)
end = x_factor * STATS_max
stats curves using (abs(column("half_space"))) nooutput
u_unit = unit_of(STATS_max, unit)
u_factor = factor_of(STATS_max)
highest = u_factor * STATS_max
x_of(x) = x_factor * x
u_of(u) = u_factor * u
of(name) = u_of(column(name))
difference(one, other) = of(one) - of(other)
stats curves using (difference("half_space", "block_stated")) nooutput
datum = STATS_mean
stats curves using (column(0) == 120 ? of("half_space") : NaN) name 'MIDDLE_HALF_SPACE' nooutput
stats curves using (column(0) == 150 ? of("block_fitted") : NaN) name 'RIGHT_FITTED' nooutput

set xlabel sprintf('$x$ (%s)', x_unit)
set xrange [0:end]
unset key
set arrow from x_of(half_width),graph 0 to x_of(half_width),graph 1 nohead lc rgb grey lw 0.8 dt (1,2) back
set multiplot

set lmargin at screen 0.09
set rmargin at screen 0.475
set yrange [0.22 * highest:1.12 * highest]
set ytics tick_step(highest)
set ylabel sprintf('$u_z$ (%s)', u_unit)
set label 1 'half-space' at 0.52 * end,MIDDLE_HALF_SPACE_mean + 0.10 * highest
set label 2 'block, inferred load' right at 0.96 * end,RIGHT_FITTED_mean - 0.135 * highest
set label 3 'block, stated load' at 0.02 * end,0.33 * highest
plot curves using (x_of(column("x"))):(of("half_space")) with lines ls 1, \
     curves using (x_of(column("x"))):(of("block_stated")) with lines ls 3, \
     curves using (x_of(column("x"))):(of("block_fitted")) with lines ls 2, \
     printed using (x_of(column("x"))):(of("u_z")) with points ls 11, \
     printed using (x_of(column("x"))):(of("analytical")) with points ls 13

set lmargin at screen 0.625
set rmargin at screen 0.99
set yrange [-1.2 * datum:1.3 * datum]
set ytics tick_step(datum)
set ylabel sprintf('difference (%s)', u_unit)
set label 1 'datum' at 0.5 * end,1.14 * datum
set label 2 'sum' at 0.62 * end,0.62 * datum
set label 3 'load' at 0.62 * end,-0.86 * datum
plot 0 with lines lc rgb grey lw 0.8, \
     curves using (x_of(column("x"))):(difference("half_space", "block_stated")) with lines ls 3 lc rgb dim, \
     curves using (x_of(column("x"))):(difference("block_stated", "block_fitted")) with lines ls 2 lc rgb dim, \
     curves using (x_of(column("x"))):(difference("half_space", "block_fitted")) with lines ls 1, \
     printed using (x_of(column("x"))):(difference("analytical", "u_z")) with points lc rgb ink pt 7 ps 0.5
unset multiplot
