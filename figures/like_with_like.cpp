// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/like_with_like.hpp"

#include "figures/style.hpp"

namespace figures {

void draw_like_with_like(literate::Plot& plot, const LikeWithLike& data) {
  const AxisScale x_scale = axis_scale(largest_magnitude(data.x), data.unit);
  const AxisScale u_scale = axis_scale(largest_magnitude(data.half_space), data.unit);
  const auto curves =
      plot.data("curves", {scaled(data.x, x_scale.factor), scaled(data.half_space, u_scale.factor),
                           scaled(data.block_stated, u_scale.factor),
                           scaled(data.block_fitted, u_scale.factor)});
  const auto points = plot.data(
      "printed", {scaled(data.printed_x, x_scale.factor), scaled(data.printed, u_scale.factor)});
  apply_style(plot);
  plot << "set xlabel '$x$ (" << x_scale.unit << ")'\nset ylabel '$u_z$ (" << u_scale.unit << ")'\n"
       << "set xrange [0:" << x_scale.factor * data.x.back() << "]\nset yrange [0:*]\n"
       << "set key bottom left reverse Left\n"
       << "plot " << curves << " using 1:2 with lines ls 1 title 'half-space, triangle', \\\n  "
       << curves << " using 1:3 with lines ls 4 title 'block, triangle', \\\n  " << curves
       << " using 1:4 with lines ls 2 title 'block, fitted load', \\\n  " << points
       << " using 1:2 with points ls 11 title 'printed, FEA $z$'\n";
}

}  // namespace figures
