// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/quadrature_error.hpp"

#include "figures/style.hpp"

namespace figures {

void draw_quadrature_error(literate::Plot& plot, const QuadratureError& data) {
  const auto gradient =
      plot.data("gradient", {data.x, data.gradient_difference, data.gradient_estimate});
  const auto displacement =
      plot.data("displacement", {data.x, data.displacement_difference, data.displacement_estimate});
  apply_style(plot);
  plot << "set logscale xy\nset format '$10^{%T}$'\n"
       << "set xrange [" << data.x.front() << ":" << data.x.back() << "]\n"
       << "set yrange [1e-20:1e-9]\nset ytics 1e-18,100\nset xtics 1e-4,100\n"
       << "set xlabel '$x/a$'\nset key top left reverse Left\n"
       << "set multiplot layout 1,2 margins 0.10,0.985,0.17,0.90 spacing 0.06\n"
       << "set title 'gradient, in units of $K/a$' offset 0,-0.6\n"
       << "plot " << gradient << " using 1:3 with lines ls 2 title 'reported error', \\\n"
       << "  " << gradient
       << " using 1:2 with points ls 13 title '$|$quadrature $-$ closed form$|$'\n"
       << "set title 'displacement, in units of $K$' offset 0,-0.6\nset format y ''\nunset key\n"
       << "plot " << displacement << " using 1:3 with lines ls 2, \\\n"
       << "  " << displacement << " using 1:2 with points ls 13\n"
       << "unset multiplot\n";
}

}  // namespace figures
