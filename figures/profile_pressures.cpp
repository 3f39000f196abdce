// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/profile_pressures.hpp"

#include "figures/style.hpp"

namespace figures {

void draw_profile_pressures(literate::Plot& plot, const ProfilePressures& data) {
  apply_style(plot);
  plot << "set xrange [0:1.1]\nset xtics 0.25\nset yrange [0:1.75]\nset ytics 0.5\n"
       << "set multiplot layout 2,2 margins 0.075,0.985,0.12,0.97 spacing 0.05,0.06\n";
  int k = 0;
  for (const ProfilePressures::Panel& panel : data.panels) {
    const std::string suffix = std::to_string(k);
    const auto nodes = plot.data("nodes" + suffix, {panel.x, panel.pressure});
    const auto exact = plot.data("exact" + suffix, {panel.exact_x, panel.exact, panel.hertz});
    const bool is_left = k % 2 == 0;
    const bool is_low = k >= 2;
    plot << "set format y '" << (is_left ? "$%g$" : "") << "'\n"
         << "set ylabel '" << (is_left ? "$p/p_0$" : "") << "' offset 1\n"
         << "set format x '" << (is_low ? "$%g$" : "") << "'\n"
         << "set xlabel '" << (is_low ? "$x/a$" : "") << "'\n"
         << "set label 1 '" << panel.title << "' at graph 0.05,0.1 left\n"
         << (k == 0 ? "set key at graph 1,0.98 right top\n" : "unset key\n") << "plot " << exact
         << " using 1:3 with lines ls 4 title 'cylinders', \\\n"
         << "  " << exact << " using 1:2 with lines ls 1 title 'closed form', \\\n"
         << "  " << nodes << " with points ls 11 title 'elements'\n";
    ++k;
  }
  plot << "unset multiplot\n";
}

}  // namespace figures
