// SPDX-License-Identifier: GPL-3.0-or-later
// Two spheres on N × N nodes, with a contact as wide as 0.9 of the domain: time and work as
// functions of N, for nested grids with a preconditioner and for ordinary conjugate gradients, with
// the same elements, grid and tolerance.
#include <benchmark/benchmark.h>
#include <gsl/gsl_fit.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "point_contact/hertz.hpp"
#include "point_contact/methods.hpp"

namespace {

using point_contact::Problem;
using point_contact::Solution;

constexpr double modulus = 913.7;
constexpr double curvature = 0.571;
constexpr double load = 3.461;
// The tolerance for comparing the two methods. At N = 1024 the variational method needs many
// products to get from 1e-7 to 1e-8.
constexpr double common_tolerance = 1e-7;
const point_contact::Hertz hertz(modulus, curvature, load);

Problem spheres(long n) {
  const double side = 2 * hertz.radius() / 0.9;
  return {point_contact::Profile::paraboloid(curvature), modulus,
          point_contact::square_grid(side, n), point_contact::Element::pyramid};
}

void count(benchmark::State& state, const Solution& solution) {
  double inside = 0;
  const point_contact::Grid& grid = solution.grid;
  for (Eigen::Index j = 0; j < grid.n2; ++j) {
    for (Eigen::Index i = 0; i < grid.n1; ++i) {
      const double r = grid.node(i, j).norm();
      if (r > 0.9 * hertz.radius()) continue;
      const double error = std::abs(solution.pressure[grid.index(i, j)] - hertz.pressure(r));
      inside = std::max(inside, error);
    }
  }
  state.counters["revisions"] = solution.work.revisions;
  state.counters["products"] = solution.work.products;
  state.counters["preconditionings"] = solution.work.preconditionings;
  state.counters["error_inside"] = inside / hertz.peak_pressure();
  state.counters["error_peak"] = std::abs(solution.peak_pressure() / hertz.peak_pressure() - 1);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["MB_so_far"] = static_cast<double>(usage.ru_maxrss) / 1024;
}

template <class Method>
void run(benchmark::State& state, const Method& method, double tolerance) {
  const Problem problem = spheres(state.range(0));
  Solution solution{problem, {}, {}};
  for (auto _ : state) {
    solution = method(problem, load, tolerance);
    benchmark::DoNotOptimize(solution.pressure.data());
  }
  count(state, solution);
}

void spheres_by_fft(benchmark::State& state) {
  run(state, point_contact::solve_for_load, 1e-8);
}
void spheres_by_fft_as_good(benchmark::State& state) {
  run(state, point_contact::solve_for_load, common_tolerance);
}
void spheres_by_variational_method(benchmark::State& state) {
  run(state, point_contact::solve_by_variational_method, common_tolerance);
}

// Fits the exponent of the number of nodes in the time from 256² to 2048² nodes.
void spheres_exponent(benchmark::State& state) {
  std::vector<double> log_n;
  std::vector<double> log_seconds;
  for (auto _ : state) {
    for (const long n : {256, 512, 1024, 2048}) {
      const Problem problem = spheres(n);
      double best = 1e300;
      for (int repeat = 0; repeat < 2; ++repeat) {
        const auto start = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(point_contact::solve_for_load(problem, load).pressure.data());
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        best = std::min(best, seconds.count());
      }
      log_n.push_back(2 * std::log(static_cast<double>(n)));
      log_seconds.push_back(std::log(best));
    }
  }
  double intercept, slope, cov00, cov01, cov11, residual;
  gsl_fit_linear(log_n.data(), 1, log_seconds.data(), 1, log_n.size(), &intercept, &slope, &cov00,
                 &cov01, &cov11, &residual);
  state.counters["exponent"] = slope;
}

BENCHMARK(spheres_by_fft)->Arg(128)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(spheres_by_fft_as_good)->Arg(256)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(spheres_by_variational_method)
    ->Arg(256)
    ->Arg(1024)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(spheres_exponent)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
