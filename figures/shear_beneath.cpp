// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/shear_beneath.hpp"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "figures/style.hpp"

namespace figures {
namespace {

// gnuplot's nonuniform matrix: first row n, x₁ … xₙ, then a row z, values for each depth.
std::string matrix(literate::Plot& plot, const std::string& suffix, const ShearBeneath& data,
                   const std::vector<double>& field) {
  const std::size_t n = data.x.size();
  std::vector<std::vector<double>> columns{{static_cast<double>(n)}};
  columns[0].insert(columns[0].end(), data.z.begin(), data.z.end());
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> column{data.x[i]};
    for (std::size_t k = 0; k < data.z.size(); ++k) column.push_back(field[k * n + i]);
    columns.push_back(std::move(column));
  }
  return plot.data(suffix, {columns.begin(), columns.end()});
}

}  // namespace

void draw_shear_beneath(literate::Plot& plot, const ShearBeneath& data) {
  const auto closed = plot.data("closed", {data.depth, data.closed});
  const auto nodes = plot.data("nodes", {data.node_depth, data.node});
  apply_style(plot);
  // A map has no title or axis label of its own within fixed margins: labels of the screen.
  const auto panel = [&](double left, double right, const std::string& above, const char* below) {
    plot << fmt::format("unset label\nset lmargin at screen {}\nset rmargin at screen {}\n", left,
                        right)
         << fmt::format("set label '{}' at screen {},0.95 center\n", above, (left + right) / 2)
         << fmt::format("set label '{}' at screen {},0.035 center\n", below, (left + right) / 2);
  };
  plot << "set multiplot\nset tmargin at screen 0.90\nset bmargin at screen 0.23\n"
       << "set xtics 1\nset yrange [2.5:0]\nset ytics 0.5\nset ylabel '$z/a$' offset -0.6,0\n"
       << "set xrange [-2:2]\nset border 15\nunset key\nunset grid\n"
       << "unset surface\nset contour base\nset view map\nset cntrlabel onecolor\n"
       << fmt::format("set cntrparam levels discrete {}\n", fmt::join(data.levels, ", "));
  const auto contours = [&](const ShearField& field, const char* suffix, double left) {
    const auto values = matrix(plot, suffix, data, field.tau);
    panel(left, left + 0.315, fmt::format("$\\mu = {}$", field.friction), "$x/a$");
    for (const FieldLabel& label : field.labels) {
      plot << fmt::format(
          "set label '\\fboxsep=1pt\\colorbox{{white}}{{\\scriptsize {:.2f}}}' at {},{} center "
          "front\n",
          label.value, label.x, label.z);
    }
    plot << fmt::format("set label '' at {},{} point ls 13 ps 0.7 front\n", field.greatest.x,
                        field.greatest.z)
         << "splot " << values << " nonuniform matrix using 1:2:3 with lines ls 1 lw 1.4\n";
  };
  contours(data.still, "still", 0.09);
  plot << "set format y ''\nset ylabel ''\n";
  contours(data.sliding, "sliding", 0.445);
  panel(0.80, 0.985, "$x = 0$, $\\mu = 0$", "$\\tau_1/p_0$");
  plot << "set surface\nunset contour\nunset view\nset border 3\nset grid\n"
       << "set xrange [0:0.35]\nset xtics 0.1\n"
       << "plot " << closed << " using 2:1 with lines ls 1, \\\n"
       << "  " << nodes << " using 2:1 with points ls 11\n"
       << "unset multiplot\n";
}

}  // namespace figures
