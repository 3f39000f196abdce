# The common style, which gnuplot reads before each script. Readers who confuse red and green can tell the colours apart
# (M. Okabe and K. Ito, Color universal design, 2008), and the dashes differ in black and white.
set linetype 1 lc rgb '#000000' lw 2 dt solid pt 7
set linetype 2 lc rgb '#d55e00' lw 2 dt (9,5) pt 5
set linetype 3 lc rgb '#0072b2' lw 2 dt (2,3) pt 9
set linetype 4 lc rgb '#56b4e9' lw 2 dt (9,3,2,3) pt 13
set linetype 5 lc rgb '#e6b800' lw 2 dt (18,5) pt 11
set linetype cycle 5
