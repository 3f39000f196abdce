// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/load_contest.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "elasticity/load_shapes.hpp"
#include "numerics/least_squares.hpp"
#include "paper/prelude.hpp"

namespace paper {
namespace {

using block::RefinedSolution;
using block::Support;
using block::Supports;

// Every shape is 1 in the middle and falls to 0 at the ends of the load, where only the uniform
// pressure, the first of two, is left.
Measured largest_pressure(const std::vector<Measured>& factors) {
  Measured middle = 0;
  for (const Measured& factor : factors) middle = middle + factor;
  return middle.value() > factors.front().value() ? middle : factors.front();
}

// The misfit on one mesh.
struct MisfitOnOneMesh {
  double largest = 0;
  double largest_share = 0;
  double sum_of_squares = 0;

  MisfitOnOneMesh(const std::vector<double>& residuals, const std::vector<Measured>& ones) {
    for (std::size_t i = 0; i < ones.size(); ++i) {
      const double residual = std::abs(residuals[i]);
      const double standard = ones[i].standard();
      const double share = standard > 0 ? residual / standard : residual;
      largest = std::max(largest, residual);
      largest_share = std::max(largest_share, share);
      sum_of_squares += share * share;
    }
  }
};

Misfit on_both(const MisfitOnOneMesh& fine, const MisfitOnOneMesh& coarse) {
  const auto estimate = [&](double MisfitOnOneMesh::*which) {
    return Estimate{fine.*which, std::abs(fine.*which - coarse.*which)};
  };
  return {estimate(&MisfitOnOneMesh::largest), estimate(&MisfitOnOneMesh::largest_share),
          estimate(&MisfitOnOneMesh::sum_of_squares)};
}

Contestant fitted(const BlockStudy& study, std::string shape, const Supports& supports,
                  const std::vector<RefinedSolution>& solutions) {
  const block::Fit fine = block::fit_loads(solutions, study.observed());
  const block::Fit coarse = block::fit_coarse_loads(solutions, study.observed());
  const std::vector<Measured> ones = block::relative(study.observed());
  return {std::move(shape),
          static_cast<int>(solutions.size()),
          supports,
          on_both({fine.residuals, ones}, {coarse.residuals, ones}),
          largest_pressure(fine.factors),
          {fine.solution.fine(), coarse.solution.fine()}};
}

// The displacements at the observed points over those observed, for one load.
using Ratios = std::vector<double>;

Ratios ratios_of(const block::Solution& solution,
                 const std::vector<block::SurfaceDisplacement>& observed) {
  Ratios ratios;
  for (const block::SurfaceDisplacement& point : observed) {
    ratios.push_back(solution.displacement(point.x, 0).y() / point.u_z.value());
  }
  return ratios;
}

// The misfit of the combination of two loads that fits the displacements, `ones`, best.
MisfitOnOneMesh best_misfit(const Ratios& u, const Ratios& v, const std::vector<Measured>& ones) {
  Eigen::MatrixXd ratios(static_cast<Eigen::Index>(u.size()), 2);
  ratios << Eigen::Map<const Eigen::VectorXd>(u.data(), ratios.rows()),
      Eigen::Map<const Eigen::VectorXd>(v.data(), ratios.rows());
  const numerics::LinearLeastSquares fit = numerics::fit_linear(ratios, ones);
  return {fit.residuals, ones};
}

// The displacements of one mesh under 1 − |x/a|ᵐ for any m: a polynomial in ln m through their
// values at Chebyshev's points, by the second barycentric formula (Berrut, Trefethen 2004).
class FallsByExponent {
 public:
  void add(double exponent, Ratios ratios) {
    exponents_.push_back(exponent);
    ratios_.push_back(std::move(ratios));
  }

