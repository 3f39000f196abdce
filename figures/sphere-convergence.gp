# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of four elements between two spheres against the number of elements over the radius: of the
# pressure at the nodes inside, with a line of slope −2, and of the surface's slope between the nodes,
# with lines of slope −1 and −2. Each element has a mark and a colour, and the fill of one is no other's.
set multiplot
set logscale xy
set format y '$10^{%T}$'
set xlabel 'elements over the radius, $a/c$'
set tmargin at screen 0.96
set bmargin at screen 0.20
set xrange [15:60]
set xtics (15, 20, 30, 40, 60)
unset key

set lmargin at screen 0.10
set rmargin at screen 0.44
set yrange [3e-6:2e-3]
set ylabel 'error of $p/p_0$'
set label 1 'order 2' at 30,4.2e-4 left
plot 0.22*x**-2 with lines ls 1 lw 0.7 notitle, \
     point using "elements":"inside" with linespoints lc rgb plum lw 1 dt (1,4) pt 1 ps 0.7 title 'forces', \
     uniform using "elements":"inside" with linespoints lc rgb rust lw 1 dt (1,4) pt 6 ps 0.7 title 'uniform', \
     bilinear using "elements":"inside" with linespoints lc rgb blue lw 1 dt (1,4) pt 4 ps 0.8 title 'bilinear', \
     pyramid using "elements":"inside" with linespoints lc rgb ink lw 1 dt (1,4) pt 9 ps 0.8 title 'pyramids'

set lmargin at screen 0.58
set rmargin at screen 0.86
set yrange [1e-5:3]
set ylabel 'error of slope, over $a/R$'
set label 1 'order 2' at 26,9e-4 left
set label 2 'order 1' at 26,2.4e-2 left
set label 3 'forces' at screen 0.875,0.874 left
set label 4 'uniform' at screen 0.875,0.547 left
set label 5 'bilinear' at screen 0.875,0.335 left
set label 6 'pyramids' at screen 0.875,0.255 left
plot 0.2*x**-1 with lines ls 1 lw 0.7 notitle, 0.19*x**-2 with lines ls 1 lw 0.7 notitle, \
     point using "elements":"slope" with linespoints lc rgb plum lw 1 dt (1,4) pt 1 ps 0.7 title 'forces', \
     uniform using "elements":"slope" with linespoints lc rgb rust lw 1 dt (1,4) pt 6 ps 0.7 title 'uniform', \
     bilinear using "elements":"slope" with linespoints lc rgb blue lw 1 dt (1,4) pt 4 ps 0.8 title 'bilinear', \
     pyramid using "elements":"slope" with linespoints lc rgb ink lw 1 dt (1,4) pt 9 ps 0.8 title 'pyramids'
unset multiplot
