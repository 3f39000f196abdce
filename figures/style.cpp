// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/style.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace figures {

void apply_style(literate::Plot& plot) {
  plot << "set style line 1 lc rgb '#1b1b3a' lw 2.2 dt solid\n"
          "set style line 2 lc rgb '#c1440e' lw 2.2 dt (9,5)\n"
          "set style line 3 lc rgb '#3d8f8f' lw 2.6 dt (2,3)\n"
          "set style line 4 lc rgb '#8a8a8a' lw 1.8 dt (9,3,2,3)\n"
          "set style line 11 lc rgb '#c1440e' lw 1.8 pt 6 ps 0.65\n"
          "set style line 12 lc rgb '#3d8f8f' lw 1.8 pt 4 ps 0.85\n"
          "set style line 13 lc rgb '#1b1b3a' lw 1.6 pt 2 ps 0.5\n"
          "set border 3 lw 0.8\n"
          "set tics nomirror out scale 0.6\n"
          "set grid lw 0.4 lc rgb '#dddddd' dt solid\n"
          "set key spacing 1.25 samplen 2.6 width -2\n";
}

void apply_schematic_style(literate::Plot& plot) {
  apply_style(plot);
  plot << "unset border\nunset tics\nunset grid\nunset key\nset size ratio -1\n"
          "set lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n"
          "set style arrow 1 heads filled size graph 0.012,18 lc rgb '#1b1b3a' lw 1\n"
          "set style arrow 2 head filled size graph 0.012,18 lc rgb '#1b1b3a' lw 1\n"
          "set style arrow 3 nohead lc rgb '#8a8a8a' lw 0.8 dt (4,3)\n";
}

AxisScale axis_scale(double largest, const std::string& unit) {
  if (largest == 0 || (largest >= 0.01 && largest < 1000)) return {1, unit};
  const int exponent = 3 * static_cast<int>(std::floor(std::log10(largest) / 3));
  // 10^exponent as a quotient of exact powers, so that scaled data are rounded once.
  const double factor = exponent < 0 ? std::pow(10.0, -exponent) : 1 / std::pow(10.0, exponent);
  return {factor, fmt::format("$10^{{{}}}$\\,{}", exponent, unit)};
}

double tick_step(double largest) {
  if (largest == 0) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(largest)));
  if (largest < 2 * power) return power / 2;
  return largest < 5 * power ? power : 2 * power;
}

std::vector<double> scaled(const std::vector<double>& numbers, double factor) {
  std::vector<double> result(numbers.size());
  std::transform(numbers.begin(), numbers.end(), result.begin(),
                 [factor](double number) { return factor * number; });
  return result;
}

double largest_magnitude(const std::vector<double>& numbers) {
  double largest = 0;
  for (const double number : numbers) largest = std::fmax(largest, std::abs(number));
  return largest;
}

}  // namespace figures
