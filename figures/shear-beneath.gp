# SPDX-License-Identifier: GPL-3.0-or-later
# The greatest shear in the plane beneath two contacts, τ₁/p₀, with lengths over the half-width a:
# contours with their numbers and a cross at the greatest value, and the profile along the axis.

# Contours become curves of their own, which a plane plot draws. gnuplot writes them with blanks between
# the columns, so that for data with commas a line of them is one column of words.
along(line) = real(word(line, 1))
down(line) = real(word(line, 2))
unset surface
set contour base
eval 'set cntrparam levels discrete ' . still_levels
set table $still_contours
splot still using "x":"z":"tau" with lines
unset table
eval 'set cntrparam levels discrete ' . sliding_levels
set table $sliding_contours
splot sliding using "x":"z":"tau" with lines
unset table

# A panel has its heading and the name of its axis at the edges of the drawing. The backslashes of a
# label that stands in data are read twice.
number(value) = sprintf('\\fboxsep=1pt\\colorbox{white}{\\scriptsize %.2f}', value)
set multiplot
set tmargin at screen 0.90
set bmargin at screen 0.23
set xtics -1,1,1
set yrange [2.5:0]
set ytics 0.5
set ylabel '$z/a$' offset 0.2,0
set xrange [-2:2]
set border 15
unset key
unset grid

set lmargin at screen 0.09
set rmargin at screen 0.405
set label 1 sprintf('$\mu = %g$', still_friction) at screen 0.2475,0.95 center
set label 2 '$x/a$' at screen 0.2475,0.035 center
plot $still_contours using (along(strcol(1))):(down(strcol(1))) with lines ls 1 lw 1.4, \
     still_labels using "x":"z":(number(column("tau"))) with labels center, \
     still_greatest using "x":"z" with points ls 13 ps 0.7

set lmargin at screen 0.445
set rmargin at screen 0.76
set label 1 sprintf('$\mu = %g$', sliding_friction) at screen 0.6025,0.95 center
set label 2 '$x/a$' at screen 0.6025,0.035 center
set format y ''
set ylabel ''
plot $sliding_contours using (along(strcol(1))):(down(strcol(1))) with lines ls 1 lw 1.4, \
     sliding_labels using "x":"z":(number(column("tau"))) with labels center, \
     sliding_greatest using "x":"z" with points ls 13 ps 0.7

set lmargin at screen 0.80
set rmargin at screen 0.985
set label 1 '$x = 0$, $\mu = 0$' at screen 0.8925,0.95 center
set label 2 '$\tau_1/p_0$' at screen 0.8925,0.035 center
set border 3
set grid
set xrange [0:0.35]
set xtics 0.1
plot closed using "tau":"z" with lines ls 1, \
     nodes using "tau":"z" with points ls 11
unset multiplot
