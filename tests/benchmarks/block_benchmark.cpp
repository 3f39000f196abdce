// SPDX-License-Identifier: GPL-3.0-or-later
// The finite block: time as a function of order, refinement and number of unknowns.
#include <benchmark/benchmark.h>

#include "block/analysis.hpp"
#include "block/solution.hpp"
#include "elasticity/loads.hpp"

namespace {

const elasticity::Material material(30e6, 0.30);
const elasticity::Load load = elasticity::LinearFall(1000, 0.6, 0.01);
const block::Supports clamped = block::with_sides(block::Support::clamped);

block::Discretization discretization(const benchmark::State& state) {
  return {.order = static_cast<int>(state.range(0)), .refine = static_cast<int>(state.range(1))};
}

std::shared_ptr<const block::Model> model(const benchmark::State& state) {
  return std::make_shared<const block::Model>(
      block::graded_mesh({2, 1}, {load}, discretization(state)), material);
}

void count(benchmark::State& state, const block::Factorization& factorization) {
  state.counters["unknowns"] = static_cast<double>(factorization.n_unknowns());
}

void assemble_and_condense(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(model(state));
}

void factorise(benchmark::State& state) {
  const auto shared = model(state);
  for (auto _ : state) benchmark::DoNotOptimize(block::Factorization(shared, clamped));
  count(state, block::Factorization(shared, clamped));
}

void solve_one_load(benchmark::State& state) {
  const block::Factorization factorization(model(state), clamped);
  for (auto _ : state) benchmark::DoNotOptimize(factorization.solve(load));
  count(state, factorization);
}

void take_measures(benchmark::State& state) {
  const block::Factorization factorization(model(state), clamped);
  const block::Solution solution = factorization.solve(load);
  for (auto _ : state) benchmark::DoNotOptimize(block::measures(solution, {}));
}

void orders_and_levels(benchmark::internal::Benchmark* benchmark) {
  for (const int order : {4, 7, 10}) {
    for (const int refine : {1, 2}) benchmark->Args({order, refine});
  }
  benchmark->ArgNames({"order", "refine"})->Unit(benchmark::kMillisecond);
}

// The complete computation of the command `block`.
void compute_block(benchmark::State& state) {
  for (auto _ : state) {
    const block::Analysis analysis({2, 1}, material, {load}, discretization(state));
    benchmark::DoNotOptimize(analysis.on(clamped).solve(load).measures());
  }
}

BENCHMARK(assemble_and_condense)->Apply(orders_and_levels);
BENCHMARK(factorise)->Apply(orders_and_levels);
BENCHMARK(solve_one_load)->Apply(orders_and_levels);
BENCHMARK(take_measures)->Apply(orders_and_levels);
BENCHMARK(compute_block)->Apply(orders_and_levels);

}  // namespace
