// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge/judge.hpp"

#include <cmath>
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

struct Options {
  std::map<std::string, std::string> values;  ///< by option; empty for an option without a value
  std::vector<std::string> program;           ///< the words after --

  bool has(const std::string& name) const { return values.count(name) == 1; }
  std::string value(const std::string& name) const { return has(name) ? values.at(name) : ""; }
};

Options read_options(const std::vector<std::string>& words) {
  Options options;
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (*word == "--") {
      options.program.assign(word + 1, words.end());
      break;
    }
    const bool has_value = word + 1 != words.end() && (word + 1)->rfind("--", 0) != 0;
    options.values[*word] = has_value ? *(word + 1) : "";
    if (has_value) ++word;
  }
  return options;
}

std::string salt_of(const Options& options) {
  if (!options.has("--salt-file")) return "";
  std::ifstream file(options.value("--salt-file"));
  std::string salt{std::istreambuf_iterator<char>(file), {}};
  if (salt.empty()) throw std::invalid_argument("--salt-file: the file is missing or empty");
  return salt;
}

StudentProgram program_of(const Options& options) {
  if (options.program.empty()) throw std::invalid_argument("no program after --");
  const double unlimited = 1e9;
  return {options.program,
          options.has("--allowance") ? std::stod(options.value("--allowance")) : unlimited};
}

Outcome outcome_of(const Check& check, StudentProgram& program) {
  try {
    return check.outcome([&](const std::string& task, const Numbers& inputs) {
      return program.answer(task, inputs);
    });
  } catch (const NoAnswer& e) {
    return {0, e.what()};
  }
}

int run_check(const std::vector<Exercise>& exercises, const Options& options) {
  for (const Exercise& exercise : exercises) {
    for (const Check& check : exercise.public_checks) {
      if (check.id != options.value("--check")) continue;
      StudentProgram program = program_of(options);
      const auto [share, message] = outcome_of(check, program);
      if (share == 1) return 0;
      std::cout << check.id << ": " << std::floor(100 * share) << " % of this check holds; "
                << message << '\n';
      return 1;
    }
  }
  throw std::invalid_argument("no public check is named " + options.value("--check"));
}

void run_exercise(const std::vector<Exercise>& exercises, const Options& options) {
  StudentProgram program = program_of(options);
  for (const Exercise& exercise : exercises) {
    if (exercise.id != options.value("--exercise")) continue;
    const bool is_hidden = options.has("--hidden");
    for (const Check& check : is_hidden ? exercise.hidden_checks : exercise.public_checks) {
      const auto [share, message] = outcome_of(check, program);
      std::printf("%s\t%.17g\t%s\n", check.id.c_str(), share, message.c_str());
    }
  }
  std::printf("used\t%.3f\t%d\n", program.used_seconds(), program.n_answers());
}

}  // namespace

int run(int argc, char** argv, const Assignment& assignment) {
  try {
    const Options options = read_options({argv + 1, argv + argc});
    const std::string student = options.value("--student");
    const std::vector<Exercise> exercises = assignment.exercises(student, salt_of(options));
    if (options.has("--check")) return run_check(exercises, options);
    if (options.has("--numbers")) {
      std::cout << assignment.numbers(student);
    } else {
      run_exercise(exercises, options);
    }
    return 0;
  } catch (const std::exception& e) {
    std::cerr << "judge: " << e.what() << '\n';
    return 3;
  }
}

}  // namespace judge
