// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/element_kinds.hpp"

#include "figures/style.hpp"

namespace figures {

void draw_element_kinds(literate::Plot& plot, const ElementKinds& data) {
  const auto displacement = plot.data(
      "displacement",
      {data.x, data.point_displacement, data.uniform_displacement, data.triangular_displacement});
  const auto gradient = plot.data(
      "gradient", {data.x, data.point_gradient, data.uniform_gradient, data.triangular_gradient});
  apply_style(plot);
  plot << "set multiplot layout 1,2 margins 0.08,0.985,0.17,0.90 spacing 0.10\n"
       << "set xrange [" << data.x.front() << ":" << data.x.back() << "]\n"
       << "set xtics 1\nset xlabel '$x/c$'\n"
       << "set title 'displacement' offset 0,-0.6\nset yrange [-1.2:3.2]\n"
       << "set key top right\n"
       << "plot " << displacement << " using 1:2 with lines ls 3 title 'force', \\\n"
       << "  " << displacement << " using 1:3 with lines ls 2 title 'uniform', \\\n"
       << "  " << displacement << " using 1:4 with lines ls 1 title 'triangle'\n"
       << "set title 'gradient' offset 0,-0.6\nset yrange [-4.5:4.5]\nunset key\n"
       << "plot " << gradient << " using 1:2 with lines ls 3, \\\n"
       << "  " << gradient << " using 1:3 with lines ls 2, \\\n"
       << "  " << gradient << " using 1:4 with lines ls 1\n"
       << "unset multiplot\n";
}

}  // namespace figures
