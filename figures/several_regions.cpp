// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/several_regions.hpp"

#include "figures/style.hpp"

namespace figures {

void draw_several_regions(literate::Plot& plot, const SeveralRegions& data) {
  apply_style(plot);
  const std::size_t n = data.panels.size();
  plot << "set xrange [-1.15:1.15]\nset xtics 1./3\nset yrange [0:2.1]\nset ytics 1\n"
       << "set format x ''\nset ylabel '$p/p_0$'\n"
       << "set multiplot layout " << n << ",1 margins 0.09,0.985,0.125,0.98 spacing 0.05\n";
  for (std::size_t k = 0; k < n; ++k) {
    const SeveralRegions::Panel& panel = data.panels[k];
    const auto curves =
        plot.data("load" + std::to_string(k), {panel.x, panel.pressure, panel.smooth});
    const bool is_last = k + 1 == n;
    if (is_last) plot << "set format x '$%.2g$'\nset xlabel '$x/a$'\n";
    plot << "set label 1 '" << panel.title << "' at graph 0.02,0.85 left\n"
         << (k == 0 ? "set key top right\n" : "unset key\n") << "plot " << curves
         << " using 1:2 with filledcurves y=0 lc rgb '#d9d9d9' notitle, \\\n"
         << "  " << curves << " using 1:2 with lines ls 1 title 'with waves', \\\n"
         << "  " << curves << " using 1:3 with lines ls 2 title 'smooth'\n";
  }
  plot << "unset multiplot\n";
}

}  // namespace figures
