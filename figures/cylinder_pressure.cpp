// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/cylinder_pressure.hpp"

#include "figures/style.hpp"

namespace figures {

void draw_cylinder_pressure(literate::Plot& plot, const CylinderPressure& data) {
  const auto nodes = plot.data("nodes", {data.x, data.pressure, data.difference});
  const auto hertz = plot.data("hertz", {data.hertz_x, data.hertz});
  const double largest = largest_magnitude(data.difference);
  const AxisScale scale = axis_scale(largest, "");
  apply_style(plot);
  plot << "set xrange [-1.2:1.2]\nset xtics 0.4\n"
       << "set multiplot\n"
       << "set lmargin at screen 0.17\nset rmargin at screen 0.98\n"
       << "set tmargin at screen 0.97\nset bmargin at screen 0.46\n"
       << "set format x ''\nset yrange [0:1.05]\nset ytics 0.25\nset ylabel '$p/p_0$'\n"
       << "set key at graph 0.5,0.35 center\n"
       << "plot " << hertz << " with lines ls 1 title 'Hertz', \\\n"
       << "  " << nodes << " using 1:2 with points ls 11 title 'triangular elements'\n"
       << "set tmargin at screen 0.40\nset bmargin at screen 0.13\n"
       << "set format x '$%g$'\nset xlabel '$x/a$'\nset yrange [*:*]\nset ytics "
       << tick_step(largest * scale.factor) << "\nset mytics 1\n"
       << "set ylabel '$\\Delta p/p_0$" << (scale.factor == 1 ? "" : " (")
       << (scale.factor == 1 ? "" : scale.unit) << (scale.factor == 1 ? "" : ")") << "'\n"
       << "unset key\n"
       << "plot " << nodes << " using 1:($3*" << scale.factor << ") with impulses ls 1 lw 1.2, \\\n"
       << "  " << nodes << " using 1:($3*" << scale.factor << ") with points ls 11\n"
       << "unset multiplot\n";
}

}  // namespace figures
