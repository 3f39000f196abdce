// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of a half-space, by quadrature of eq. (2) and by eq. (3): time and evaluations of the
// load per point.
#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "elasticity/loads.hpp"
#include "elasticity/surface_quadrature.hpp"
#include "numbers.hpp"

namespace {

using elasticity::SurfaceQuadrature;

const elasticity::Material material(30e6, 0.30);
const elasticity::TriangularLoad load(1000, 0.010);
constexpr double datum = 10;

// The eleven points of the paper's Fig. 5.
std::vector<double> papers_points() {
  std::vector<double> points;
  for (int i = 0; i <= 10; ++i) points.push_back(i * 0.005);
  return points;
}

// Points under the load, at its kinks and far from it.
std::vector<double> random_points() {
  RandomInputs random(2001);
  std::vector<double> points;
  for (int i = 0; i < 1000; ++i) points.push_back(load.half_width() * random.point(1e6));
  return points;
}

using Points = std::vector<double> (*)();

// Calls evaluate(x) repeatedly for all points, and reports the time per point.
template <class Evaluate>
void time_points(benchmark::State& state, const std::vector<double>& points, Evaluate&& evaluate) {
  for (auto _ : state) {
    for (const double x : points) benchmark::DoNotOptimize(evaluate(x));
  }
  const auto n_points = static_cast<double>(points.size());
  state.counters["per_point"] = benchmark::Counter(
      n_points, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// A load that counts its evaluations.
elasticity::Load counted(const std::shared_ptr<long>& n_evaluations) {
  const elasticity::Load plain = load;
  std::vector<numerics::Piece> pieces;
  for (const numerics::Piece& piece : plain.normal.pieces()) {
    pieces.push_back({piece.begin, piece.end, [=](double s) {
                        ++*n_evaluations;
                        return piece.value(s);
                      }});
  }
  return {numerics::PiecewiseFunction(pieces)};
}

// Times a member of SurfaceQuadrature and separately counts its evaluations of the load.
template <class Member>
void time_quadrature(benchmark::State& state, Points points, Member member) {
  const std::vector<double> xs = points();
  const SurfaceQuadrature surface(material, load, datum);
  time_points(state, xs, [&](double x) { return (surface.*member)(x); });

  const auto n_evaluations = std::make_shared<long>(0);
  const SurfaceQuadrature counting(material, counted(n_evaluations), datum);
  *n_evaluations = 0;
  for (const double x : xs) (counting.*member)(x);
  state.counters["evaluations"] =
      static_cast<double>(*n_evaluations) / static_cast<double>(xs.size());
}

void gradient_by_quadrature(benchmark::State& state, Points points) {
  time_quadrature(state, points, &SurfaceQuadrature::normal_gradient);
}

void displacement_by_quadrature(benchmark::State& state, Points points) {
  time_quadrature(state, points, &SurfaceQuadrature::normal_displacement);
}

void displacement_from_gradient(benchmark::State& state, Points points) {
  time_quadrature(state, points, &SurfaceQuadrature::normal_displacement_from_gradient);
}

void gradient_in_closed_form(benchmark::State& state, Points points) {
  time_points(state, points(), [](double x) { return normal_gradient(material, load, x); });
}

void displacement_in_closed_form(benchmark::State& state, Points points) {
  time_points(state, points(),
              [](double x) { return normal_displacement(material, load, x, datum); });
}

BENCHMARK_CAPTURE(gradient_by_quadrature, papers_points, papers_points);
BENCHMARK_CAPTURE(gradient_by_quadrature, random_points, random_points);
BENCHMARK_CAPTURE(displacement_by_quadrature, papers_points, papers_points);
BENCHMARK_CAPTURE(displacement_by_quadrature, random_points, random_points);
BENCHMARK_CAPTURE(displacement_from_gradient, papers_points, papers_points);
BENCHMARK_CAPTURE(gradient_in_closed_form, papers_points, papers_points);
BENCHMARK_CAPTURE(gradient_in_closed_form, random_points, random_points);
BENCHMARK_CAPTURE(displacement_in_closed_form, papers_points, papers_points);
BENCHMARK_CAPTURE(displacement_in_closed_form, random_points, random_points);

}  // namespace
