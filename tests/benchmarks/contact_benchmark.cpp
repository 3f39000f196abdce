// SPDX-License-Identifier: GPL-3.0-or-later
// Two cylinders by matrix inversion: time against the number of nodes.
#include <benchmark/benchmark.h>

#include "contact/hertz.hpp"
#include "contact/matrix_inversion.hpp"

namespace {

void solve_contact(benchmark::State& state) {
  const elasticity::Material steel(30e6, 0.30);
  const contact::CylinderPair cylinders(steel, contact::Radius::of_cylinder("radius1", 1), steel,
                                        contact::Radius::of_cylinder("radius2", 3));
  constexpr double load = 2500;
  const double half_width = contact::Hertz(cylinders, load).half_width();
  const contact::Grid grid = contact::grid_around(half_width, state.range(0));
  int n_solves = 0;
  for (auto _ : state) {
    const contact::Solution solution = contact::solve_by_matrix_inversion(cylinders, load, grid);
    n_solves = solution.n_solves;
    benchmark::DoNotOptimize(solution.pressure.data());
  }
  state.counters["solves"] = n_solves;
}

BENCHMARK(solve_contact)
    ->ArgName("nodes")
    ->Arg(41)
    ->Arg(91)
    ->Arg(361)
    ->Unit(benchmark::kMillisecond);

}  // namespace
