// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of this assignment, with public and hidden checks. The judge in the handout has only
// the public checks: report/assignment/template/provided/checks.cpp.
#include "exercise_list.hpp"
#include "judge/judge.hpp"

int main(int argc, char** argv) {
  using namespace assignment;
  const auto exercises = [](const std::string& student, const std::string& salt) {
    const OwnNumbers own = own_numbers(student);
    const OwnNumbers secret = own_numbers(salt);
    std::vector<judge::Exercise> list;
    for (const ListedExercise& exercise : listed_exercises) {
      list.push_back({exercise.id, bound(exercise.public_checks(), own),
                      bound(exercise.hidden_checks(), secret)});
    }
    return list;
  };
  const auto numbers = [](const std::string& student) { return lines_of(own_numbers(student)); };
  return judge::run(argc, argv, {exercises, numbers});
}
