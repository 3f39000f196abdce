// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/block_convergence.hpp"

#include "figures/style.hpp"

namespace figures {

void draw_block_convergence(literate::Plot& plot, const BlockConvergence& data) {
  const auto file =
      plot.data("orders", {data.order, data.displacement, data.energy, data.von_mises});
  apply_style(plot);
  plot << "set logscale y\nset format y '$10^{%T}$'\nset xtics 1\n"
       << "set xlabel 'order of the elements'\nset ylabel 'relative change'\nset key bottom left\n"
       << "plot " << file
       << " using 1:4 with linespoints ls 3 pt 4 title 'largest von Mises stress', \\\n  " << file
       << " using 1:2 with linespoints ls 1 pt 2 title '$u_z$ under the load', \\\n  " << file
       << " using 1:3 with linespoints ls 2 pt 6 title 'strain energy'\n";
}

}  // namespace figures
