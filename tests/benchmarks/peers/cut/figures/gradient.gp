# SPDX-License-Identifier: GPL-3.0-or-later
set xlabel 'x (in)'
set ylabel 'gradient ($10^{-6}$)'
set arrow from -half_width, graph 0 to -half_width, graph 1 nohead dt 2
set arrow from half_width, graph 0 to half_width, graph 1 nohead dt 2
plot line using "x":(1e6 * column("slope")) with lines lw 2 lc rgb red notitle
