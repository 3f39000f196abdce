# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of four elements between two spheres against the number of elements over the radius: of the
# pressure at the nodes inside, with a line of slope −2, and of the surface's slope between the nodes,
# with lines of slope −1 and −2.
set multiplot
set logscale xy
set format y '$10^{%T}$'
set xlabel 'elements over the radius, $a/c$'
set tmargin at screen 0.96
set bmargin at screen 0.20

set lmargin at screen 0.11
set rmargin at screen 0.39
set xrange [9:75]
set xtics (10, 20, 50)
set yrange [1e-6:6e-2]
set ylabel 'error of $p/p_0$'
set label 1 '2' at 55,2e-4
unset key
plot 0.24*x**-2 with lines ls 4 lw 1, \
     point using "elements":"inside" with points ls 13 pt 1 ps 0.65, \
     uniform using "elements":"inside" with points ls 11, \
     bilinear using "elements":"inside" with points ls 12, \
     pyramid using "elements":"inside" with points ls 13

set lmargin at screen 0.54
set rmargin at screen 0.82
set xrange [9:40]
set xtics (10, 20, 30)
set yrange [3e-5:2]
set ylabel 'error of slope, over $a/R$'
set label 1 '2' at 30,3.5e-4
set label 2 '1' at 30,1.2e-2
set key at screen 0.995,0.9 top right reverse Left samplen 1
plot 0.2*x**-1 with lines ls 4 lw 1 notitle, 0.18*x**-2 with lines ls 4 lw 1 notitle, \
     point_surface using "elements":"slope" with points ls 13 pt 1 ps 0.65 title 'forces', \
     uniform_surface using "elements":"slope" with points ls 11 title 'uniform', \
     bilinear_surface using "elements":"slope" with points ls 12 title 'bilinear', \
     pyramid_surface using "elements":"slope" with points ls 13 title 'pyramids'
unset multiplot
