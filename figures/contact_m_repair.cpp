// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/contact_m_repair.hpp"

#include <fmt/core.h>

#include <cmath>

#include "figures/style.hpp"

namespace figures {
namespace {

constexpr double top = 2.5;        // of the pressure shown
constexpr std::size_t across = 3;  // panels

// p/p₀ = √(1 − x²/a²), even in the angle, so that the steep ends have points enough.
std::string hertz_curve(literate::Plot& plot) {
  std::vector<double> x, pressure;
  constexpr int n = 200;
  for (int i = 0; i <= n; ++i) {
    const double angle = std::acos(-1.0) * i / n;
    x.push_back(-std::cos(angle));
    pressure.push_back(std::sin(angle));
  }
  return plot.data("hertz", {x, pressure});
}

}  // namespace

void draw_contact_m_repair(literate::Plot& plot, const ContactMRepair& data) {
  const auto hertz = hertz_curve(plot);
  const std::size_t n_rows = (data.panels.size() + across - 1) / across;
  apply_style(plot);
  plot << "set multiplot layout " << n_rows << "," << across
       << " margins 0.095,0.99,0.115,0.95 spacing 0.03,0.11\n"
       << "set xrange [-1.5:1.5]\nset xtics 1\nset yrange [0:" << top << "]\nset ytics 0.5\n"
       << "unset key\n";
  for (std::size_t i = 0; i < data.panels.size(); ++i) {
    const ContactMRepair::Panel& panel = data.panels[i];
    const auto file = plot.data(fmt::format("panel-{}", i), {panel.x, panel.pressure});
    const bool is_left = i % across == 0;
    const bool is_bottom = i + across >= data.panels.size();
    const double largest = largest_magnitude(panel.pressure);
    plot << "set title '" << panel.title << "' offset 0,-0.7\n"
         << "set format x '" << (is_bottom ? "$%g$" : "") << "'\nset format y '"
         << (is_left ? "$%g$" : "") << "'\n"
         << "set xlabel '" << (is_bottom ? "$x/a$" : "") << "'\nset ylabel '"
         << (is_left ? "$p/p_0$" : "") << "'\nunset label\n";
    if (largest > top) {
      plot << "set label 'to " << fmt::format("${:.2f}$", largest) << "' at 0.45," << 0.93 * top
           << "\n";
    }
    plot << "plot " << hertz << " using 1:2 with filledcurves y1=0 fc rgb '#dcdcdc', \\\n  "
         << hertz << " using ($1*" << panel.own_half_width << "):($2*" << panel.own_p0
         << ") with lines ls 2, \\\n  " << file << " using 1:2 with lines ls 1 lw 1.6, \\\n  "
         << file << " using 1:2 with points ls 13 pt 7 ps 0.18\n";
  }
  plot << "unset multiplot\n";
}

}  // namespace figures
