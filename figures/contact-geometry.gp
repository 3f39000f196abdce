# SPDX-License-Identifier: GPL-3.0-or-later
# Fig. 1 of the paper: the surfaces of two bodies, body 1 below, pressed together by δ: as they would
# overlap undeformed, and deformed. Heights are positive upwards, x is over the half-width.
eval schematic
stats after using (column("x")) nooutput
end = STATS_max
set xrange [-end - 0.75:end + 0.75]
set yrange [-1.15 * height:1.15 * height]

# The axes and the bodies.
set arrow from -end - 0.2,0 to end + 0.4,0 as 2
set label '$x$' at end + 0.5,0
set arrow from 0,0 to 0,-height as 2
set label '$z$' at 0.08,-height
set label '$O$' at 0.08,-0.07 * height
set label 'body 1' at -end + 0.3,-0.85 * height
set label 'body 2' at -end + 0.3,0.85 * height

# The levels of the two apexes, had they passed through each other, and δ between them.
set arrow from -0.4,apex to x_of_h2 + 0.2,apex as 3
set arrow from -0.4,-apex to x_of_h2 + 0.2,-apex as 3
set arrow from -0.3,-apex to -0.3,apex as 1 front
set label '$\delta$' at -0.38,apex / 2 right front

# Displacements and gaps.
set arrow from x_of_u,before_at_u to x_of_u,0 as 1 front
set label '$u_{z1}$' at x_of_u + 0.08,before_at_u / 2 front
set arrow from x_of_u,0 to x_of_u,-before_at_u as 1 front
set label '$u_{z2}$' at x_of_u + 0.08,-before_at_u / 2 front
set arrow from x_of_h1,apex to x_of_h1,before_at_h1 as 1 front
set label '$h_1$' at x_of_h1,apex + 0.12 * height center front
set arrow from x_of_h2,-apex to x_of_h2,-before_at_h2 as 1 front
set label '$h_2$' at x_of_h2 + 0.06,0.2 * height front

plot after using "x":"body1":(-1.15 * height) with filledcurves fs transparent solid 0.12 lc rgb ink, \
     after using "x":"body2":(1.15 * height) with filledcurves fs transparent solid 0.12 lc rgb blue, \
     before using "x":"body1" with lines ls 4, \
     before using "x":"body2" with lines ls 4, \
     after using "x":"body1" with lines ls 1, \
     after using "x":"body2" with lines ls 1
