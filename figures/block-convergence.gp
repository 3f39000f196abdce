# SPDX-License-Identifier: GPL-3.0-or-later
# How much of measures of the block refinement still changes, by the elements' order.
set logscale y
set format y '$10^{%T}$'
set xtics 1
set ytics 100
set xlabel 'order of the elements'
set ylabel 'relative change'
set key above center maxrows 3 samplen 2 spacing 1.05
plot orders using "order":"von_mises" with linespoints ls 3 pt 4 title 'largest von Mises stress', \
     orders using "order":"displacement" with linespoints ls 1 pt 2 title '$u_z$ under the load', \
     orders using "order":"energy" with linespoints ls 2 pt 6 title 'strain energy'
