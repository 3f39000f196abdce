// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/block_contours.hpp"

#include <limits>

#include "figures/style.hpp"

namespace figures {
namespace {

// Each cell as a quadrilateral of five points and a gap, with the mean u_z of its corners: polygons
// need no line between the rows of a grid, which columns of data do not have.
std::string cells(literate::Plot& plot, const std::string& suffix, const ContourWindow& window,
                  double u_factor) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto row = static_cast<std::size_t>(window.n_along_x);
  std::vector<double> x, y, u;
  for (std::size_t k = 0; k + row + 1 < window.x.size(); ++k) {
    if (k % row == row - 1) continue;
    const std::size_t corners[] = {k, k + 1, k + 1 + row, k + row, k};
    double mean = 0;
    for (int c = 0; c < 4; ++c) mean += window.u_z[corners[c]] / 4;
    for (const std::size_t c : corners) {
      x.push_back(window.x[c]);
      y.push_back(window.y[c]);
      u.push_back(u_factor * mean);
    }
    x.push_back(nan);
    y.push_back(nan);
    u.push_back(nan);
  }
  return plot.data(suffix, {x, y, u});
}

}  // namespace

void draw_block_contours(literate::Plot& plot, const BlockContours& data) {
  const AxisScale scale = axis_scale(data.largest, data.unit);
  const auto whole = cells(plot, "whole", data.whole, scale.factor);
  const auto close_up = cells(plot, "close-up", data.close_up, scale.factor);
  apply_style(plot);
  plot << "set palette maxcolors 10 defined (0 '#f7f4e9', 0.5 '#5fa8a8', 1 '#1b1b3a')\n"
       << "set cbrange [0:" << scale.factor * data.largest << "]\nset size ratio -1\n"
       << "set xtics autofreq\nunset grid\nunset key\nset style fill solid 1 border\n"
       << "set multiplot\n"
       << "set lmargin at screen 0.11\n"
       << "set rmargin at screen 0.47\nunset colorbox\n"
       << "set xlabel '$x$ (" << data.unit << ")'\nset ylabel '$-z$ (" << data.unit << ")'\n"
       << "plot " << whole << " using 1:2:3 with filledcurves closed lc palette lw 0.3\n"
       << "set colorbox\nset cbtics autofreq\nset cblabel '$u_z$ (" << scale.unit
       << ")' offset 1.6,0\n"
       << "set xtics " << 4 * data.half_width << "\nset ytics " << 4 * data.half_width << "\n"
       << "set xrange [" << -4.6 * data.half_width << ":" << 4.6 * data.half_width
       << "]\nset yrange [" << -5 * data.half_width << ":" << 0.5 * data.half_width
       << "]\nset lmargin at screen 0.58\nset rmargin at screen 0.87\nset ylabel ''\n"
       << "plot " << close_up << " using 1:2:3 with filledcurves closed lc palette lw 0.3\n"
       << "unset multiplot\n";
}

}  // namespace figures
