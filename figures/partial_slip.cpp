// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/partial_slip.hpp"

#include <fmt/core.h>

#include <string>

#include "figures/style.hpp"

namespace figures {

void draw_partial_slip(literate::Plot& plot, const PartialSlip& data) {
  const auto sliding = plot.data("sliding", {data.sliding_x, data.sliding});
  apply_style(plot);
  std::string commands = fmt::format("plot {} with lines ls 4 title 'sliding'", sliding);
  for (std::size_t k = 0; k < data.curves.size(); ++k) {
    const SlipCurve& curve = data.curves[k];
    const auto line = plot.data(fmt::format("curve{}", k), {curve.x, curve.shear});
    const auto nodes = plot.data(fmt::format("nodes{}", k), {curve.node_x, curve.node});
    commands += fmt::format(
        ", \\\n  {} with lines ls {} notitle, \\\n  {} every 2 with points ls {} notitle, \\\n"
        "  keyentry with linespoints ls {} pt {} ps {} title '$Q = {}\\,\\mu P$'",
        line, k + 1, nodes, k + 11, k + 1, std::array{6, 4, 2}[k], std::array{0.65, 0.85, 0.5}[k],
        curve.share);
    const double height = -0.05 - 0.05 * static_cast<double>(k);
    plot << fmt::format("set arrow from {0},{2} to {1},{2} nohead ls {3} lw 4 dt solid\n",
                        -curve.stick, curve.stick, height, k + 1);
  }
  plot << "set xrange [-1.1:1.1]\nset xtics 0.5\nset yrange [-0.2:1.05]\nset ytics 0,0.25\n"
       << "set xlabel '$x/a$'\nset ylabel '$q/(\\mu p_0)$'\n"
       << "set key outside right center reverse Left\n"
       << "set label 'sticks' at 0.88,-0.1 left\n"
       << commands << "\n";
}

}  // namespace figures
