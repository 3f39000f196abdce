# SPDX-License-Identifier: GPL-3.0-or-later
# The figures of the report: the slope by your eqs. (3) and (2) and their difference, and the pressure between the cylinders. 1e-20
# is added because the axis is logarithmic.
set terminal pdfcairo size 14cm,9cm font "Latin Modern Roman,11"
set output "generated/slope.pdf"
set multiplot layout 2,1
set xlabel "x/a"
set ylabel "slope"
plot "generated/surface.dat" using 1:2 with lines title "eq. (3)", \
     "" every 8 using 1:3 with points title "eq. (2)"
set ylabel "difference"
set logscale y
plot "generated/surface.dat" using 1:(abs($2-$3)+1e-20) with points pt 7 ps 0.2 title "eq. (2) − eq. (3)", \
     "" using 1:($4+1e-20) with lines title "reported error"
unset multiplot

unset logscale
set terminal pdfcairo size 14cm,7cm font "Latin Modern Roman,11"
set output "generated/pressure.pdf"
set xlabel "x in mm"
set ylabel "pressure in MPa"
plot "generated/contact.dat" using ($1*1e3):($2/1e6) with linespoints notitle
