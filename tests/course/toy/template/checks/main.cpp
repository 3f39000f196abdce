#include <iostream>

#include "tasks.hpp"
#include "toy_checks.hpp"
#include "variant_of_this_handout.hpp"

int main() {
  // BEGIN HIDDEN TESTS: only-teachers-try-this
  std::cout << "the mean of one number is " << run_task("mean", {7.25}).at(0) << '\n';
  // END HIDDEN TESTS
  for (const auto& [id, check] : toy::public_checks()) {
    const course::Outcome outcome = check(run_task, this_variant);
    std::cout << 100 * outcome.share << " % " << id << ' ' << outcome.message << '\n';
  }
}
