// SPDX-License-Identifier: GPL-3.0-or-later
// Two cylinders: time as a function of the number of nodes, for each method. The domain is 4.1
// half-widths.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "line_contact/cylinders.hpp"
#include "line_contact/methods.hpp"
#include "numerics/fit.hpp"

namespace {

const elasticity::Material steel(30e6, 0.30);
const line_contact::CylinderPair cylinders(steel, line_contact::Radius::of_cylinder("radius1", 1),
                                           steel, line_contact::Radius::of_cylinder("radius2", 3));
constexpr double load = 2500;
const line_contact::Hertz hertz(cylinders, load);

line_contact::Problem problem_of(long n_nodes) {
  return {cylinders.profile(), cylinders.contact_modulus(),
          line_contact::grid_of_width(4.1 * hertz.half_width(), n_nodes)};
}

void count(benchmark::State& state, const line_contact::Solution& solution) {
  double inside = 0;
  for (Eigen::Index i = 0; i < solution.grid.n_nodes; ++i) {
    const double x = solution.grid.x(i);
    if (std::abs(x) > 0.9 * hertz.half_width()) continue;
    inside = std::max(inside, std::abs(solution.pressure[i] - hertz.pressure(x)));
  }
  state.counters["solves"] = solution.work.revisions;
  state.counters["products"] = solution.work.products;
  state.counters["error_inside"] = inside / hertz.peak_pressure();
  state.counters["error_peak"] = std::abs(solution.peak_pressure() / hertz.peak_pressure() - 1);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["MB_so_far"] = static_cast<double>(usage.ru_maxrss) / 1024;
}

template <class Method>
void run(benchmark::State& state, const Method& method) {
  const line_contact::Problem problem = problem_of(state.range(0));
  line_contact::Solution solution{problem, {}, {}};
  for (auto _ : state) {
    solution = method(problem, load);
    benchmark::DoNotOptimize(solution.pressure.data());
  }
  count(state, solution);
}

line_contact::Solution by_fft(const line_contact::Problem& problem, double line_load) {
  return line_contact::solve_by_fft(problem, line_load);
}

void matrix_inversion(benchmark::State& state) {
  run(state, line_contact::solve_by_matrix_inversion);
}
void variational(benchmark::State& state) {
  run(state, line_contact::solve_by_variational_method);
}
void fft(benchmark::State& state) {
  run(state, by_fft);
}

// Fits the exponent of N in the time from 2^14 to 2^22 nodes to the best of three runs.
void fft_exponent(benchmark::State& state) {
  std::vector<double> n;
  std::vector<double> seconds;
  for (auto _ : state) {
    for (int power = 14; power <= 22; ++power) {
      const line_contact::Problem problem = problem_of(1L << power);
      double best = 1e300;
      for (int repeat = 0; repeat < 3; ++repeat) {
        const auto start = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(by_fft(problem, load).pressure.data());
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        best = std::min(best, elapsed.count());
      }
      n.push_back(std::ldexp(1.0, power));
      seconds.push_back(best);
    }
  }
  state.counters["exponent"] = -numerics::fit_power(n, seconds).order;
}

BENCHMARK(matrix_inversion)->Arg(41)->Arg(91)->Arg(361)->Unit(benchmark::kMillisecond);
BENCHMARK(variational)->Arg(361)->Arg(1001)->Unit(benchmark::kMillisecond);
BENCHMARK(fft)->Arg(1 << 12)->Arg(1 << 16)->Arg(1 << 20)->Unit(benchmark::kMillisecond);
BENCHMARK(fft_exponent)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
