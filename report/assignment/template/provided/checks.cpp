// SPDX-License-Identifier: GPL-3.0-or-later
// build/checks --check ID -- build/assignment runs one public check; ctest runs all of them.
// build/checks --numbers YOUR-ID prints your numbers.
// EACH EXERCISE: #include "assignment/exercises/@id@_checks.hpp"
#include "judge/judge.hpp"

int main(int argc, char** argv) {
  using namespace assignment;
  const std::vector<judge::Exercise> exercises = {
      // EACH EXERCISE: {"@id@", @id@::public_checks(), {}},
  };
  return judge::run(argc, argv, exercises, lines_of_numbers);
}
