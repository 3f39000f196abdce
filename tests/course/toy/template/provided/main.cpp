#include <iomanip>
#include <iostream>
#include <string>

#include "tasks.hpp"

int main(int argc, char** argv) {
  std::vector<double> inputs;
  for (std::string word; std::cin >> word;) {
    if (word == ";") {
      run_task(argc > 1 ? argv[1] : "", inputs);
      inputs.clear();
    } else {
      inputs.push_back(std::stod(word));
    }
  }
  std::cout << std::setprecision(17);
  for (const double number : run_task(argc > 1 ? argv[1] : "", inputs)) std::cout << number << '\n';
}
