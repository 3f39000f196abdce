// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/surface_gradient.hpp"

#include "figures/style.hpp"

namespace figures {

void draw_surface_gradient(literate::Plot& plot, const SurfaceGradient& data) {
  const auto file = plot.data("loads", {data.x, data.concentrated, data.uniform, data.triangular});
  apply_style(plot);
  plot << "set xlabel '$x/a$'\n"
          "set ylabel '$(\\partial u_z/\\partial x)\\,/\\,(K/a)$'\n"
          "set xrange [-3:3]\nset yrange [-3.2:3.2]\nset xtics 1\nset ytics 1\n"
          "set key top right\n"
       << "plot " << file << " using 1:2 with lines ls 3 title 'concentrated', \\\n"
       << "  " << file << " using 1:3 with lines ls 2 title 'uniform', \\\n"
       << "  " << file << " using 1:4 with lines ls 1 title 'triangular'\n";
}

}  // namespace figures
