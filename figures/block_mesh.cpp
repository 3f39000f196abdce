// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/block_mesh.hpp"

#include <limits>

#include "figures/style.hpp"

namespace figures {

void draw_block_mesh(literate::Plot& plot, const BlockMesh& data) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> x, y;
  const auto line = [&](double x0, double y0, double x1, double y1) {
    x.insert(x.end(), {x0, x1, nan});
    y.insert(y.end(), {y0, y1, nan});
  };
  for (const double at : data.x_lines) line(at, 0 - data.z_lines.front(), at, -data.z_lines.back());
  for (const double at : data.z_lines)
    line(data.x_lines.front(), 0 - at, data.x_lines.back(), 0 - at);
  const auto lines = plot.data("lines", {x, y});
  const double a = data.half_width;
  apply_style(plot);
  plot << "set size ratio -1\nunset grid\nunset key\nset clip two\n"
       << "set xlabel '$x$ (" << data.unit << ")'\nset ylabel '$-z$ (" << data.unit << ")'\n"
       << "set multiplot\n"
       << "set lmargin at screen 0.10\nset rmargin at screen 0.52\n"
       << "plot " << lines << " with lines lc rgb '#1b1b3a' lw 0.35\n"
       << "set lmargin at screen 0.64\nset rmargin at screen 0.97\nset ylabel ''\n"
       << "set xrange [" << -5 * a << ":" << 5 * a << "]\nset yrange [" << -10 * a << ":0]\n"
       << "set xtics " << 5 * a << "\nset ytics " << 5 * a << "\n"
       << "plot " << lines << " with lines lc rgb '#1b1b3a' lw 0.35\n"
       << "unset multiplot\n";
}

}  // namespace figures
