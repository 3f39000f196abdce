// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/fit_misfit.hpp"

#include "figures/style.hpp"

namespace figures {

void draw_fit_misfit(literate::Plot& plot, const FitMisfit& data) {
  const auto file = plot.data("sides", {data.edge_fraction, data.clamped, data.roller, data.free});
  apply_style(plot);
  plot << "set logscale y\nset format y '$10^{%T}$'\nset xrange [0:1]\n"
       << "set xlabel 'edge fraction of the load'\nset ylabel 'largest misfit'\n"
       << "set key bottom left\n"
       << "plot " << file << " using 1:4 with lines ls 3 title 'free sides', \\\n  " << file
       << " using 1:3 with lines ls 2 title 'roller', \\\n  " << file
       << " using 1:2 with lines ls 1 title 'clamped'\n";
}

}  // namespace figures
