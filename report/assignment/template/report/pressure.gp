# SPDX-License-Identifier: GPL-3.0-or-later
# The pressure between the cylinders.
set terminal pdfcairo size 14cm,7cm font "Latin Modern Roman,11"
set output "generated/pressure.pdf"
set xlabel "x in mm"
set ylabel "pressure in MPa"
plot "generated/contact.dat" using ($1*1e3):($2/1e6) with linespoints notitle
