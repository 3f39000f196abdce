#include <iomanip>
#include <iostream>

#include "tasks.hpp"

int main(int argc, char** argv) {
  std::vector<double> inputs;
  for (double input = 0; std::cin >> input;) inputs.push_back(input);
  std::cout << std::setprecision(17);
  for (const double number : run_task(argc > 1 ? argv[1] : "", inputs)) std::cout << number << '\n';
}
