// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/sheet_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "elasticity/material.hpp"
#include "elasticity/triangular_load.hpp"

namespace assignment {
namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

// The triangle, its pieces of surface on either side, and what its lengths are called.
void draw_triangle(literate::Plot& plot) {
  const auto triangle =
      plot.data("triangle", {std::vector<double>{-1, 0, 1}, std::vector<double>{0, 1, 0}});
  plot << "set xrange [-2:4.4]\nset yrange [-0.45:1.25]\n"
       << "set arrow 1 from -1.9,0 to 4.2,0 as 1\nset label 1 '$x$' at 4.25,-0.14\n"
       << "set arrow 2 from 0,0 to 0,-0.42 as 1\nset label 2 '$z,\\,u_z$' at 0.12,-0.36\n"
       << "set label 3 '$p_0$' at 0.12,1.1\n"
       << "set label 4 '$-a$' at -1,-0.14 center\nset label 5 '$a$' at 1,-0.14 center\n"
       << "set label 6 '$d$' at 3.4,-0.14 center\n"
       << "set label 7 'datum: $u_z=0$' at 3.4,0.2 center\n"
       << "set arrow 3 from 3.4,-0.05 to 3.4,0.05 nohead lw 1.5\n"
       << "plot " << triangle << " with filledcurves y=0 fs solid 0.25 lc rgb '#3d8f8f' notitle, "
       << triangle << " with lines lc rgb '#1b1b3a' lw 2 notitle\n";
}

// Five triangles at neighbouring nodes, and the sum of their pressures.
void draw_row(literate::Plot& plot) {
  const std::vector<double> node = {-3, -2, -1, 0, 1, 2, 3};
  const std::vector<double> height = {0, 0.62, 0.9, 1, 0.9, 0.62, 0};
  std::vector<double> x;
  std::vector<double> p;
  for (std::size_t j = 1; j + 1 < node.size(); ++j) {
    x.insert(x.end(), {node[j] - 1, node[j], node[j] + 1, node[j] + 1});
    p.insert(p.end(), {0, height[j], 0, gap});
  }
  const auto row = plot.data("row", {x, p});
  const auto sum = plot.data("sum", {node, height});
  plot << "unset label\nunset arrow\nset xrange [-3.6:3.9]\nset yrange [-0.45:1.25]\n"
       << "set arrow 1 from -3.5,0 to 3.7,0 as 1\nset label 1 '$x$' at 3.75,-0.14\n"
       << "set arrow 2 from 1,-0.12 to 2,-0.12 as 2\nset label 2 '$c$' at 1.5,-0.27 center\n"
       << "set label 3 '$p_j$' at 1.12,1.02\n"
       << "plot " << row << " with lines lc rgb '#3d8f8f' lw 1.2 dt (5,3) notitle, " << sum
       << " with lines lc rgb '#1b1b3a' lw 2 notitle, " << sum
       << " with points pt 7 ps 0.4 lc rgb '#1b1b3a' notitle\n";
}

// The slope's bracket as it stands in eq. (3).
double three_terms(double xi) {
  const double above = xi + 1;
  const double below = xi - 1;
  return above * std::log(above) + below * std::log(below) - 2 * xi * std::log(xi);
}

}  // namespace

void draw_setting(literate::Plot& plot) {
  plot << "unset border\nunset tics\nunset key\nset tmargin 0\nset bmargin 0\n"
       << "set style arrow 1 head filled size graph 0.02,18 lc rgb '#1b1b3a' lw 1\n"
       << "set style arrow 2 heads filled size graph 0.015,18 lc rgb '#1b1b3a' lw 1\n"
       << "set multiplot layout 1,2\n";
  draw_triangle(plot);
  draw_row(plot);
  plot << "unset multiplot\n";
}

void draw_lost_digits(literate::Plot& plot) {
  // A unit load on a body without Poisson's ratio whose slope is the bracket itself.
  const elasticity::Material material(2 / std::numbers::pi, 0);
  const elasticity::TriangularLoad load(1, 1);
  std::vector<double> distance;
  std::vector<double> error;
  for (double exponent = 0.2; exponent <= 8; exponent += 0.025) {
    const double xi = std::pow(10, exponent);
    const double exact = -elasticity::normal_gradient(material, load, xi);
    distance.push_back(xi);
    error.push_back(std::max(1e-16, std::abs(three_terms(xi) / exact - 1)));
  }
  const auto points = plot.data("error", {distance, error});
  plot << "set border 3\nset tics out nomirror\nset key off\nset grid lc rgb '#dddddd'\n"
       << "set logscale xy\nset format '$10^{%T}$'\nset xrange [1:1e8]\nset yrange [1e-16:10]\n"
       << "set ytics 1e-16,1e4\nset xlabel '$x/a$'\nset ylabel 'relative error'\n"
       << "plot " << points << " with points pt 7 ps 0.25 lc rgb '#1b1b3a'\n";
}

}  // namespace assignment
