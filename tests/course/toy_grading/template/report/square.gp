# SPDX-License-Identifier: GPL-3.0-or-later
set terminal pdfcairo size 6cm,4cm
set output "generated/square.pdf"
plot "generated/square.dat" with lines notitle
