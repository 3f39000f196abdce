// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/triangular_elements.hpp"

#include <cmath>
#include <limits>

#include "figures/style.hpp"

namespace figures {

void draw_triangular_elements(literate::Plot& plot, const TriangularElements& data) {
  // One curve of all triangles, with a gap after each.
  std::vector<double> x;
  std::vector<double> height;
  for (std::size_t j = 0; j < data.x.size(); ++j) {
    if (data.pressure[j] == 0) continue;
    x.insert(x.end(), {data.x[j] - 1, data.x[j], data.x[j] + 1, data.x[j] + 1});
    height.insert(height.end(), {0, data.pressure[j], 0, std::numeric_limits<double>::quiet_NaN()});
  }
  const auto triangles = plot.data("triangles", {x, height});
  const auto sum = plot.data("sum", {data.x, data.pressure});

  // The paper's labels: p₀ in the middle, p_j and c at a node on the right.
  const std::size_t middle = data.x.size() / 2;
  const std::size_t j = middle + 2;
  const double height_of_j = data.pressure[j];
  apply_style(plot);
  plot << "unset border\nunset tics\nunset grid\nunset key\n"
       << "set xrange [" << data.x.front() - 0.6 << ":" << data.x.back() + 1.2 << "]\n"
       << "set yrange [-0.24:1.3]\nset lmargin 1\nset rmargin 1\nset tmargin 0\nset bmargin 0\n"
       << "set style arrow 1 heads filled size graph 0.012,18 lc rgb '#1b1b3a' lw 1\n"
       << "set style arrow 2 head filled size graph 0.012,18 lc rgb '#1b1b3a' lw 1\n"
       << "set arrow from " << data.x.front() - 0.5 << ",0 to " << data.x.back() + 0.9
       << ",0 as 2\nset label '$x$' at " << data.x.back() + 1.0 << ",0\n"
       << "set arrow from 0,0 to 0,1.22 as 2\nset label '$p$' at 0.15,1.22\n"
       << "set label '$O$' at 0,-0.08 center\nset label '$p_0$' at -0.15,1.06 right\n"
       << "set label '$p_j$' at " << data.x[j] + 0.12 << "," << height_of_j + 0.07 << "\n"
       << "set arrow from " << data.x[j] << ",-0.1 to " << data.x[j] + 1 << ",-0.1 as 1\n"
       << "set label '$c$' at " << data.x[j] + 0.5 << ",-0.18 center\n"
       << "plot " << triangles
       << " with filledcurves y=0 fs transparent solid 0.25 lc rgb '#3d8f8f'"
       << " notitle, \\\n  " << triangles << " with lines lc rgb '#3d8f8f' lw 1.2 dt (5,3), \\\n  "
       << sum << " with lines ls 1, \\\n  " << sum << " with points pt 7 ps 0.4 lc rgb '#1b1b3a'\n";
}

}  // namespace figures
