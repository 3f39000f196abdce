// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/block_claims.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "paper/prelude.hpp"

namespace paper {
namespace {

// Samples a window of the block evenly and moves each point by its displacement, enlarged.
// Each cell of the samples is a closed polygon with the mean u_z of its corners, and a gap after
// it.
FigureData sample(const block::Solution& solution, double left, double right, double depth,
                  double enlargement) {
  constexpr int n_along_x = 96, n_along_z = 48;
  std::vector<double> x, y, u_z;
  for (int j = 0; j <= n_along_z; ++j) {
    for (int i = 0; i <= n_along_x; ++i) {
      // Divide first: the last of each is then the end itself, and not beside it.
      const double at_x = left + (right - left) * (static_cast<double>(i) / n_along_x);
      const double at_z = depth * (static_cast<double>(j) / n_along_z);
      const Eigen::Vector2d u = solution.displacement(at_x, at_z);
      x.push_back(at_x + enlargement * u.x());
      y.push_back(-at_z - enlargement * u.y());
      u_z.push_back(u.y());
    }
  }

  std::vector<double> cell_x, cell_y, cell_u;
  constexpr std::size_t row = n_along_x + 1;
  for (std::size_t k = 0; k + row + 1 < x.size(); ++k) {
    if (k % row == row - 1) continue;
    const std::size_t corners[] = {k, k + 1, k + 1 + row, k + row, k};
    double mean = 0;
    for (int c = 0; c < 4; ++c) mean += u_z[corners[c]] / 4;
    for (const std::size_t c : corners) {
      cell_x.push_back(x[c]);
      cell_y.push_back(y[c]);
      cell_u.push_back(mean);
    }
    for (auto* column : {&cell_x, &cell_y, &cell_u}) column->push_back(literate::gap);
  }
  return {{"x", cell_x}, {"y", cell_y}, {"u_z", cell_u}};
}

// How far displacements are enlarged to be seen: round numbers.
struct Enlargements {
  double whole, close;
};

double rounded_down_to_a_digit(double x) {
  const double decade = std::pow(10, std::floor(std::log10(x)));
  return std::floor(x / decade) * decade;
}

Enlargements enlargements_of(double a, double height, double largest) {
  return {rounded_down_to_a_digit(0.08 * height / largest),
          rounded_down_to_a_digit(0.8 * a / largest)};
}

Figure contours(Document& document, const HalfSpaceCase& half_space, const BlockCase& block_case,
                const UnitSystem& units, const BlockStudy& study) {
  const block::Solution& solution = study.under_triangle().fine();
  const block::Rectangle& r = block_case.rectangle;
  const double a = half_space.load.half_width();
  const double largest = solution.displacement(0, 0).y();
  const Enlargements enlargements = enlargements_of(a, r.height(), largest);
  document.value("contours.enlargement.whole",
                 Value(Estimate{enlargements.whole, 0}, significant(1)));
  document.value("contours.enlargement.close",
                 Value(Estimate{enlargements.close, 0}, significant(1)));
  return {.width_cm = 15,
          .height_cm = 5,
          .data = {{"whole", sample(solution, r.left(), r.right(), r.height(), enlargements.whole)},
                   {"close_up", sample(solution, -4 * a, 4 * a, 4 * a, enlargements.close)}},
          .numbers = {{"half_width", a},
                      {"largest", largest},
                      {"right", r.right()},
                      {"height", r.height()}},
          .texts = {{"unit", units.length}}};
}

// The curves of the half-space and of the block, and the three printed columns of Fig. 5.
Figure like_with_like(const HalfSpaceCase& h, const UnitSystem& units, const BlockStudy& study,
                      const PrintedFigure5& printed) {
  std::vector<double> x, half_space, block_stated, block_fitted;
  constexpr int n = 240;
  for (int i = 0; i <= n; ++i) {
    x.push_back(h.farthest_point() * (static_cast<double>(i) / n));
    half_space.push_back(normal_displacement(h.material, h.load, x.back(), h.datum));
    block_stated.push_back(study.under_triangle().displacement_z(x.back(), 0).value);
    block_fitted.push_back(study.fit()->fit.solution.displacement_z(x.back(), 0).value);
  }
  const auto values_of_column = [](const std::vector<PrintedNumber>& column) {
    std::vector<double> values;
    for (const PrintedNumber& number : column) values.push_back(number.value());
    return values;
  };
  return {.width_cm = 15.4,
          .height_cm = 5.2,
          .data = {{"curves",
                    {{"x", x},
                     {"half_space", half_space},
                     {"block_stated", block_stated},
                     {"block_fitted", block_fitted}}},
                   {"printed",
                    {{"x", values_of_column(printed.x)},
                     {"analytical", values_of_column(printed.analytical)},
                     {"u_z", values_of_column(printed.fea_z)}}}},
          .numbers = {{"half_width", h.load.half_width()}},
          .texts = {{"unit", units.length}}};
}

}  // namespace

void register_block_figures(Document& document, const HalfSpaceCase& half_space,
                            const BlockCase& block_case, const UnitSystem& units,
                            const BlockStudy& study, const std::optional<PrintedData>& printed) {
  if (!printed) {
    document.figure("block-contours", contours(document, half_space, block_case, units, study));
    return;
  }
  document.figure("like-with-like", like_with_like(half_space, units, study, printed->figure5));
}

}  // namespace paper
