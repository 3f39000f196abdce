// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include "figures/displacement_comparison.hpp"
#include "paper/decimals.hpp"
#include "paper/quoted.hpp"
#include "paper/sections.hpp"

namespace paper {
namespace {

using literate::Column;
using literate::Value;
using parameters::PrintedNumber;

double analytical(const parameters::HalfSpaceCase& c, double x) {
  return normal_displacement(c.material, c.load, x, c.datum);
}

std::vector<double> values_of(const std::vector<PrintedNumber>& printed) {
  std::vector<double> values;
  for (const PrintedNumber& number : printed) values.push_back(number.value());
  return values;
}

figures::DisplacementComparison comparison_figure(const parameters::Case& from_file) {
  const parameters::HalfSpaceCase& c = from_file.half_space;
  figures::DisplacementComparison figure;
  constexpr int n = 300;
  const double end = 1.2 * c.points.back();
  for (int i = 0; i <= n; ++i) {
    figure.x.push_back(end * i / n);
    figure.analytical.push_back(analytical(c, figure.x.back()));
  }
  figure.half_width = c.load.half_width();
  figure.unit = from_file.units.length;
  if (from_file.printed) {
    const parameters::PrintedFigure5& printed = from_file.printed->figure5;
    figure.printed_x = values_of(printed.x);
    figure.printed_analytical = values_of(printed.analytical);
    figure.fea_z = values_of(printed.fea_z);
    figure.fea_magnitude = values_of(printed.fea_magnitude);
  }
  return figure;
}

// Eq. (3) at the points, for a case that has no printed data to stand beside.
void tabulate_displacements(literate::Document& document, const parameters::Case& from_file) {
  const parameters::HalfSpaceCase& c = from_file.half_space;
  literate::Table table({Column::fixed("$x$", from_file.units.length, decimals_of(c.points)),
                         Column::common_exponent("$u_z$, eq.~(3)", from_file.units.length, 8),
                         Column::common_exponent("$\\partial u_z/\\partial x$", "", 8)});
  for (const double x : c.points) {
    table.add_row({x, analytical(c, x), normal_gradient(c.material, c.load, x)});
  }
  document.table("displacements", table);
}

// The point whose printed value is farthest from eq. (3), in units of its last place.
void describe_odd_point(literate::Document& document, const parameters::Case& from_file,
                        std::size_t i) {
  const parameters::HalfSpaceCase& c = from_file.half_space;
  const PrintedNumber& printed = from_file.printed->tri_dist.displacement[i];
  const std::string& unit = from_file.units.length;
  const double x = c.points[i];
  const double exact = analytical(c, x);
  const double slope = normal_gradient(c.material, c.load, x);
  document.value("tri-dist.odd.x", Value::fixed(x, decimals_of(c.points), unit));
  document.value("tri-dist.odd.printed",
                 Value::scientific(printed.value(), printed.n_digits(), unit));
  document.value("tri-dist.odd.exact", Value::scientific(exact, printed.n_digits(), unit));
  document.value("tri-dist.odd.difference",
                 Value::scientific(std::abs(printed.value() - exact), 2, unit));
  document.value("tri-dist.odd.slope", Value::scientific(slope, 3));
}

// The program's output beside eq. (3), at the point and where the program really took it.
void compare_tri_dist(literate::Document& document, const parameters::Case& from_file) {
  const parameters::HalfSpaceCase& c = from_file.half_space;
  const parameters::PrintedTriDist& printed = from_file.printed->tri_dist;
  literate::Table table({Column::fixed("$x$", from_file.units.length, decimals_of(c.points)),
                         Column::scaled("Tri\\_dist.m", from_file.units.length, -6, 7),
                         Column::scaled("eq.~(3)", from_file.units.length, -6, 7),
                         Column::integer("digits that agree"),
                         Column::scaled("eq.~(3), stepped off", from_file.units.length, -6, 7)});
  long n_agree = 0;
  long n_agree_stepped = 0;
  double largest_off = 0;
  std::size_t odd = 0;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const double x = c.points[i];
    // The program replaces its first and third abscissa by ones that avoid the logarithm of zero.
    const bool steps_off =
        x == 0 || std::abs(x - c.load.half_width()) < 1e-12 * c.load.half_width();
    const double exact = analytical(c, x);
    const double stepped = analytical(c, steps_off ? x + printed.step.value() : x);
    const PrintedNumber& digits = printed.displacement[i];
    table.add_row({x, quoted(digits), exact, digits.n_agreeing_digits(exact), stepped});
    n_agree += digits.agrees_with(exact);
    n_agree_stepped += digits.agrees_with(stepped);
    const double off = std::abs(digits.value() - exact) / digits.last_place();
    if (off > largest_off) {
      largest_off = off;
      odd = i;
    }
  }
  describe_odd_point(document, from_file, odd);
  const long n_points = std::ssize(c.points);
  document.table("tri-dist", table);
  document.value("tri-dist.n-agree", Value::integer(n_agree));
  document.value("tri-dist.n-agree-stepped", Value::integer(n_agree_stepped));
  document.value("tri-dist.step", Value::exact(printed.step.value(), from_file.units.length));
  document.value("tri-dist.n-digits", Value::integer(printed.displacement.front().n_digits()));
  document.check("tri-dist-digits", n_agree == n_points - 1,
                 "eq. (3) has every printed digit of Tri_dist.m at all points but one");
  document.check("tri-dist-step", n_agree_stepped == n_points,
                 "eq. (3) where Tri_dist.m really took it has every printed digit at all points");
}

// Fig. 5 rebuilt: the analytical column from eq. (3), the error column from the other columns.
void compare_figure5(literate::Document& document, const parameters::Case& from_file) {
  const parameters::HalfSpaceCase& c = from_file.half_space;
  const parameters::PrintedFigure5& printed = from_file.printed->figure5;
  const std::string& unit = from_file.units.length;
  literate::Table table(
      {Column::fixed("$x$", unit, decimals_of(c.points)), Column::scaled("FEA ($z$)", unit, -6, 6),
       Column::scaled("analytical", unit, -6, 6), Column::scaled("eq.~(3)", unit, -6, 6),
       Column::scaled("error", unit, -8, 6),
       Column::scaled("$|$eq.~(3) $-$ FEA ($z$)$|$", unit, -8, 6)});
  long n_analytical = 0;
  long n_errors_of_magnitude = 0;
  long n_errors_of_z = 0;
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const double exact = analytical(c, c.points[i]);
    const double error_z = std::abs(exact - printed.fea_z[i].value());
    table.add_row({quoted(printed.x[i]), quoted(printed.fea_z[i]), quoted(printed.analytical[i]),
                   exact, quoted(printed.error[i]), error_z});
    n_analytical += printed.analytical[i].agrees_with(exact);

    // The error column is the difference of two printed columns: of which? It carries more digits
    // than they do, so it may be off by their last places.
    const double slack = printed.analytical[i].last_place();
    const auto explains = [&](const PrintedNumber& fea) {
      const double difference = std::abs(printed.analytical[i].value() - fea.value());
      return std::abs(difference - printed.error[i].value()) <= slack;
    };
    n_errors_of_magnitude += explains(printed.fea_magnitude[i]);
    n_errors_of_z += explains(printed.fea_z[i]);
  }
  document.table("figure5", table);
  document.value("figure5.n-analytical", Value::integer(n_analytical));
  document.value("figure5.n-errors-of-magnitude", Value::integer(n_errors_of_magnitude));
  document.value("figure5.n-errors-of-z", Value::integer(n_errors_of_z));
  document.check("figure5-error-column", n_errors_of_magnitude == std::ssize(c.points),
                 "the error column of Fig. 5 is the difference from the FEA magnitude everywhere");
}

}  // namespace

void compute_results(literate::Document& document, const parameters::Case& from_file) {
  document.figure("displacement-comparison", 12.5, 7.6,
                  [figure = comparison_figure(from_file)](literate::Plot& plot) {
                    figures::draw_displacement_comparison(plot, figure);
                  });
  if (from_file.printed) {
    compare_tri_dist(document, from_file);
    compare_figure5(document, from_file);
  } else {
    tabulate_displacements(document, from_file);
  }
}

}  // namespace paper