  Ratios at(double exponent) const {
    const auto n = static_cast<double>(exponents_.size());
    Ratios sum(ratios_.front().size(), 0.0);
    double weights = 0;
    for (std::size_t k = 0; k < exponents_.size(); ++k) {
      const double distance = std::log(exponent / exponents_[k]);
      if (distance == 0) return ratios_[k];
      const double sign = k % 2 == 0 ? 1 : -1;
      const double weight =
          sign * std::sin((static_cast<double>(k) + 0.5) * std::numbers::pi / n) / distance;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * ratios_[k][i];
      weights += weight;
    }
    for (double& s : sum) s /= weights;
    return sum;
  }

 private:
  std::vector<double> exponents_;
  std::vector<Ratios> ratios_;
};

constexpr double narrower = 0.9;  // the half-width of a triangle over that of the load
constexpr int n_exponents = 14;
constexpr double of_exponent = 1e-6;  // to which searches find their exponents

// Chebyshev's points in ln m, from the greatest to the least.
double chebyshev_exponent(int k) {
  const double middle = std::log(least_exponent * most_exponent) / 2;
  const double half = std::log(most_exponent / least_exponent) / 2;
  return std::exp(middle + half * std::cos((k + 0.5) * std::numbers::pi / n_exponents));
}

// The place of the least value of a function that falls and then rises, by golden sections.
double least_of(const std::function<double(double)>& f, double begin, double end) {
  constexpr double golden = 1 / std::numbers::phi;
  while (end - begin > of_exponent) {
    const double left = end - golden * (end - begin);
    const double right = begin + golden * (end - begin);
    (f(left) < f(right) ? end : begin) = f(left) < f(right) ? right : left;
  }
  return (begin + end) / 2;
}

// How far from `inside`, where it is so, towards `end` a condition holds without a gap.
double end_of_range(const std::function<bool(double)>& holds, double inside, double end) {
  if (!holds(inside)) return inside;
  constexpr int n_steps = 100;  // finer than any two humps of a misfit of eleven points
  double last = inside;
  for (int i = 1; i <= n_steps; ++i) {
    double next = inside + (end - inside) * (static_cast<double>(i) / n_steps);
    if (holds(next)) {
      last = next;
      continue;
    }
    while (std::abs(next - last) > of_exponent) {
      const double middle = (last + next) / 2;
      (holds(middle) ? last : next) = middle;
    }
    return last;
  }
  return end;
}

struct ExponentOnOneMesh {
  double best, least, most, misfit;
};

ExponentOnOneMesh fit_exponent(const FallsByExponent& falls, const Ratios& uniform,
                               const std::vector<Measured>& ones, double allowed) {
  const auto misfit = [&](double m) { return best_misfit(falls.at(m), uniform, ones); };
  const double best =
      least_of([&](double m) { return misfit(m).sum_of_squares; }, least_exponent, most_exponent);
  const auto is_met = [&](double m) { return misfit(m).largest_share <= allowed; };
  return {best, end_of_range(is_met, best, least_exponent),
          end_of_range(is_met, best, most_exponent), misfit(best).largest};
}

}  // namespace

std::vector<Contestant> contest(const BlockStudy& study, const HalfSpaceCase& half_space,
                                Support sides) {
  const double a = half_space.load.half_width();
  const block::SupportedBlock& own = study.on(sides);
  const Supports own_supports = block::with_sides(sides);
  const RefinedSolution uniform = own.solve(elasticity::linear_fall(1, 1, a));
  struct Shape {
    std::string name;
    elasticity::Load load;
  };
  const Shape shapes[] = {{"triangle", elasticity::linear_fall(1, 0, a)},
                          {"cosine", elasticity::cosine_fall(1, a)},
                          {"narrower triangle", elasticity::linear_fall(1, 0, narrower * a)},
                          {"step", elasticity::linear_fall(1, 1, a / 2)},
                          {"root", elasticity::power_fall(1, 0.5, a)},
                          {"ellipse", elasticity::EllipticLoad(1, a)},
                          {"parabola", elasticity::power_fall(1, 2, a)},
                          {"quartic", elasticity::power_fall(1, 4, a)}};

  std::vector<Contestant> contestants;
  for (const Shape& shape : shapes) {
    const RefinedSolution solution = own.solve(shape.load);
    if (contestants.empty()) {
      contestants.push_back(fitted(study, shape.name + " alone", own_supports, {solution}));
      contestants.push_back(fitted(study, "uniform alone", own_supports, {uniform}));
    }
    contestants.push_back(
        fitted(study, "uniform + " + shape.name, own_supports, {uniform, solution}));
  }

  const auto add = [&](const Supports& supports) {
    if (supports == own_supports) return;
    const block::SupportedBlock block = study.on(supports);
    contestants.push_back(fitted(study, "uniform + triangle", supports,
                                 {block.solve(elasticity::linear_fall(1, 1, a)),
                                  block.solve(elasticity::linear_fall(1, 0, a))}));
  };
  for (const Support other : {Support::clamped, Support::roller, Support::free}) {
    add(block::with_sides(other));
  }
  for (const Support other : {Support::clamped, Support::roller}) {
    add({.left = other, .right = other, .bottom = Support::roller});
  }
  return contestants;
}

ExponentFit fit_exponent(const BlockStudy& study, double half_width, Support sides,
                         double allowed) {
  const block::SupportedBlock& block = study.on(sides);
  const RefinedSolution uniform = block.solve(elasticity::linear_fall(1, 1, half_width));
  FallsByExponent fine, coarse;
  for (int k = 0; k < n_exponents; ++k) {
    const double m = chebyshev_exponent(k);
    const RefinedSolution fall = block.solve(elasticity::power_fall(1, m, half_width));
    fine.add(m, ratios_of(fall.fine(), study.observed()));
    coarse.add(m, ratios_of(fall.coarse(), study.observed()));
  }
  const std::vector<Measured> ones = block::relative(study.observed());
  const Ratios uniform_ratios = ratios_of(uniform.fine(), study.observed());
  const auto on_fine = fit_exponent(fine, uniform_ratios, ones, allowed);
  const auto on_coarse =
      fit_exponent(coarse, ratios_of(uniform.coarse(), study.observed()), ones, allowed);
  const auto estimate = [&](double ExponentOnOneMesh::*which) {
    return Estimate{on_fine.*which, std::abs(on_fine.*which - on_coarse.*which) + of_exponent};
  };
  return {estimate(&ExponentOnOneMesh::best), estimate(&ExponentOnOneMesh::least),
          estimate(&ExponentOnOneMesh::most), estimate(&ExponentOnOneMesh::misfit)};
}

Contestant fitted_power_fall(const BlockStudy& study, double exponent, double half_width,
                             Support sides) {
  const block::SupportedBlock& block = study.on(sides);
  return fitted(study, "uniform + power", block::with_sides(sides),
                {block.solve(elasticity::linear_fall(1, 1, half_width)),
                 block.solve(elasticity::power_fall(1, exponent, half_width))});
}

elasticity::Load round_load(const HalfSpaceCase& half_space) {
  return elasticity::linear_fall(half_space.load.peak_pressure(), round_edge_share,
                                 half_space.load.half_width());
}

Contestant unfitted(const BlockStudy& study, const std::string& shape, const elasticity::Load& load,
                    double peak, Support sides) {
  const RefinedSolution solution = study.on(sides).solve(load);
  const std::vector<Measured> ones = block::relative(study.observed());
  const auto misfit = [&](const block::Solution& s) {
    Ratios residuals = ratios_of(s, study.observed());
    for (double& residual : residuals) residual -= 1;
    return MisfitOnOneMesh(residuals, ones);
  };
  return {shape,
          0,
          block::with_sides(sides),
          on_both(misfit(solution.fine()), misfit(solution.coarse())),
          peak,
          solution};
}

}  // namespace paper
