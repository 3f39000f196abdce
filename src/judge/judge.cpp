// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge/judge.hpp"

#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <stdexcept>

#include "judge/student_program.hpp"

namespace judge {
namespace {

using Options = std::map<std::string, std::string>;  // each has a value

// Returns what determines the numbers of the checks.
std::string origin_of(const Options& options) {
  if (options.count("--salt") == 0) {
    return options.count("--student") == 0 ? "" : options.at("--student");
  }
  std::ifstream file(options.at("--salt"));
  return {std::istreambuf_iterator<char>(file), {}};
}

Outcome outcome_of(const Check& check, StudentProgram& program, const std::string& origin) {
  try {
    return check.outcome([&](const std::string& task,
                             const Numbers& inputs) { return program.answer(task, inputs); },
                         origin);
  } catch (const NoAnswer& e) {
    return {0, e.what()};
  }
}

int run_checks(const std::vector<Exercise>& exercises, Options options,
               const std::vector<std::string>& command) {
  const double unlimited = 1e9;
  StudentProgram program(
      command, options.count("--seconds") == 0 ? unlimited : std::stod(options["--seconds"]));
  const std::string origin = origin_of(options);
  int n_checks = 0;
  bool all_hold = true;
  for (const Exercise& exercise : exercises) {
    const bool is_hidden = options.count("--salt") == 1;
    for (const Check& check : is_hidden ? exercise.hidden_checks : exercise.public_checks) {
      if (exercise.id != options["--exercise"] && check.id != options["--check"]) continue;
      const auto [share, message] = outcome_of(check, program, origin);
      std::printf("%s\t%.17g\t%s\n", check.id.c_str(), share, message.c_str());
      ++n_checks;
      all_hold = all_hold && share == 1;
    }
  }
  if (n_checks == 0 && options.count("--check") == 1) {
    throw std::invalid_argument("there is no such check");
  }
  return all_hold ? 0 : 1;
}

}  // namespace

int run(int argc, char** argv, const std::vector<Exercise>& exercises,
        std::string (*numbers)(const std::string& student)) {
  try {
    Options options;
    char** word = argv + 1;
    for (; argv + argc - word > 1 && std::string(*word) != "--"; word += 2)
      options[word[0]] = word[1];
    if (options.count("--numbers") == 1) {
      std::cout << numbers(options["--numbers"]);
      return 0;
    }
    if (argv + argc - word < 2) throw std::invalid_argument("no program after --");
    return run_checks(exercises, options, {word + 1, argv + argc});
  } catch (const std::exception& e) {
    std::cerr << "judge: " << e.what() << '\n';
    return 3;
  }
}

}  // namespace judge
