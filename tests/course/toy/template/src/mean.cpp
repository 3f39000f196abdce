#include "exercise.hpp"

double mean(const std::vector<double>& numbers) {
  // BEGIN SOLUTION
  // STUB: (void)numbers;
  // STUB: return 0;
  double sum = 0;
  for (const double number : numbers) sum += number;
  return sum / static_cast<double>(numbers.size());
  // END SOLUTION
}
