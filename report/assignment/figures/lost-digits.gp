# SPDX-License-Identifier: GPL-3.0-or-later
# The relative error of the slope by eq. (3) when its three terms are added directly.
set terminal cairolatex pdf size 13.5cm,4.8cm
set output 'lost-digits.tex'
three_terms(x) = (x + 1)*log(x + 1) + (x - 1)*log(x - 1) - 2*x*log(x)
# log(1 - t) without loss of digits for small t (Kahan).
log_1_minus(t) = 1 - t == 1 ? -t : log(1 - t)*t/(1 - (1 - t))
exact(x) = x*log_1_minus(1/x**2) + 2*atanh(1/x)
error(x) = abs(three_terms(x)/exact(x) - 1)
unset key
set border 3 lw 0.8
set tics nomirror out scale 0.6
set logscale xy
set format '$10^{%T}$'
set xrange [1:1e8]
set yrange [1e-16:10]
set ytics 1e-16,1e4
set xlabel '$x/a$'
set ylabel 'relative error'
set samples 320
plot '+' using (x = 10**(0.2 + 7.8*$0/319)):(error(x) > 1e-16 ? error(x) : 1e-16) with points pt 7 ps 0.25 lc rgb '#1b1b3a'
