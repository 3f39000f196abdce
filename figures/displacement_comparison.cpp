// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/displacement_comparison.hpp"

#include "figures/style.hpp"

namespace figures {

void draw_displacement_comparison(literate::Plot& plot, const DisplacementComparison& data) {
  const AxisScale x_scale = axis_scale(largest_magnitude(data.x), data.unit);
  const AxisScale u_scale = axis_scale(largest_magnitude(data.analytical), data.unit);
  const auto x = scaled(data.x, x_scale.factor);
  const auto curve = plot.data("analytical", {x, scaled(data.analytical, u_scale.factor)});
  apply_style(plot);
  plot << "set xlabel '$x$ (" << x_scale.unit << ")'\n"
       << "set ylabel '$u_z$ (" << u_scale.unit << ")'\n"
       << "set xrange [0:" << x.back() << "]\nset yrange [0:*]\nset key bottom left reverse Left\n"
       << "set arrow from " << x_scale.factor * data.half_width << ", graph 0 to "
       << x_scale.factor * data.half_width << ", graph 1 nohead lc rgb '#8a8a8a' lw 0.8 dt (4,3)\n"
       << "set label '$x = a$' at " << x_scale.factor * data.half_width
       << ", graph 0.95 offset 0.6,0\n"
       << "plot " << curve << " with lines ls 1 title 'eq.~(3)'";
  if (!data.printed_x.empty()) {
    const auto points = plot.data(
        "printed",
        {scaled(data.printed_x, x_scale.factor), scaled(data.printed_analytical, u_scale.factor),
         scaled(data.fea_z, u_scale.factor), scaled(data.fea_magnitude, u_scale.factor)});
    plot << ", \\\n  " << points << " using 1:2 with points ls 13 title 'printed, analytical'"
         << ", \\\n  " << points << " using 1:4 with points ls 12 title 'printed, FEA magnitude'"
         << ", \\\n  " << points << " using 1:3 with points ls 11 title 'printed, FEA $z$'";
  }
  plot << "\n";
}

}  // namespace figures
