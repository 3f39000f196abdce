# SPDX-License-Identifier: GPL-3.0-or-later
# How far a quadrature is from the closed form, and how far it says it may be, against x/a.
stats gradient using (column("x")) nooutput
set logscale xy
set format '$10^{%T}$'
set xrange [STATS_min:STATS_max]
set yrange [1e-20:1e-9]
set ytics 1e-18,100
set xtics 1e-4,100
set xlabel '$x/a$' offset 0,0.4
set key top left reverse Left
set multiplot layout 1,2 margins 0.10,0.985,0.25,0.90 spacing 0.13

set title 'gradient, in units of $K/a$' offset 0,-0.6
plot gradient using "x":"estimate" with lines ls 2 title 'reported error', \
     gradient using "x":"difference" with points ls 13 title '$|$difference$|$'

set title 'displacement, in units of $K$' offset 0,-0.6
set format y '$10^{%T}$'
unset key
plot displacement using "x":"estimate" with lines ls 2, \
     displacement using "x":"difference" with points ls 13
unset multiplot
