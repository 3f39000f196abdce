// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/pressure_convergence.hpp"

#include "figures/style.hpp"

namespace figures {

void draw_pressure_convergence(literate::Plot& plot, const PressureConvergence& data) {
  const auto even =
      plot.data("even", {data.elements, data.triangular_inside, data.triangular_largest,
                         data.uniform_inside, data.uniform_largest});
  const auto graded = plot.data("graded", {data.graded_elements, data.graded_largest});
  apply_style(plot);
  plot << "set logscale xy\nset format y '$10^{%T}$'\n"
       << "set xrange [8:1000]\nset xtics (10, 20, 50, 100, 200, 500, 1000)\n"
       << "set yrange [5e-8:0.5]\nset ytics 1e-7,10\n"
       << "set xlabel 'elements over the half-width, $a/c$'\nset ylabel 'error of $p/p_0$'\n"
       << "set rmargin at screen 0.66\nset lmargin at screen 0.12\n"
       << "set key at screen 0.99,0.92 top right reverse Left samplen 1.2 spacing 1.5\n"
       << "set label '$-\\tfrac12$' at 560,0.026\nset label '$-2$' at 430,1.4e-5\n"
       << "plot " << even << " using 1:3 with points ls 13 title 'largest, triangles', \\\n"
       << "  " << even << " using 1:5 with points ls 11 title 'largest, uniform', \\\n"
       << "  " << even << " using 1:2 with points ls 13 pt 1 title 'inside, triangles', \\\n"
       << "  " << even << " using 1:4 with points ls 12 title 'inside, uniform', \\\n"
       << "  " << graded << " using 1:2 with linespoints ls 1 pt 7 ps 0.6 lw 1.2 "
       << "title 'largest, graded grid', \\\n"
       << "  0.4*x**-0.5 with lines ls 4 lw 1 notitle, 1.2*x**-2 with lines ls 4 lw 1 notitle\n";
}

}  // namespace figures
