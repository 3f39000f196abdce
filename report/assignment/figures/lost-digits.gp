# SPDX-License-Identifier: GPL-3.0-or-later
# How many digits of the slope are wrong when eq. (3)'s three terms are added as they stand.
unset key
set logscale xy
set format '$10^{%T}$'
set xrange [1:1e8]
set yrange [1e-16:10]
set ytics 1e-16,1e4
set xlabel '$x/a$'
set ylabel 'relative error'
plot slope using "distance":"error" with points pt 7 ps 0.25 lc rgb ink
