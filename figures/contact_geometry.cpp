// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/contact_geometry.hpp"

#include <string>

#include "figures/style.hpp"

namespace figures {
namespace {

// An arrow with heads at both ends along x, and its label beside it.
void measure(literate::Plot& plot, double x, double from, double to, const std::string& label,
             double label_offset) {
  plot << "set arrow from " << x << "," << from << " to " << x << "," << to << " as 1 front\n"
       << "set label '" << label << "' at " << x + label_offset << "," << (from + to) / 2
       << (label_offset < 0 ? " right" : "") << " front\n";
}

}  // namespace

void draw_contact_geometry(literate::Plot& plot, const ContactGeometry& data) {
  const auto before = plot.data("before", {data.x, data.before1, data.before2});
  const auto after = plot.data("after", {data.x, data.after1, data.after2});
  const double end = data.x.back();
  const double apex = data.apex;
  apply_schematic_style(plot);
  plot << "unset size\nset xrange [" << -end - 0.75 << ":" << end + 0.75 << "]\n"
       << "set yrange [" << -1.15 * data.height << ":" << 1.15 * data.height << "]\n"
       << "set arrow from " << -end - 0.2 << ",0 to " << end + 0.4 << ",0 as 2\nset label '$x$' at "
       << end + 0.5 << ",0\n"
       << "set arrow from 0,0 to 0," << -data.height << " as 2\nset label '$z$' at 0.08,"
       << -data.height << "\nset label '$O$' at 0.08," << -0.07 * data.height << "\n"
       << "set label 'body 1' at " << -end + 0.3 << "," << -0.85 * data.height << "\n"
       << "set label 'body 2' at " << -end + 0.3 << "," << 0.85 * data.height << "\n";

  // Levels of the two apexes, had they passed through each other.
  for (const double level : {apex, -apex}) {
    plot << "set arrow from " << -0.4 << "," << level << " to " << data.x_of_h + 0.2 << "," << level
         << " as 3\n";
  }
  plot << "set arrow from -0.3," << -apex << " to -0.3," << apex
       << " as 1 front\n"
          "set label '$\\delta$' at -0.38,"
       << apex / 2 << " right front\n";
  measure(plot, data.x_of_u, data.before_at_u, 0, "$u_{z1}$", 0.08);
  measure(plot, data.x_of_u, 0, -data.before_at_u, "$u_{z2}$", 0.08);
  measure(plot, data.x_of_h, apex, data.before_at_h, "$h_1$", 0.08);
  measure(plot, data.x_of_h, -apex, -data.before_at_h, "$h_2$", 0.08);

  plot << "plot " << after << " using 1:2:(-" << 1.15 * data.height
       << ") with filledcurves fs transparent solid 0.12 lc rgb '#1b1b3a', \\\n  " << after
       << " using 1:3:(" << 1.15 * data.height
       << ") with filledcurves fs transparent solid 0.12 lc rgb '#3d8f8f', \\\n  " << before
       << " using 1:2 with lines ls 4, \\\n  " << before << " using 1:3 with lines ls 4, \\\n  "
       << after << " using 1:2 with lines ls 1, \\\n  " << after << " using 1:3 with lines ls 1\n";
}

}  // namespace figures
