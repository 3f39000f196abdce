# SPDX-License-Identifier: GPL-3.0-or-later
set xlabel 'x (in)'
set key left top
set ylabel 'displacement ($10^{-6}$\,in)'
plot line using "x":(1e6 * column("u")) with lines lw 2 lc rgb blue title 'eq. (3)', \
     integrals using "x":(1e6 * column("u")) with points pt 6 title 'eq. (2) by quadrature'
