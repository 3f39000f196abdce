#include "tasks.hpp"

#include <stdexcept>

#include "exercise.hpp"

std::vector<double> run_task(const std::string& task, const std::vector<double>& inputs) {
  if (task == "mean") return {mean(inputs)};
  if (task != "root") throw std::invalid_argument("no task " + task);
  std::vector<double> roots;
  for (const double input : inputs) roots.push_back(root(input));
  return roots;
}
