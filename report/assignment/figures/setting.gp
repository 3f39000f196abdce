# SPDX-License-Identifier: GPL-3.0-or-later
# The triangle of eq. (4) on the left, and overlapping triangles with their sum on the right.
set terminal cairolatex pdf size 15.5cm,3.5cm
set output 'setting.tex'
ink = '#1b1b3a'
blue = '#2a84a6'
set style arrow 1 heads filled size graph 0.012,18 lc rgb ink lw 1
set style arrow 2 head filled size graph 0.012,18 lc rgb ink lw 1
unset key
unset border
unset tics
set tmargin 0
set bmargin 0
set yrange [-0.45:1.25]
$triangle << end
-1 0
 0 1
 1 0
end
# The pressure at each node, which is the peak of a triangle.
$nodes << end
-3 0
-2 0.62
-1 0.9
 0 1
 1 0.9
 2 0.62
 3 0
end
set multiplot layout 1,2

set xrange [-2:4.4]
set arrow from -1.9,0 to 4.2,0 as 2
set label '$x$' at 4.25,-0.14
set arrow from 0,0 to 0,-0.42 as 2
set label '$z,\,u_z$' at 0.12,-0.36
set label '$p_0$' at 0.12,1.1
set label '$-a$' at -1,-0.14 center
set label '$a$' at 1,-0.14 center
set label '$d$' at 3.4,-0.14 center
set label 'datum: $u_z=0$' at 3.4,0.2 center
set arrow from 3.4,-0.05 to 3.4,0.05 nohead lw 1.5
plot $triangle with filledcurves y=0 fs solid 0.25 lc rgb blue, $triangle with lines lc rgb ink lw 2

unset label
unset arrow
set xrange [-3.6:3.9]
set arrow from -3.5,0 to 3.7,0 as 2
set label '$x$' at 3.75,-0.14
set arrow from 1,-0.12 to 2,-0.12 as 1
set label '$c$' at 1.5,-0.27 center
set label '$p_j$' at 1.12,1.02
plot $nodes using ($1 - 1):(0):(1):2 with vectors nohead lc rgb blue lw 1.2 dt (5,3), \
     $nodes using 1:2:(1):(-$2) with vectors nohead lc rgb blue lw 1.2 dt (5,3), \
     $nodes with lines lc rgb ink lw 2, \
     $nodes with points pt 7 ps 0.4 lc rgb ink
unset multiplot
