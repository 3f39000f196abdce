# SPDX-License-Identifier: GPL-3.0-or-later
# Fig. 4 of the paper: u_z by eq. (3), with the columns of Fig. 5 if the case has them.
stats curve using (column("x")) nooutput
x_unit = unit_of(STATS_max, unit)
x_factor = factor_of(STATS_max)
end = x_factor * STATS_max
stats curve using (abs(column("u_z"))) nooutput
u_unit = unit_of(STATS_max, unit)
u_factor = factor_of(STATS_max)
edge = x_factor * half_width

set xlabel sprintf('$x$ (%s)', x_unit)
set ylabel sprintf('$u_z$ (%s)', u_unit)
set xrange [0:end]
set yrange [0:*]
set key bottom left reverse Left
set arrow from edge,graph 0 to edge,graph 1 as 3
set label '$x = a$' at edge,graph 0.95 offset 0.6,0

x_of(x) = x_factor * x
u_of(u) = u_factor * u
if (!exists('printed')) {
  plot curve using (x_of(column("x"))):(u_of(column("u_z"))) with lines ls 1 title 'eq.~(3)'
} else {
  plot curve using (x_of(column("x"))):(u_of(column("u_z"))) with lines ls 1 title 'eq.~(3)', \
       printed using (x_of(column("x"))):(u_of(column("analytical"))) with points ls 13 \
         title 'printed, analytical', \
       printed using (x_of(column("x"))):(u_of(column("fea_magnitude"))) with points ls 12 \
         title 'printed, FEA magnitude', \
       printed using (x_of(column("x"))):(u_of(column("fea_z"))) with points ls 11 \
         title 'printed, FEA $z$'
}
