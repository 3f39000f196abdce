// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>

#include "assignment.hpp"
#include "assignment/shapes.hpp"

namespace {

using Numbers = std::vector<double>;

// The numbers from `first` on, each given to `compute`, which appends to the answer.
template <class Compute>
Numbers for_each_from(std::size_t first, const Numbers& in, const Compute& compute) {
  Numbers out;
  for (std::size_t i = first; i < in.size(); ++i) compute(in[i], out);
  return out;
}

Numbers gradient(const Numbers& in) {
  return for_each_from(4, in, [&](double x, Numbers& out) {
    out.push_back(exercise::normal_gradient({in[0], in[1]}, {in[2], in[3]}, x));
  });
}

// The pressure that S p₀ a name.
exercise::Load load_of(double number, double unit_pressure, double half_width) {
  const assignment::Shape shape = assignment::shape_of(number);
  const auto pressure = [=](double s) {
    return assignment::pressure(shape, unit_pressure, half_width, s);
  };
  return {pressure, half_width, unit_pressure};
}

Numbers gradient_by_quadrature(const Numbers& in) {
  const exercise::Load load = load_of(in[2], in[3], in[4]);
  return for_each_from(5, in, [&](double x, Numbers& out) {
    const auto found = exercise::normal_gradient_by_quadrature({in[0], in[1]}, load, x);
    out.push_back(found.value);
    out.push_back(found.abs_error);
  });
}

Numbers displacement(const Numbers& in) {
  const exercise::Load load = load_of(in[2], in[3], in[4]);
  return for_each_from(6, in, [&](double x, Numbers& out) {
    out.push_back(exercise::normal_displacement({in[0], in[1]}, load, in[5], x));
  });
}

Numbers influence(const Numbers& in) {
  return for_each_from(3, in, [&](double k, Numbers& out) {
    const int distance = static_cast<int>(std::lround(k));
    out.push_back(exercise::influence_coefficient(in[0], in[1], in[2], distance));
  });
}

Numbers contact(const Numbers& in) {
  const exercise::Cylinders cylinders{{in[0], in[1]}, in[2], {in[3], in[4]}, in[5]};
  const exercise::Grid grid{static_cast<int>(std::lround(in[8])), in[7]};
  const exercise::Contact found = exercise::solve_contact(cylinders, grid, in[9], in[6]);
  Numbers out = {found.approach, found.half_width};
  out.insert(out.end(), found.pressure.begin(), found.pressure.end());
  return out;
}

struct Task {
  std::size_t n_inputs;  // at least
  Numbers (*run)(const Numbers&);
};

const std::map<std::string, Task> tasks = {
    {"gradient", {5, gradient}},         {"gradient_by_quadrature", {6, gradient_by_quadrature}},
    {"displacement", {7, displacement}}, {"influence", {4, influence}},
    {"contact", {10, contact}},
};

}  // namespace

std::vector<double> run_task(const std::string& task, const std::vector<double>& inputs) {
  const auto found = tasks.find(task);
  if (found == tasks.end()) throw std::invalid_argument("there is no task " + task);
  const Task& known = found->second;
  if (inputs.size() < known.n_inputs) {
    throw std::invalid_argument("task " + task + " takes at least " +
                                std::to_string(known.n_inputs) + " numbers");
  }
  return known.run(inputs);
}
